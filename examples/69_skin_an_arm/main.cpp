// Skin an arm: weights of bones from heat, and two ways of blending their transforms, side by side: matrices, which shrink where a bone twists, and dual
// quaternions, which do not.
#include <concino/deform.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>
#include <concino/skeleton/tube.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  // An upper arm, a lower arm and a hand. The skin is a smooth tube around them.
  const cn::skeleton bones({{0, 0, 0}, {3, 0, 0}, {6, 0, 0}, {7.2, 0, 0}}, {{cn::vert_id{0}, cn::vert_id{1}}, {cn::vert_id{1}, cn::vert_id{2}}, {cn::vert_id{2}, cn::vert_id{3}}});
  std::vector<cn::vec3> along;
  std::vector<double> radii;
  std::vector<std::array<cn::vert_id, 2>> pieces;
  for (unsigned i = 0; i <= 24; ++i) {
    const double x = 7.2 * i / 24;
    along.push_back({x, 0, 0});
    radii.push_back(0.75 - 0.05 * x + 0.12 * std::sin(2 * x));
    if (i > 0) pieces.push_back({cn::vert_id{i - 1}, cn::vert_id{i}});
  }
  const cn::quadmesh skin = cn::subdivide_catmull_clark(cn::tube(cn::skeleton(along, pieces, radii)));
  fmt::print("{} verts, {} bones\n", cn::num_verts(skin), cn::num_edges(bones));

  // Heat flows from each bone to the skin near it. Weights are 0 or more, and 1 in sum.
  const auto weights = cn::heat_weights(skin, bones).weights.at_most(2);
  double worst = 0;
  for (const auto v : cn::verts(skin)) {
    double sum = 0;
    for (const double w : weights.weights(v.raw())) sum += w;
    worst = std::max(worst, std::abs(sum - 1));
  }
  fmt::print("the sums of weights are 1: {}\n", worst < 1e-14);

  // The elbow bends, and the hand twists.
  const auto pose = [&](double elbow, double twist) {
    const auto lower = cn::rotation({3, 0, 0}, {0, 1, 0}, -elbow);
    return std::array<cn::affine_map, 3>{cn::affine_map(), lower, lower * cn::rotation({6, 0, 0}, {1, 0, 0}, twist)};
  };
  // How thin the wrist becomes: the least distance from the lower arm's axis near the joint, at rest and twisted.
  const auto thinnest = [&](const auto& points) {
    double least = 1e9;
    for (const auto v : cn::verts(skin))
      if (std::abs(cn::point(skin, v).x - 6) < 0.4) least = std::min(least, std::hypot(points[v].y, points[v].z));
    return least;
  };
  auto rest = cn::make_vert_map<cn::vec3>(skin);
  for (const auto v : cn::verts(skin)) rest[v] = cn::point(skin, v);
  const auto twisted_linear = cn::skin(skin, weights, pose(0, 2.8), cn::linear_blend), twisted = cn::skin(skin, weights, pose(0, 2.8), cn::dual_quaternions);
  fmt::print("radius of the wrist: {:.2f} at rest; twisted {:.2f} by linear blending, {:.2f} by dual quaternions\n", thinnest(rest), thinnest(twisted_linear), thinnest(twisted));

  if (argc > 1) {
    auto of_bone = cn::make_vert_map<cn::rgb>(skin);
    for (const auto v : cn::verts(skin)) {
      std::size_t largest = 0;
      for (std::size_t b = 1; b < 3; ++b)
        if (weights.weight(v.raw(), b) > weights.weight(v.raw(), largest)) largest = b;
      of_bone[v] = cn::label_color(largest);
    }
    std::vector<cn::image> pictures;
    const auto draw = [&](const auto& points) {
      cn::scene s;
      s.add(cn::with_points(skin, points), {.colors = of_bone, .edges = true});
      pictures.push_back(cn::render(s, {.width = 330, .height = 240, .camera = cn::view_options{.towards = {0.1, 1, -0.2}, .up = {0, 0, 1}}, .samples = 3, .ground = false}));
    };
    draw(cn::skin(skin, weights, pose(2, 2.8), cn::linear_blend));
    draw(cn::skin(skin, weights, pose(2, 2.8), cn::dual_quaternions));
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"linear blending", "dual quaternions"}}), argv[1]);
  }
}
