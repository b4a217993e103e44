// UV maps: a part of a surface of pentagons and hexagons becomes a part of the plane. A checkerboard shows at a glance what a map does to it, and colours say
// how much it changes angles and areas. A closed surface is cut open first. With the name of a file the picture is larger.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/parametrize.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

namespace cn = concino;

std::size_t width = 70;  // of each picture, in pixels
std::vector<cn::image> squares, angles, areas;

cn::image draw(const cn::scene& s, const cn::view& from) {
  return cn::render(s, {.width = width, .height = width, .camera = from, .samples = 2, .occlusion_rays = 16, .ground = false});
}

/// Prints the distortion of a map, and draws it: squares and angles on the surface, areas in the plane.
template<class M, class U>
void show(const char* name, const M& m, const U& uv) {
  const auto d = cn::map_distortion(m, uv);
  fmt::print("{:<19} {} flipped, angles change by {:5.1f} degrees at most, areas by {:.2f} to {:.2f}, lengths by {:5.2f}\n", name, d.flipped,
             d.max_angle * 180 / 3.14159265, d.min_area, d.max_area, d.max_stretch);
  auto plane = cn::make_vert_map<cn::vec3>(m);
  for (const auto v : cn::verts(m)) plane[v] = {uv[v][0], uv[v][1], 0};
  auto area = cn::make_poly_map<double>(m);
  for (const auto p : cn::polys(m)) area[p] = std::log2(d.area[p]);  // 1: twice as large as others, -1: half
  const auto checkerboard = cn::texture::checkerboard(8 / std::sqrt(d.scale));
  const auto scale = cn::value_scale::linear(-2, 2), from_zero = cn::value_scale::linear(0, 1);
  squares.push_back(draw(cn::scene().add(m, {.texture = checkerboard, .texture_coordinates = uv}), cn::camera::three_quarter));
  angles.push_back(draw(cn::scene().add(m, {.field = d.angle, .map = cn::colormap::viridis, .scale = from_zero}), cn::camera::three_quarter));
  cn::scene s;
  s.add(cn::with_points(m, plane), {.field = area, .map = cn::colormap::cool_warm, .scale = scale, .edges = true, .edge_width = 0.7});
  areas.push_back(draw(s, cn::camera::from_front));
}

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "uv_maps.png";
  if (argc > 1) width = 88;

  // A ball with bumps. Its part above a plane is a disk: one boundary loop, no handles.
  auto ball = cn::dual_mesh(cn::icosphere(3));
  for (const auto v : cn::verts(ball)) {
    const cn::vec3 x = cn::point(ball, v);
    cn::set_point(ball, v, (1 + 0.25 * std::sin(3 * x.x + 1) * std::cos(4 * x.z)) * x);
  }
  const auto dome = cn::submesh(ball, [&](cn::poly_id p) { return cn::centroid(ball, p).y > -0.3; });
  fmt::print("{} polys, {} boundary loop\n", cn::num_polys(dome), cn::boundary_loops(dome).count);

  // No flips, whatever the surface; the boundary is a circle.
  show("tutte", dome, cn::tutte(dome).uv);
  // The best angles: by two fixed verts, and by none.
  show("lscm", dome, cn::lscm(dome));
  show("spectral_conformal", dome, cn::spectral_conformal(dome));
  // Angles and areas together.
  const auto rigid = cn::arap_map(dome);
  show("arap_map", dome, rigid.uv);
  // The same, and no poly is flipped, nor nearly.
  const auto injective = cn::injective_map(dome);
  show("injective_map", dome, injective.uv);
  fmt::print("the energy of arap_map falls from {:.3f} to {:.3f}, that of injective_map from {:.1f} to {:.3f}\n", rigid.energies.front(), rigid.energies.back(),
             injective.energies.front(), injective.energies.back());

  // A closed surface is refused. The message says what to do.
  auto torus = cn::make_torus<cn::quadmesh>({.cells = {40, 20}});
  try {
    cn::lscm(torus);
  } catch (const cn::invalid_mesh& e) {
    fmt::print("{}\n", e.what());
  }

  // Cut open, it is a disk. Verts at the seams have several texture coordinates, so these belong to corners. They are drawn, measured and saved.
  const auto cut = cn::cut_along(torus, cn::homology_generators(torus));
  const cn::quadmesh open(cut.surface);
  const auto uv = cn::injective_map(open).uv;
  const auto at_corners = cn::uv_at_corners(torus, cut.polys, open, uv);
  fmt::print("torus, at corners: {} flipped\n", cn::map_distortion(torus, at_corners).flipped);
  show("torus, cut open", open, uv);
  const auto texture = cn::corner_property<cn::uv_point>(torus, "texture");
  for (const auto p : cn::polys(torus))
    for (std::uint32_t k = 0; k < 4; ++k) texture[{p, k}] = at_corners[{p, k}];
  cn::save(torus, "torus.obj");
  const auto again = cn::load<cn::quadmesh>("torus.obj");
  fmt::print("saved and loaded, with texture coordinates: {}\n", static_cast<bool>(cn::find_corner_property<cn::uv_point>(again, "texture")));

  std::vector<cn::image> sheet;
  for (const auto* row : {&squares, &angles, &areas}) sheet.insert(sheet.end(), row->begin(), row->end());
  const std::vector<std::string> captions{"tutte", "lscm", "spectral", "arap", "injective", "injective, cut open"};
  cn::save_png(cn::make_sheet(sheet, {.columns = 6, .captions = captions}), path);
}
