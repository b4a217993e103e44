// Measures heat geodesics with the library's own factorisation. Their preparation is compared with the necessary factorisations: two, or three with a boundary.
// A query is compared with as many back-substitutions. `clamped` includes bounds by shortest paths, `query` does not. On a million triangles both are by
// multigrid, and compared with the set-up and with 30 cycles of the solve that a query contains; their number is printed.
#include "support/matrix_keeper.hpp"
#include "support/kinds.hpp"

#include <concino/fields.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/multigrid.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using sparse = Eigen::SparseMatrix<double>;
using factors = Eigen::SimplicialLDLT<sparse>;

template<class M>
void measure(const bench::program& p, const std::string& name, const M& m) {
  const std::string prepare = "heat.prepare." + name, query = "heat.query." + name;
  std::vector<sparse> matrices;
  const auto heat = concino::prepare_heat_geodesics(m, {}, bench::matrix_keeper(&matrices));
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
  compare_with_substitutions("heat.clamped." + name, concino::prepare_heat_geodesics(m, {.clamp = true}, concino::ldlt{}));
}

/// Multigrid that stores the last matrix and right-hand side, and counts cycles.
struct multigrid_keeper : concino::multigrid {
  struct record {
    sparse matrix;
    Eigen::VectorXd load;
    int solves = 0, cycles = 0;
  };
  record* kept;

  explicit multigrid_keeper(record* where) : multigrid({.tolerance = 1e-6}), kept(where) {}
  multigrid_keeper(const multigrid_keeper& k) : multigrid(k.options()), kept(k.kept) {}
  void factorize(const sparse& a) {
    kept->matrix = a;
    multigrid::factorize(a);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    kept->load = b;
    Eigen::VectorXd x = multigrid::solve(b);
    ++kept->solves;
    kept->cycles += iterations();
    return x;
  }
};

/// Preparation and query by multigrid. The bound of a query is 30 cycles.
void measure_iterative(const bench::program& p, const std::string& name, const concino::trimesh& m) {
  const std::string prepare = "heat.prepare." + name, query = "heat.query." + name;
  multigrid_keeper::record kept;
  const auto heat = concino::prepare_heat_geodesics(m, {}, multigrid_keeper(&kept));
  const sparse matrix = kept.matrix;
  const concino::vert_id source{7};
  kept.solves = kept.cycles = 0;
  heat.distance_from(source);
  std::fprintf(stderr, "%s: %d solves, %d cycles\n", query.c_str(), kept.solves, kept.cycles);
  if (kept.cycles > 30) throw std::runtime_error(query + ": more than 30 cycles");
  concino::multigrid solver({.tolerance = 1e-6});
  const int rounds = std::min(p.rounds, 3);
  if (p.wants(prepare))
    p.print(bench::compare(prepare, rounds,
                           {{"setup", [&] { return bench::seconds_of([&] {
                               solver.factorize(matrix);
                               return 0;
                             }); }},
                            {"concino", [&] { return bench::seconds_of([&] { return concino::prepare_heat_geodesics(m, {}, concino::multigrid({.tolerance = 1e-6})); }); }}}));
  if (!p.wants(query)) return;
  solver.factorize(matrix);
  const Eigen::VectorXd load = kept.load;
  p.print(bench::compare(query, rounds,
                         {{"thirty_cycles", [&] { const double s = bench::seconds_of([&] { return solver.solve(load); });
                             return 30 * s / std::max(solver.iterations(), 1); }},
                          {"concino", [&] { return bench::seconds_of([&] { return heat.distance_from(source); }); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto wants = [&](const std::string& name) { return p.wants("heat.prepare." + name) || p.wants("heat.query." + name); };
    if (wants("bunny")) measure(p, "bunny", concino::trimesh(p.data.bunny()));
    if (wants("bunny16")) measure(p, "bunny16", concino::trimesh(p.data.bunny16()));
    if (wants("tri1m")) measure_iterative(p, "tri1m", concino::trimesh(p.data.tri1m()));
    if (wants("sphere1m")) measure_iterative(p, "sphere1m", concino::make_sphere<concino::trimesh>({.cells = p.data.tiny ? 8u : 288u}));
    if (wants("tet25k")) measure(p, "tet25k", concino::tetmesh(bench::tet_grid(p.data.tiny ? 3 : 16)));
    if (wants("hex8k")) measure(p, "hex8k", concino::hexmesh(bench::hex_grid(p.data.tiny ? 3 : 20)));
  });
}
