// Bend a bar of polyhedra by its ends, as rigid as possible: the system is factorised once, and each step starts from the last one, as when a user drags a handle.
#include <concino/deform.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <numbers>
#include <utility>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  const auto bar = cn::dual_mesh(cn::make_grid<cn::tetmesh>({.cells = {18, 4, 4}, .max = {5, 1, 1}}));
  fmt::print("{} polyhedra, {} verts\n", cn::num_polys(bar), cn::num_verts(bar));

  // The handles are the verts of both ends.
  std::vector<cn::vert_id> handles;
  for (const auto v : cn::verts(bar))
    if (cn::point(bar, v).x < 0.15 || cn::point(bar, v).x > 4.85) handles.push_back(v);
  const auto arap = cn::prepare_deform(bar, handles);
  fmt::print("{} handles\n", handles.size());

  // One end stays. The other one is moved by a rigid motion.
  const auto ends = [&](const cn::affine_map& motion) {
    std::vector<std::pair<cn::vert_id, cn::vec3>> positions;
    for (const auto v : handles) {
      const auto p = cn::point(bar, v);
      positions.push_back({v, p.x > 2.5 ? motion(p) : p});
    }
    return positions;
  };
  const auto inverted = [&](const auto& points) {
    const auto there = cn::with_points(bar, points);
    std::size_t n = 0;
    for (const auto p : cn::polys(there)) n += cn::volume(there, p) <= 0;
    return n;
  };

  // A rigid motion of both ends would cost nothing; bending by a right angle costs some energy, which falls in each iteration.
  const auto bent = arap.with_positions(ends(cn::translation({-1.2, 0, 1.2}) * cn::rotation({4, 0, 0.5}, {0, 1, 0}, -std::numbers::pi / 2)));
  bool falls = true;
  for (std::size_t i = 1; i < bent.energies.size(); ++i) falls = falls && bent.energies[i] <= bent.energies[i - 1];
  fmt::print("bent: the energy falls: {}, from {:.1f} to {:.1f}; {} inverted polyhedra\n", falls, bent.energies.front(), bent.energies.back(), inverted(bent.points));

  // Half a turn, in steps of 30 degrees.
  auto twisted = arap.with_positions(ends(cn::affine_map()));
  for (int step = 1; step <= 6; ++step)
    twisted = arap.with_positions_from(twisted.points, ends(cn::rotation({0, 0.5, 0.5}, {1, 0, 0}, step * std::numbers::pi / 6)));
  fmt::print("twisted by half a turn: energy {:.1f}, {} inverted polyhedra\n", twisted.energies.back(), inverted(twisted.points));

  // The same handles, and one linear solve: a smooth displacement. It does not rotate what is between them, and shrinks it.
  const auto smooth = cn::biharmonic_deform(bar, ends(cn::rotation({0, 0.5, 0.5}, {1, 0, 0}, std::numbers::pi)));
  const auto share = [&](const auto& points) { return cn::total_measure(cn::with_points(bar, points)) / cn::total_measure(bar); };
  fmt::print("volume: {:.2f} of that at rest, by a smooth displacement {:.2f}\n", share(twisted.points), share(smooth));

  if (argc > 1) {
    auto height = cn::make_poly_map<double>(bar);
    for (const auto p : cn::polys(bar)) height[p] = cn::centroid(bar, p).x;
    auto rest = cn::make_vert_map<cn::vec3>(bar);
    for (const auto v : cn::verts(bar)) rest[v] = cn::point(bar, v);
    std::vector<cn::image> pictures;
    const auto draw = [&](const auto& points) {
      cn::scene s;
      s.add(cn::with_points(bar, points), {.field = height, .edges = true});
      pictures.push_back(cn::render(s, {.width = 190, .height = 145, .camera = cn::view_options{.towards = {0.3, 1, -0.35}, .up = {0, 0, 1}}, .samples = 3, .ground = false}));
    };
    draw(rest);
    draw(bent.points);
    draw(twisted.points);
    draw(smooth);
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"at rest", "bent", "twisted by half a turn", "the same, biharmonic"}}), argv[1]);
  }
}
