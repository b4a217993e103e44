// A cross field on a surface with two handles, as smooth as possible: four directions at each vert, which follow the curvature. They cannot agree everywhere:
// some polys are singular, and the sum of their indices is fixed. Directions with given singular verts are the second picture.
#include <concino/directions.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

/// The surface with one direction of each element after the other, and balls at singularities: red where the index is positive, blue where it is negative.
template<class M, class Field>
cn::image draw(const M& m, const std::vector<Field>& directions, const std::vector<std::pair<cn::vec3, int>>& singular) {
  cn::scene s;
  s.add(m, {.color = cn::srgb(0.93f, 0.9f, 0.84f)});
  for (const Field& d : directions) s.add_arrows(m, d, {.scale = 0.45, .equal_lengths = true, .count = 220, .radius = 0.02, .heads = false});
  for (const auto& [x, index] : singular)
    s.add_points(std::vector<cn::vec3>{x}, {.radius = 0.09, .color = index > 0 ? cn::srgb(0.84f, 0.13f, 0.14f) : cn::srgb(0.1f, 0.3f, 0.8f)});
  return cn::render(s, {.width = 176, .height = 108, .camera = cn::view_options{.towards = {0, -0.5, 1}, .up = {0, 1, 0}}, .samples = 3, .occlusion_rays = 0, .ground = false});
}

cn::vert_id nearest(const cn::quadmesh& m, const cn::vec3& x) {
  cn::vert_id best{0};
  for (const auto v : cn::verts(m))
    if (cn::distance(cn::point(m, v), x) < cn::distance(cn::point(m, best), x)) best = v;
  return best;
}

int main(int argc, char** argv) {
  // A board with two holes, of quads, made round.
  const auto block = cn::make_grid<cn::hexmesh>({.cells = {5, 3, 1}, .max = {5, 3, 1}});
  const auto board = cn::submesh(block, [&](cn::poly_id p) { const auto c = cn::centroid(block, p); return !(c.y > 1 && c.y < 2 && ((c.x > 1 && c.x < 2) || (c.x > 3 && c.x < 4))); });
  const cn::quadmesh m = cn::subdivide_catmull_clark(cn::boundary_surface(board), {.times = 3});
  const int chi = static_cast<int>(cn::num_verts(m)) - static_cast<int>(cn::num_edges(m)) + static_cast<int>(cn::num_polys(m));
  fmt::print("{} quads, Euler characteristic {}\n", cn::num_polys(m), chi);

  // Indices are in quarters of a turn. They sum to 4 times the Euler characteristic.
  const auto f = cn::direction_field(m, {.symmetry = 4, .align_with_curvature = 1});
  std::map<int, int> count;
  int sum = 0;
  std::vector<std::pair<cn::vec3, int>> singular;
  for (const auto& s : cn::singularities(f)) {
    ++count[s.index];
    sum += s.index;
    singular.emplace_back(cn::centroid(m, s.element), s.index);
  }
  for (const auto& [index, n] : count) fmt::print("{} singularities of index {}\n", n, index);
  fmt::print("sum of the indices: {}\n", sum);

  // The same number of turns, in two verts only. Indices that sum to something else are refused.
  const cn::vert_id a = nearest(m, {0.5, 1.5, 1}), b = nearest(m, {2.5, 1.5, 1});
  const auto w = cn::trivial_connection(m, {{a, -4}, {b, -4}}, {.symmetry = 4});
  for (const auto& s : cn::singularities(w)) fmt::print("given: vert {}, index {}, an error below 1e-10: {}\n", s.element.raw(), s.index, std::abs(w.index(s.element) - s.index) < 1e-10);
  try {
    cn::trivial_connection(m, {{a, -4}}, {.symmetry = 4});
  } catch (const cn::invalid_argument& e) {
    fmt::print("{}\n", e.what());
  }

  // A file has one of the four directions of each vert.
  cn::save_rosy(f, "crosses.rosy");
  const auto r = cn::load_rosy("crosses.rosy");
  fmt::print("saved and loaded: {} vectors of symmetry {}\n", r.vectors.size(), r.symmetry);

  if (argc > 1) {
    std::vector<cn::vert_map<cn::quadmesh, cn::vec3>> at_verts;
    std::vector<cn::poly_map<cn::quadmesh, cn::vec3>> at_polys;
    for (int k = 0; k < 4; ++k) {
      at_verts.push_back(cn::make_vert_map<cn::vec3>(m));
      for (const auto v : cn::verts(m)) at_verts.back()[v] = f.direction(v, k);
      at_polys.push_back(cn::make_poly_map<cn::vec3>(m));
      for (const auto p : cn::polys(m)) at_polys.back()[p] = w.direction(p, k);
    }
    const std::vector<cn::image> pictures{draw(m, at_verts, singular), draw(m, at_polys, {{cn::point(m, a), -4}, {cn::point(m, b), -4}})};
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"smoothest, along curvature", "two given ones"}}), argv[1]);
  }
}
