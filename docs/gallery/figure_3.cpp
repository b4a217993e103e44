// Figure 3: level sets on a surface and in a volume. Close up, they are edges and faces of the mesh.   figure_3 picture.png [width] [--pages]
#include "figure.hpp"

#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <cmath>
#include <vector>

namespace cn = concino;

double height(const cn::vec3& x) { return x.z + 0.25 * std::sin(4 * x.x) * std::cos(3 * x.y); }

template<class M>
auto heights_at_verts(M& m) {
  const auto u = cn::vert_property<double>(m, "u");
  for (const auto v : cn::verts(m)) u[v] = height(cn::point(m, v));
  return u;
}

int main(int argc, char** argv) {
  figure f(argc, argv, 2);
  const auto draw = [&](const cn::scene& s, const char* caption, const cn::view& camera) { f.add(s, caption, {.camera = camera, .up = {0, 0, 1}}); };
  const auto close_up = cn::perspective_camera({0.9, -2.6, 1.3}, {0.35, -0.9, 0.3}, {0, 0, 1}, 22);
  const std::vector<double> levels{-0.9, -0.6, -0.3, 0, 0.3, 0.6, 0.9};

  auto surface = cn::icosphere(3);
  const auto u = heights_at_verts(surface);
  cn::scene lines;
  lines.add(surface, {.field = u, .edges = true, .edge_width = 0.5, .inspect = true});
  draw(lines.add_lines(cn::isolines(surface, u, levels), {.radius = 0.012, .color = cn::srgb(1, 1, 1)}), "level sets of a surface", {});
  for (const double level : levels) cn::embed_isolines(surface, "u", level, {.snap = 0.1});
  draw(cn::scene().add(surface, {.field = u, .edges = true, .inspect = true}), "embedded, close up", close_up);

  auto volume = cn::make_sphere<cn::tetmesh>({.cells = 7});
  const auto w = heights_at_verts(volume);
  cn::scene surfaces;
  surfaces.add(volume, {.field = w, .opacity = 0.2});
  for (const double level : levels) {
    const auto s = cn::isosurface<cn::trimesh>(volume, w, level);
    surfaces.add(s.mesh, {.color = cn::colormap::blue_to_yellow((level + 1) / 2)});
  }
  draw(surfaces, "level sets in a volume", {});
  cn::embed_isosurface(volume, "u", 0, {.snap = 0.1});
  auto side = cn::make_poly_map<int>(volume);
  for (const auto p : cn::polys(volume)) side[p] = height(cn::centroid(volume, p)) < 0;
  draw(cn::scene().add(volume, {.labels = side, .edges = true, .visible = cn::below('x', 0.2), .inspect = true}), "one embedded, and cut", {});

  f.save();
}
