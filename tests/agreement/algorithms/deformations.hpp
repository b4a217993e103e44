// Compares meshes in a bent cage, and those that bend by handles.
#pragma once

#include <agreement/algorithms/sizes.hpp>

#include <concino/deform/cage_coordinates.hpp>
#include <concino/deform/laplacian_deform.hpp>
#include <concino/deform/prepare_deform.hpp>
#include <concino/deform/skin.hpp>
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
    for (const rigid_cells rigidity : {rigid_cells::spokes, rigid_cells::spokes_and_rims}) {
      const auto x = prepare_deform(n, handles, {.rigidity = rigidity}).with_positions(positions, {.max_iterations = 3, .tolerance = 0});
      const auto y = prepare_deform(m, same_handles, {.rigidity = rigidity}).with_positions(same, {.max_iterations = 3, .tolerance = 0});
      expect(x.energies.size() == y.energies.size(), "the iterations");
      for (const auto v : both.verts.all) expect_close(x.points[v], y.points[both.verts.to(v)], largest, "the points by handles");
    }
    // all other verts are handles too, so that flat parts are determined
    std::vector<std::pair<vert_t<typename B::native_mesh>, vec3>> others;
    std::vector<std::pair<vert_t<typename B::other_mesh>, vec3>> same_others;
    for (const auto v : both.verts.all) {
      if (index_of(n, v) % 5 == 0) continue;
      const vec3 x = point(n, v) + vec3{0, 0, 0.01 * size * static_cast<double>(index_of(n, v) % 4)};
      others.push_back({v, x}), same_others.push_back({both.verts.to(v), x});
    }
    const auto edit = [](const auto& mesh, const auto& where, auto& points) {
      try {
        points = laplacian_deform(mesh, where);
        return true;
      } catch (const solver_error&) {  // a component with handles on a line
        return false;
      }
    };
    auto edited = make_vert_map<vec3>(n);
    auto same_edited = make_vert_map<vec3>(m);
    const bool has_points = edit(n, others, edited);
    expect(has_points == edit(m, same_others, same_edited), "whether handles determine the points");
    if (has_points)  // the condition of the system is that of the Laplacian, squared
      for (const auto v : both.verts.all) expect_close(edited[v], same_edited[both.verts.to(v)], 100 * largest, "the points that keep details");
    // two bones, with weights that depend on the vert
    std::vector<skin_weight> weights, same_weights;
    for (const auto v : both.verts.all)
      for (const std::size_t bone : {0u, 1u}) {
        const double weight = 1 + static_cast<double>((index_of(n, v) + bone) % 3);
        weights.push_back({index_of(n, v), bone, weight}), same_weights.push_back({index_of(m, both.verts.to(v)), bone, weight});
      }
    const std::vector<affine_map> bend{affine_map(), rotation(all.min, {1, 2, 3}, 1)};
    const auto bent_here = skin(n, {vert_index_bound(n), 2, weights}, bend, dual_quaternions);
    const auto bent_there = skin(m, {vert_index_bound(m), 2, same_weights}, bend, dual_quaternions);
    for (const auto v : both.verts.all) expect_close(bent_here[v], bent_there[both.verts.to(v)], largest, "the points by bones");
    return true;
  }
};

}  // namespace concino::agreement
