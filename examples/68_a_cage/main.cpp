// Bend a shape by a cage: a coarse surface around it, whose few verts are moved. Three kinds of coordinates say where the shape goes.
#include <concino/deform.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  // A ring that stands in a cage of quads, of three storeys.
  cn::quadmesh shape = cn::make_torus<cn::quadmesh>({.cells = {48, 24}});
  for (const auto v : cn::verts(shape)) {
    const auto p = cn::point(shape, v);
    cn::set_point(shape, v, cn::vec3{p.x, p.z, 1.6 * p.y});
  }
  double high = 0;
  for (const auto v : cn::verts(shape)) high = std::max(high, cn::point(shape, v).z);
  const double h = 1.1 * high;
  const cn::quadmesh cage = cn::make_box<cn::quadmesh>({.cells = {1, 1, 3}, .min = {-h, -0.8, -h}, .max = {h, 0.8, h}});
  fmt::print("the shape has {} verts, the cage {}\n", cn::num_verts(shape), cn::num_verts(cage));

  // The weights are computed once. The cage where it was gives the shape where it was.
  const auto weights = cn::cage_coordinates(cage, shape);
  const auto same = weights.points_of(cage);
  double error = 0;
  for (const auto v : cn::verts(shape)) error = std::max(error, cn::distance(same[v], cn::point(shape, v)));
  fmt::print("the cage at rest reproduces the shape: {}\n", error < 1e-12);

  // The upper part of the cage turns about the vertical axis and leans over.
  cn::quadmesh bent = cage;
  for (const auto v : cn::verts(cage)) {
    const auto p = cn::point(cage, v);
    const double up = (p.z + h) / (2 * h);
    cn::set_point(bent, v, cn::rotation({0, 0, 0}, {0, 0, 1}, 1.2 * up)(p) + cn::vec3{1.2 * up * up, 0, 0});
  }
  const auto moved = weights.points_of(bent);

  // Green coordinates use the normals of a cage of triangles too, and keep angles better.
  const auto triangles = cn::to_triangles(cage);
  auto bent_triangles = triangles;  // its verts are those of the cage
  for (const auto v : cn::verts(cage)) cn::set_point(bent_triangles, v, cn::point(bent, v));
  const auto green = cn::green_coordinates(triangles, shape).points_of(bent_triangles);

  // Harmonic coordinates know the inside of the cage: they are computed on a volume that fills it.
  const auto volume = cn::make_box<cn::hexmesh>({.cells = {6, 4, 12}, .min = {-h, -0.8, -h}, .max = {h, 0.8, h}});
  const auto harmonic = cn::harmonic_coordinates(volume, cage);
  fmt::print("harmonic coordinates of {} verts of a volume: {} are negative\n", cn::num_verts(volume), harmonic.num_negative);

  // How far angles of quads are from right ones, on average.
  const auto skew = [&](const auto& points) {
    double sum = 0;
    const auto there = cn::with_points(shape, points);
    for (const auto p : cn::polys(shape)) {
      std::vector<cn::vec3> x;
      for (const auto v : cn::adj_p2v(there, p)) x.push_back(cn::point(there, v));
      const auto a = x[1] - x[0], b = x[3] - x[0];
      sum += std::abs(cn::dot(a, b)) / (cn::norm(a) * cn::norm(b));
    }
    return sum / static_cast<double>(cn::num_polys(shape));
  };
  fmt::print("mean cosine of the angles: {:.3f} by mean values, {:.3f} by Green coordinates\n", skew(moved), skew(green));

  if (argc > 1) {
    auto rest = cn::make_vert_map<cn::vec3>(shape);
    for (const auto v : cn::verts(shape)) rest[v] = cn::point(shape, v);
    std::vector<cn::image> pictures;
    const auto draw = [&](const auto& points, const cn::quadmesh& around) {
      cn::scene s;
      s.add(cn::with_points(shape, points), {.edges = true});
      s.add_graph(around, {.radius = 0.02, .color = cn::srgb(0.85f, 0.35f, 0.1f)});
      pictures.push_back(cn::render(s, {.width = 150, .height = 205, .camera = cn::view_options{.towards = {0.5, 1, -0.3}, .up = {0, 0, 1}}, .samples = 3, .ground = false}));
    };
    draw(rest, cage);
    draw(moved, bent);
    draw(green, bent);
    cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = {"at rest", "mean values", "Green coordinates"}}), argv[1]);
  }
}
