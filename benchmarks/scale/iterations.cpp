// Iterations of PETSc's and hypre's multigrid for harmonic maps with values on the whole boundary: hexes and polyhedra that are uniform, graded or stretched,
// of 10^4, 10^5 and 10^6 unknowns. Options of PETSc follow the prefixes gamg_ and boomeramg_, such as -gamg_pc_gamg_threshold 0.02.
#include <concino/adapters/petsc.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/generate/grade.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

cn::hexmesh hexes(double unknowns) {
  const auto n = static_cast<std::size_t>(std::lround(std::cbrt(unknowns))) + 1;
  return cn::make_grid<cn::hexmesh>({.cells = {n, n, n}});
}

/// Voronoi cells of random sites that have moved to the centroids of their cells. There are 6.3 to 6.6 unknown verts per cell.
cn::polyhedralmesh polyhedra(double unknowns) {
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  const auto sites = cn::random_points(static_cast<std::size_t>(unknowns / 6.4), cube);
  return cn::voronoi_polyhedra(sites, cube, {.relax = 3});
}

struct shape {
  const char* name;
  cn::vec3 powers, factors;
};
const shape shapes[] = {{"uniform", {1, 1, 1}, {1, 1, 1}}, {"graded", {2, 2, 2}, {1, 1, 1}}, {"stretched x 10", {1, 1, 1}, {10, 1, 1}}, {"stretched x 100", {1, 1, 1}, {100, 1, 1}}};

template<class M>
void solve(const char* kind, const shape& s, M m) {
  cn::grade(m, s.powers);
  std::vector<std::pair<cn::vert_t<M>, double>> values;
  for (const auto v : cn::verts(m)) {
    const cn::vec3 p = cn::point(m, v);
    if (cn::is_boundary(m, v)) values.emplace_back(v, std::cos(3 * p.x) + p.y * p.y - p.z);
    cn::set_point(m, v, cn::vec3{s.factors.x * p.x, s.factors.y * p.y, s.factors.z * p.z});
  }
  std::printf("| %s | %s | %zu |", kind, s.name, cn::num_verts(m) - values.size());
  for (const auto& [prefix, preconditioner] :
       {std::pair{"gamg_", cn::petsc_preconditioner::gamg}, std::pair{"boomeramg_", cn::petsc_preconditioner::boomeramg}}) {
    cn::petsc solver({.prefix = prefix, .preconditioner = preconditioner, .tolerance = 1e-10, .max_iterations = 500, .accept_missed_tolerance = true});
    const auto begin = std::chrono::steady_clock::now();
    cn::harmonic_map(m, values, {}, solver);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::printf(" %d%s | %.1e | %.1f |", solver.iterations(), solver.has_converged() ? "" : " (missed)", solver.residual(), seconds);
    std::fflush(stdout);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);
  std::vector<double> sizes = {1e4, 1e5, 1e6};
  std::string only;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--tiny") == 0) sizes = {300};
    if (std::strcmp(argv[i], "--unknowns") == 0 && i + 1 < argc) sizes = {std::atof(argv[++i])};
    if (std::strcmp(argv[i], "--only") == 0 && i + 1 < argc) only = argv[++i];
  }
  std::printf("| mesh | shape | unknowns | GAMG: iterations | residual | seconds | BoomerAMG: iterations | residual | seconds |\n|---|---|---|---|---|---|---|---|---|\n");
  try {
    for (const shape& s : shapes)
      for (const double unknowns : sizes) {
        if (("hexes " + std::string(s.name)).find(only) != std::string::npos) solve("hexes", s, hexes(unknowns));
        if (("polyhedra " + std::string(s.name)).find(only) != std::string::npos) solve("polyhedra", s, polyhedra(unknowns));
      }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
}
