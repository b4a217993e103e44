// Compute eigenvalues of the Laplacian of a surface and of a solid. Their square roots are the tones of the shape, and say much about it. But two drums of
// different shape can have the same tones: here two of seven triangles each, mirrored at their sides by different recipes (Gordon, Webb, Wolpert 1992).
#include <concino/adapters/spectra.hpp>
#include <concino/generate.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/render/sheet.hpp>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace cn = concino;

struct mirrored {
  std::size_t from, to, corner;  // the triangle `to` is `from` mirrored at the side opposite to this corner
};

cn::trimesh drum(const std::array<mirrored, 6>& recipe) {
  const int n = 6;
  std::array<std::array<cn::vec3, 3>, 7> triangle;
  triangle[0] = {cn::vec3{0, 0, 0}, cn::vec3{1.25, 0, 0}, cn::vec3{0.5, 0.8, 0}};  // of area 0.5
  for (const auto [from, to, k] : recipe) {
    triangle[to] = triangle[from];
    const cn::vec3 a = triangle[from][(k + 1) % 3], side = triangle[from][(k + 2) % 3] - a, x = triangle[from][k] - a;
    triangle[to][k] = a + 2 * cn::dot(x, side) / cn::dot(side, side) * side - x;
  }
  cn::surface_arrays r{{}, {}, {}, 3};
  std::map<std::pair<long, long>, unsigned> known;
  for (const auto& t : triangle) {
    const auto add = [&](int i, int j) {
      const cn::vec3 x = t[0] + (i * (t[1] - t[0]) + j * (t[2] - t[0])) / n;
      const auto [it, is_new] = known.try_emplace({std::lround(1e6 * x.x), std::lround(1e6 * x.y)}, static_cast<unsigned>(r.points.size()));
      if (is_new) r.points.push_back(x);
      r.verts.push_back(cn::vert_id{it->second});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add(i, j), add(i + 1, j), add(i, j + 1);
        if (i + j + 2 <= n) add(i + 1, j), add(i + 1, j + 1), add(i, j + 1);
      }
  }
  return cn::trimesh(r);
}

int main(int argc, char** argv) {
  const auto ball = cn::make_sphere<cn::polygonmesh>({.cells = 10});
  fmt::print("sphere of {} polygons:      ", cn::num_polys(ball));
  for (const double x : cn::eigenfunctions(ball, 9).values) fmt::print(" {:.1f}", std::abs(x));
  fmt::print("\n  known, l (l + 1):            0.0 2.0 2.0 2.0 6.0 6.0 6.0 6.0 6.0\n");

  // A box of Voronoi cells. Two of its side lengths follow from the eigenvalues.
  const cn::box domain{{0, 0, 0}, {3, 2, 1.2}};
  const auto solid = cn::voronoi_polyhedra(cn::random_points(250, domain), domain);
  const auto tones = cn::eigenfunctions(solid, 5, {.lumped = false});
  fmt::print("box of {} polyhedra:         ", cn::num_polys(solid));
  for (const double x : tones.values) fmt::print(" {:.1f}", std::abs(x));
  fmt::print("\n  known, pi^2 (i^2/9 + j^2/4): 0.0 1.1 2.5 3.6 4.4\n");
  fmt::print("  sides found: {:.1f} and {:.1f}\n", std::numbers::pi / std::sqrt(tones.values[1]), std::numbers::pi / std::sqrt(tones.values[2]));

  const auto one = drum({{{0, 1, 0}, {0, 2, 1}, {0, 4, 2}, {2, 5, 0}, {4, 3, 1}, {1, 6, 2}}});
  const auto two = drum({{{0, 4, 0}, {0, 1, 1}, {0, 2, 2}, {2, 3, 0}, {4, 6, 1}, {1, 5, 2}}});
  std::vector<cn::image> pictures;
  for (const auto* m : {&one, &two}) {
    fmt::print("drum of area {:.1f}:", cn::total_measure(*m));
    for (const double x : cn::eigenfunctions(*m, 6).values) fmt::print(" {:.4f}", std::abs(x));
    double spread = 0;  // the moment of inertia about the centroid tells the drums apart
    const auto mass = cn::vert_masses(*m);
    cn::vec3 middle;
    for (const auto v : cn::verts(*m)) middle += mass[v] / 3.5 * cn::point(*m, v);
    for (const auto v : cn::verts(*m)) spread += mass[v] * std::pow(cn::distance(cn::point(*m, v), middle), 2);
    fmt::print(", but moment of inertia {:.2f}\n", spread);
    if (argc > 1) {
      const auto functions = cn::eigenfunctions(*m, 3).functions;
      pictures.push_back(cn::render(cn::scene().add(*m, {.field = functions[2], .map = cn::colormap::cool_warm, .isolines = 12}), {.width = 220, .height = 200, .camera = cn::camera::from_front}));
    }
  }

  // A picture, if the program is given the name of a file: a function of each drum, of the same tone.
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 2}), argv[1]);
}
