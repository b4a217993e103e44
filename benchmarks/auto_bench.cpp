// Measures the choice of auto_solver between ldlt and multigrid, for one and for thirty right-hand sides, against both. `best` is the better of both for that
// number.
#include "support/kinds.hpp"
#include "support/laplace_system.hpp"

#include <concino/solve/auto_solver.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/multigrid.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using sparse = Eigen::SparseMatrix<double>;

Eigen::VectorXd right_hand_side(Eigen::Index size, int number) {
  Eigen::VectorXd b(size);
  for (Eigen::Index i = 0; i < size; ++i) b[i] = static_cast<double>((i + number) * 7919 % 101) - 50;
  return b;
}

template<class Solver>
double seconds(Solver&& solver, const sparse& a, int questions) {
  return bench::seconds_of([&] {
    solver.factorize(a);
    for (int i = 1; i < questions; ++i) solver.solve(right_hand_side(a.cols(), i));
    return solver.solve(right_hand_side(a.cols(), 0));
  });
}

/// make(): a mesh.
template<class Make>
void compare(const bench::program& p, const std::string& kind, const Make& make) {
  const std::string work = "auto." + kind;
  if (!p.wants(work + ".1") && !p.wants(work + ".30")) return;
  const sparse a = bench::laplace_system(make());
  const int rounds = a.nonZeros() > 100'000 ? 1 : std::min(p.rounds, 3);
  std::vector<double> one[3], thirty[3];
  for (int round = 0; round < rounds; ++round) {
    concino::ldlt direct;
    concino::multigrid iteration;
    const double factorize[] = {bench::seconds_of([&] { return direct.factorize(a), 0; }), bench::seconds_of([&] { return iteration.factorize(a), 0; })};
    const Eigen::VectorXd b = right_hand_side(a.cols(), 0);
    const double solve[] = {bench::seconds_of([&] { return direct.solve(b); }), bench::seconds_of([&] { return iteration.solve(b); })};
    for (int k : {0, 1}) {
      one[k].push_back(factorize[k] + solve[k]);
      thirty[k].push_back(factorize[k] + 30 * solve[k]);
    }
    concino::auto_solver single, many{{.questions = 30}};
    one[2].push_back(seconds(single, a, 1));
    thirty[2].push_back(seconds(many, a, 30));
  }
  const auto print = [&](const std::string& name, const std::vector<double>(&times)[3]) {
    if (!p.wants(name)) return;
    const double direct = bench::median(times[0]), iteration = bench::median(times[1]), ours = bench::median(times[2]), best = std::min(direct, iteration);
    p.print({{name, "ldlt", "s", direct, ours / direct}, {name, "multigrid", "s", iteration, ours / iteration}, {name, "best", "s", best, ours / best},
             {name, "concino", "s", ours, 1}});
  };
  print(work + ".1", one);
  print(work + ".30", thirty);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const bool tiny = p.data.tiny;
    const auto triangles = [&](bench::u32 rows, bench::u32 columns) { return [=] { return concino::trimesh(tiny ? bench::torus(4, 5) : bench::torus(rows, columns)); }; };
    const auto tets = [&](bench::u32 n) { return [=] { return concino::tetmesh(bench::tet_grid(tiny ? 3 : n)); }; };
    const auto hexes = [&](bench::u32 n) { return [=] { return concino::hexmesh(bench::hex_grid(tiny ? 4 : n)); }; };
    compare(p, "tri20k", triangles(80, 125));
    compare(p, "tri60k", triangles(160, 188));
    compare(p, "tube400k", triangles(20, 10'000));
    compare(p, "bunny16", [&] { return concino::trimesh(p.data.bunny16()); });
    compare(p, "tri1m", [&] { return concino::trimesh(p.data.tri1m()); });
    compare(p, "quad343k", [&] { return concino::quadmesh(p.data.quad343k()); });
    compare(p, "poly228k", [&] { return concino::polygonmesh(p.data.poly228k()); });
    compare(p, "tet25k", tets(16));
    compare(p, "tet105k", tets(26));
    compare(p, "hex8k", hexes(20));
    compare(p, "hex27k", hexes(30));
    compare(p, "dual25k", [&] { return concino::polyhedralmesh(bench::dual_polyhedra(tiny ? 3 : 16)); });
  });
}
