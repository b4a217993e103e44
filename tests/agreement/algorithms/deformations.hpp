// Compares meshes in a bent cage, and those that bend by handles.
#pragma once

#include <agreement/algorithms/sizes.hpp>

#include <concino/deform/cage_coordinates.hpp>
#include <concino/deform/prepare_deform.hpp>
#include <concino/generate/icosphere.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::agreement {

struct deformations {
  static constexpr const char* name = "deform";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const box all = bounding_box(n);
    if (both.polys.all.empty() || all.is_empty() || !(norm(all.max - all.min) > 0)) return false;
    const double size = norm(all.max - all.min), largest = largest_in(all) + 2 * size;
    trimesh cage = icosphere(1);
    for (const auto v : verts(cage)) set_point(cage, v, 0.5 * (all.min + all.max) + size * point(cage, v));
    trimesh bent = cage;
    for (const auto v : verts(bent)) set_point(bent, v, point(cage, v) + vec3{0, 0.1 * size * (v.raw() % 3), 0});
    const auto here = cage_coordinates(cage, n).points_of(bent);
    const auto there = cage_coordinates(cage, m).points_of(bent);
    for (const auto v : both.verts.all) expect_close(here[v], there[both.verts.to(v)], largest, "the points in a bent cage");
    // every second vert is a handle, and those next to it, so that each component has one
    std::vector<std::pair<vert_t<typename B::native_mesh>, vec3>> positions;
    std::vector<std::pair<vert_t<typename B::other_mesh>, vec3>> same;
    std::vector<vert_t<typename B::native_mesh>> handles;
    std::vector<vert_t<typename B::other_mesh>> same_handles;
    for (const auto v : both.verts.all) {
      bool is_smallest = true;
      for (const auto w : adj_v2v(n, v)) is_smallest = is_smallest && index_of(n, w) > index_of(n, v);
      if (!is_smallest) continue;
      const vec3 x = point(n, v) + vec3{0, 0, 0.01 * size * static_cast<double>(index_of(n, v) % 4)};
      positions.push_back({v, x}), same.push_back({both.verts.to(v), x});
      handles.push_back(v), same_handles.push_back(both.verts.to(v));
    }
    const auto x = prepare_deform(n, handles).with_positions(positions, {.max_iterations = 3, .tolerance = 0});
    const auto y = prepare_deform(m, same_handles).with_positions(same, {.max_iterations = 3, .tolerance = 0});
    expect(x.energies.size() == y.energies.size(), "the iterations");
    for (const auto v : both.verts.all) expect_close(x.points[v], y.points[both.verts.to(v)], largest, "the points by handles");
    return true;
  }
};

}  // namespace concino::agreement
