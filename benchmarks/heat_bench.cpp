// Measures heat geodesics with the library's own factorisation. Their preparation is compared with the necessary factorisations: two, or three with a boundary.
// A query is compared with as many back-substitutions. `query` includes bounds by shortest paths, `unclamped` does not.
#include "support/kinds.hpp"

#include <concino/fields.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using sparse = Eigen::SparseMatrix<double>;
using factors = Eigen::SimplicialLDLT<sparse>;

/// A solver that stores the matrices that it is asked to factorise.
struct matrix_keeper {
  std::vector<sparse>* kept;
  concino::ldlt inner;

  explicit matrix_keeper(std::vector<sparse>* where) : kept(where) {}
  matrix_keeper(const matrix_keeper& k) : kept(k.kept) {}
  void factorize(const sparse& a) {
    kept->push_back(a);
    inner.factorize(a);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return inner.solve(b); }
};

template<class M>
void measure(const bench::program& p, const std::string& name, const M& m) {
  const std::string prepare = "heat.prepare." + name, query = "heat.query." + name;
  std::vector<sparse> matrices;
  const auto heat = concino::prepare_heat_geodesics(m, {}, matrix_keeper(&matrices));
  const std::size_t count = concino::VolumeMesh<M> ? 3 : 2;  // the surfaces are closed
  if (matrices.size() != count)
    throw std::runtime_error(prepare + ": " + std::to_string(matrices.size()) + " factorisations, not " + std::to_string(count));
  const concino::vert_id source{0};
  const auto d = heat.distance_from(source);
  for (const auto e : concino::edges(m)) {  // the distances at the ends of an edge differ by at most 3 of its lengths
    const auto ends = concino::adj_e2v(m, e);
    auto it = ends.begin();
    const concino::vert_id a = *it, b = *++it;
    if (!(std::abs(d[a] - d[b]) <= 3 * concino::edge_length(m, e))) throw std::runtime_error(query + ": distances jump along an edge");
  }
  const int rounds = std::min(p.rounds, 3);
  if (p.wants(prepare))
    p.print(bench::compare(prepare, rounds,
                           {{"factorisations", [&] {
                               return bench::seconds_of([&] {
                                 std::vector<std::unique_ptr<factors>> all;
                                 for (const sparse& a : matrices) all.push_back(std::make_unique<factors>(a));
                                 return all;
                               });
                             }},
                            {"concino", [&] { return bench::seconds_of([&] { return concino::prepare_heat_geodesics(m, {}, concino::ldlt{}); }); }}}));
  if (!p.wants(query)) return;
  std::vector<std::unique_ptr<factors>> all;
  for (const sparse& a : matrices) all.push_back(std::make_unique<factors>(a));
  Eigen::VectorXd load = Eigen::VectorXd::Zero(matrices[0].cols());
  load[0] = 1;
  const auto compare_with_substitutions = [&](const std::string& work, const auto& asked) {
    p.print(bench::compare(work, p.rounds,
                           {{"substitutions", [&] {
                               return bench::seconds_of([&] {
                                 Eigen::VectorXd u = load;
                                 for (const auto& one : all) u = one->solve(u).eval();
                                 return u;
                               });
                             }},
                            {"concino", [&] { return bench::seconds_of([&] { return asked.distance_from(source); }); }}}));
  };
  compare_with_substitutions(query, heat);
  compare_with_substitutions("heat.unclamped." + name, concino::prepare_heat_geodesics(m, {.clamp = false}, concino::ldlt{}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto wants = [&](const std::string& name) { return p.wants("heat.prepare." + name) || p.wants("heat.query." + name); };
    if (wants("bunny")) measure(p, "bunny", concino::trimesh(p.data.bunny()));
    if (wants("bunny16")) measure(p, "bunny16", concino::trimesh(p.data.bunny16()));
    if (wants("tet25k")) measure(p, "tet25k", concino::tetmesh(bench::tet_grid(p.data.tiny ? 3 : 16)));
    if (wants("hex8k")) measure(p, "hex8k", concino::hexmesh(bench::hex_grid(p.data.tiny ? 3 : 20)));
  });
}
