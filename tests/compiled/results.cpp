// Prints numbers to the last bit. The header-only program and the one that links the compiled library must print the same.
#include <concino/convert/convert.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cstdio>
#include <string>

namespace cn = concino;

namespace {

/// n x n quads in the unit square, with one corner raised.
cn::quadmesh grid(unsigned n) {
  std::vector<cn::vec3> points;
  std::vector<std::vector<unsigned>> polys;
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) points.push_back({i / double(n), j / double(n), i * j / double(n * n * n)});
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const unsigned a = j * (n + 1) + i;
      polys.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return cn::quadmesh(points, polys);
}

template<class M, class D = cn::virtual_elements_t>
void print_map(const char* what, const M& m, const cn::harmonic_map_options& options = {}, const D& discretisation = {}) {
  cn::auto_solver solver;
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{3}, 1.0}}, discretisation, options, solver);
  std::printf("%s, solver %d\n", what, static_cast<int>(solver.used()));
  for (const cn::vert_id v : cn::verts(m)) std::printf("%a\n", u[v]);
}

template<class F>
void print_error(const F& f) {
  try {
    f();
    std::puts("no error");
  } catch (const cn::error& e) {
    std::puts(e.what());
  }
}

template<class M>
void print_file(const std::string& folder, const char* name, const M& m) {
  const std::string path = folder + "/" + name;
  cn::save(m, path);
  const auto read = cn::load<M>(path);
  std::printf("%s: %zu verts, %zu polys\n", name, static_cast<std::size_t>(cn::num_verts(read)), static_cast<std::size_t>(cn::num_polys(read)));
  for (const cn::vert_id v : cn::verts(read)) {
    const auto p = cn::point(read, v);
    std::printf("%a %a %a\n", p[0], p[1], p[2]);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string folder = argv[1];
  const cn::tetmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}});
  const cn::polygonmesh house({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 3, 0.5}, {0, 2, 0}, {3, 1, 0}}, {{0, 1, 2, 3, 4}, {1, 5, 2}});
  const cn::quadmesh quads = grid(12);
  print_map("quads", quads);
  print_map("house", house);
  print_map("tets", tet);
  print_map("hexes", cn::hexmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1.5}, {0, 1, 1}}, {{0, 1, 2, 3, 4, 5, 6, 7}}));
  print_map("polyhedra", cn::convert<cn::polyhedralmesh>(tet));
  print_map("triangles", cn::trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}, {2, 1, 1}}, {{0, 1, 2}, {2, 1, 3}, {1, 4, 3}}));
  print_map("uniform", house, {}, cn::uniform);
  print_map("biharmonic", house, {.exponent = 2});
  cn::auto_solver iterating({.max_factor_entries = 0});
  const auto u = cn::harmonic_map(quads, {{cn::vert_id{0}, 0.0}, {cn::vert_id{3}, 1.0}}, {}, iterating);
  std::printf("%d: %a\n", iterating.iterations(), u[cn::vert_id{40}]);
  print_file(folder, "house.obj", house);
  print_file(folder, "quads.off", quads);
  print_file(folder, "tet.mesh", tet);
  print_file(folder, "tet.meshb", tet);
  print_file(folder, "tet.tet", tet);
  print_file(folder, "tet.hybrid", tet);
  print_file(folder, "tet.hedra", cn::convert<cn::polyhedralmesh>(tet));
  print_error([] { cn::trimesh({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}); });
  print_error([&] { cn::load<cn::trimesh>(folder + "/quads.off"); });
  print_error([&] { cn::load<cn::trimesh>(folder + "/absent.off"); });
  print_error([&] { cn::harmonic_map(house, {{cn::vert_id{0}, 0.0}}, {.exponent = 0}); });
  print_error([&] { cn::harmonic_map(house, {}); });
}
