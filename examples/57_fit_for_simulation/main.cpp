// Is my polygon mesh fit for simulation? Metrics of polygons find the bad ones, and circles, kernels and widths say what is wrong with them. In the picture, pale
// polygons have a small circle ratio; the circles inside and around the worst one are red and grey, and kernels are blue.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

namespace cn = concino;
using cn::metric;

/// What a solver wants to know about a mesh: how many polygons are not acceptable, and the worst.
void report(const char* title, const cn::polygonmesh& m) {
  fmt::print("{}: {} polygons\n", title, cn::num_polys(m));
  for (const metric what : {metric::circle_ratio, metric::kernel_ratio, metric::area_perimeter_ratio, metric::edge_ratio}) {
    const auto h = cn::histogram(m, what, {.bins = 1, .low = 0, .high = 1});
    const auto w = cn::worst(m, what);
    fmt::print("  {:<20} {:2} are not acceptable; the worst is poly {:2} with {:.3f}\n", cn::name_of(what), h.unacceptable, w.poly.raw(), w.value);
  }
}

/// A circle as a closed line.
std::vector<cn::vec3> line_of(const cn::vec3& centre, double radius) {
  std::vector<cn::vec3> line;
  for (int i = 0; i < 60; ++i) line.push_back(centre + radius * cn::vec3{std::cos(i * M_PI / 30), std::sin(i * M_PI / 30), 0});
  return line;
}

int main(int argc, char** argv) {
  // Polygons as agglomeration makes them: unions of triangles with random shapes.
  auto triangles = cn::make_grid<cn::trimesh>({.cells = {10, 10}});
  cn::jitter(triangles, 0.2);
  const cn::polygonmesh m = cn::agglomerate(triangles, cn::random_labels(triangles, 8));
  report("agglomerated", m);

  // What is wrong with the worst one? The largest circle inside is certified: none is larger than max_radius.
  const cn::poly_id bad = cn::worst(m, metric::circle_ratio).poly;
  const auto inside = cn::inscribed_circle(m, bad);
  const auto around = cn::enclosing_circle(m, bad);
  const auto k = cn::kernel(m, bad);
  const auto w = cn::width(m, bad);
  fmt::print("poly {} has {} corners: a circle of radius {:.4f} fits inside, and none above {:.4f}; it needs one of {:.4f} around, and is {:.4f} wide\n", bad.raw(),
             cn::num_elements(cn::adj_p2v(m, bad)), inside.radius, inside.max_radius, around.radius, w.width);
  fmt::print("all of it is visible from {}\n", k.is_empty() ? std::string("no point") : fmt::format("an area of {:.5f}, such as ({:.3f}, {:.3f})", k.area, k.witness.x, k.witness.y));

  // Polygons from which nothing is visible have no kernel. Virtual elements work on them, but lose accuracy; Voronoi polygons are convex.
  std::size_t empty = 0;
  for (const auto p : cn::polys(m)) empty += cn::kernel(m, p).is_empty();
  fmt::print("{} of {} polygons have no kernel\n", empty, cn::num_polys(m));
  const auto ball = cn::enclosing_ball(m);
  fmt::print("the mesh is in a ball of radius {:.4f} around ({:.3f}, {:.3f})\n", ball.radius, ball.centre.x, ball.centre.y);

  // The same number of Voronoi polygons, at random points in the square.
  const cn::box square{{0, 0, 0}, {1, 1, 0}};
  const cn::polygonmesh voronoi = cn::voronoi_polygons(cn::random_points(24, square), square);
  report("Voronoi", voronoi);

  if (argc > 1) {
    std::vector<cn::image> pictures;
    for (const cn::polygonmesh* mesh : {&m, &voronoi}) {
      cn::scene s;
      auto color = cn::make_poly_map<cn::rgb>(*mesh);
      std::vector<std::vector<cn::vec3>> kernels;
      const auto ratio = cn::quality(*mesh, metric::circle_ratio);
      for (const auto p : cn::polys(*mesh)) {
        const auto shade = static_cast<float>(0.5 + 0.5 * (1 - ratio[p]));
        color[p] = cn::srgb(shade, shade, 0.55f);
        if (const auto found = cn::kernel(*mesh, p); !found.is_empty()) kernels.push_back(found.corners);
      }
      s.add(*mesh, {.colors = color, .edges = true, .edge_width = 1.2});
      s.add_lines(kernels, {.radius = 0.003, .color = cn::srgb(0.1f, 0.3f, 0.9f), .closed = true});
      const auto p = cn::worst(*mesh, metric::circle_ratio).poly;
      const auto c = cn::inscribed_circle(*mesh, p);
      const auto d = cn::enclosing_circle(*mesh, p);
      s.add_lines(line_of(c.centre, c.radius), {.radius = 0.005, .color = cn::srgb(0.9f, 0.1f, 0.1f), .closed = true});
      s.add_lines(line_of(d.centre, d.radius), {.radius = 0.005, .color = cn::srgb(0.3f, 0.3f, 0.3f), .closed = true});
      pictures.push_back(cn::render(s, {.width = 210, .height = 210, .camera = cn::view_options{.towards = {0, 0, -1}, .up = {0, 1, 0}}, .samples = 4, .ground = false}));
    }
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"agglomerated", "Voronoi"}}), argv[1]);
  }
}
