// Compares exact_geodesics and their paths on surfaces whose polys are all triangles.
#pragma once

#include <agreement/algorithms/virtual_elements.hpp>

#include <concino/fields/exact_geodesics.hpp>

namespace concino::agreement {

struct straight_distances {
  static constexpr const char* name = "exact_geodesics";
  static constexpr bool needs_a_shape = true;
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    if (!all_polys_have_measure(both.native)) return false;
    for (const auto p : both.polys.all) {
      std::size_t corners = 0;
      for ([[maybe_unused]] const auto v : adj_p2v(both.native, p)) ++corners;
      if (corners != 3) return false;
    }
    const auto here = prepare_exact_geodesics(both.native);
    const auto there = prepare_exact_geodesics(both.other);
    const auto v = both.verts.all.front();
    const auto paths = here.paths_from(v);
    const auto their_paths = there.paths_from(both.verts.to(v));
    const auto from_poly = here.distance_from(both.polys.all.back(), centroid(both.native, both.polys.all.back()));
    const auto theirs_from_poly = there.distance_from(both.polys.to(both.polys.all.back()), centroid(both.native, both.polys.all.back()));
    const double far = largest_of(both.verts.all, [&](const auto w) { return paths.distances()[w]; });
    const double far_from_poly = largest_of(both.verts.all, [&](const auto w) { return from_poly[w]; });
    for (const auto w : both.verts.all) {
      const auto& to = both.verts.to(w);
      expect_close(paths.distances()[w], their_paths.distances()[to], far, "the distance");
      expect_close(paths.path_to(w).length, their_paths.path_to(to).length, far, "the length of a path");
      expect_close(from_poly[w], theirs_from_poly[to], far_from_poly, "the distance from a point of a poly");
    }
    return true;
  }
};

}  // namespace concino::agreement
