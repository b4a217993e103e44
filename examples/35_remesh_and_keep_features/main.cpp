// Remesh a surface to triangles of about equal edges, and keep its sharp edges. A drawing program has made the input, a knob of a door: long thin triangles between
// circles, good for pictures and bad for simulations. The circles where the knob has edges remain; everything else gets new triangles.
#include <concino/edit.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>
#include <concino/remesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/render/sheet.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace cn = concino;

/// Turns a profile of (radius, height) around the z axis, in n steps. It begins and ends on the axis.
cn::trimesh turned(const std::vector<std::array<double, 2>>& profile, unsigned n) {
  std::vector<cn::vec3> points{{0, 0, profile.front()[1]}};
  for (std::size_t k = 1; k + 1 < profile.size(); ++k)
    for (unsigned i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      points.push_back({profile[k][0] * std::cos(angle), profile[k][0] * std::sin(angle), profile[k][1]});
    }
  points.push_back({0, 0, profile.back()[1]});
  const unsigned last = static_cast<unsigned>(points.size()) - 1, rings = static_cast<unsigned>(profile.size()) - 2;
  const auto at = [n](unsigned ring, unsigned i) { return 1 + ring * n + i % n; };
  std::vector<std::array<unsigned, 3>> triangles;
  for (unsigned i = 0; i < n; ++i) {
    triangles.push_back({0, at(0, i), at(0, i + 1)});
    for (unsigned k = 0; k + 1 < rings; ++k) {
      triangles.push_back({at(k, i), at(k + 1, i), at(k + 1, i + 1)});
      triangles.push_back({at(k, i), at(k + 1, i + 1), at(k, i + 1)});
    }
    triangles.push_back({at(rings - 1, i), last, at(rings - 1, i + 1)});
  }
  return cn::trimesh(points, triangles);
}

/// Of the edges at which the surface turns by more than 40 degrees: their total length.
double length_of_sharp_edges(const cn::trimesh& m) {
  double sum = 0;
  for (const auto e : cn::edges(m)) {
    std::vector<cn::vec3> normals;
    for (const auto p : cn::adj_e2p(m, e)) normals.push_back(cn::normal(m, p));
    if (normals.size() == 2 && cn::dot(normals[0], normals[1]) < std::cos(40 * std::numbers::pi / 180)) sum += cn::edge_length(m, e);
  }
  return sum;
}

void report(const char* what, const cn::trimesh& m) {
  fmt::print("{:<18}{:6} triangles, least scaled Jacobian {:.2f}, sharp edges of length {:.2f}\n", what, cn::num_polys(m), cn::worst(m, cn::metric::scaled_jacobian).value,
             length_of_sharp_edges(m));
}

int main(int argc, char** argv) {
  // a plate, a neck, and a round head
  std::vector<std::array<double, 2>> profile{{0, 0}, {1, 0}, {1, 0.2}, {0.3, 0.2}};
  for (int k = 0; k <= 12; ++k) {
    const double angle = -1.091 + k * (std::numbers::pi / 2 + 1.091) / 12;
    profile.push_back({0.65 * std::cos(angle), 1.45 + 0.65 * std::sin(angle)});
  }
  profile.back()[0] = 0;
  const auto knob = turned(profile, 48);
  report("input", knob);

  // One length everywhere. The error says how far the result and the input are apart.
  auto m = knob;
  const auto r = cn::remesh(m, {.edge_length = 0.07, .feature_angle_deg = 40});
  report("edges of 0.07", m);
  fmt::print("  {:.0f} % of the lengths off sharp edges are within a factor of 4/3; error below {:.3f}\n", std::floor(100 * r.share_of_lengths), std::ceil(1000 * r.error) / 1000);

  // Without features the edges of the plate become ragged.
  auto ragged = knob;
  cn::remesh(ragged, {.edge_length = 0.07, .feature_angle_deg = 180});
  report("without features", ragged);

  // Lengths by curvature: long edges on the plate, short ones on the neck.
  auto adapted = knob;
  const auto sizes = cn::adaptive_size(adapted, {.chord_error = 0.005, .min_length = 0.03, .max_length = 0.25});
  cn::remesh(adapted, sizes);
  report("by curvature", adapted);

  // Or lengths of your own: short edges where you look at the result, here near the axis.
  auto near_axis = cn::make_vert_map<double>(knob, 0.0);
  for (const auto v : cn::verts(knob)) near_axis[v] = std::max(0.03, 0.15 * std::hypot(cn::point(knob, v).x, cn::point(knob, v).y));
  auto mine = knob;
  cn::remesh(mine, near_axis);
  report("near the axis", mine);

  // A picture, if the program is given the name of a file.
  if (argc > 1) {
    std::vector<cn::image> pictures;
    for (const auto* x : std::initializer_list<const cn::trimesh*>{&knob, &m, &ragged, &adapted})
      pictures.push_back(cn::render(cn::scene().add(*x, {.edges = true, .edge_width = 1, .crease_angle = 40}), {.width = 210, .height = 210, .up = {0, 0, 1}}));
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"input", "edges of 0.07", "without features", "by curvature"}}), argv[1]);
  }
}
