// Heat geodesics by the library's own solver: preparing them beside the two factorisations that they cannot do without, and one question beside the
// two back-substitutions.
#include "support/kinds.hpp"

#include <concino/fields.hpp>

#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using sparse = Eigen::SparseMatrix<double>;
using factors = Eigen::SimplicialLDLT<sparse>;

/// Keeps the matrices that are factorised.
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

void measure(const bench::program& p, const std::string& name, const concino::surface_arrays& arrays) {
  const std::string prepare = "heat.prepare." + name, query = "heat.query." + name;
  const concino::trimesh m(arrays);
  std::vector<sparse> matrices;
  const auto heat = concino::heat_geodesics(m, {}, matrix_keeper(&matrices));
  if (matrices.size() != 2) throw std::runtime_error(prepare + ": " + std::to_string(matrices.size()) + " factorisations on a closed surface, not 2");
  const concino::vert_id source{0};
  const auto d = heat.distance_from(source);
  for (const auto e : concino::edges(m)) {  // lengths: no edge is passed in less than nothing or in more than about its length
    const auto ends = concino::adj_e2v(m, e);
    auto it = ends.begin();
    const concino::vert_id a = *it, b = *++it;
    if (!(std::abs(d[a] - d[b]) <= 3 * concino::edge_length(m, e))) throw std::runtime_error(query + ": distances are no lengths");
  }
  const int rounds = std::min(p.rounds, 3);
  if (p.wants(prepare))
    p.print(bench::compare(prepare, rounds,
                           {{"factorisations", [&] {
                               return bench::seconds_of([&] {
                                 auto both = std::make_unique<std::array<factors, 2>>();
                                 for (std::size_t k = 0; k < 2; ++k) (*both)[k].compute(matrices[k]);
                                 return both;
                               });
                             }},
                            {"concino", [&] { return bench::seconds_of([&] { return concino::heat_geodesics(m); }); }}}));
  if (!p.wants(query)) return;
  std::array<factors, 2> both;
  for (std::size_t k = 0; k < 2; ++k) both[k].compute(matrices[k]);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(matrices[0].cols());
  load[0] = 1;
  p.print(bench::compare(query, p.rounds,
                         {{"substitutions", [&] {
                             return bench::seconds_of([&] {
                               const Eigen::VectorXd u = both[0].solve(load);
                               return Eigen::VectorXd(both[1].solve(u));
                             });
                           }},
                          {"concino", [&] { return bench::seconds_of([&] { return heat.distance_from(source); }); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("heat.prepare.bunny") || p.wants("heat.query.bunny")) measure(p, "bunny", p.data.bunny());
    if (p.wants("heat.prepare.bunny16") || p.wants("heat.query.bunny16")) measure(p, "bunny16", p.data.bunny16());
  });
}
