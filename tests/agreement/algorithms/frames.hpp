// Compares fields of frames in volumes, and their singular edges.
#pragma once

#include <agreement/matched.hpp>

#include <concino/directions/frame_singularities.hpp>
#include <concino/geometry/normals.hpp>

#include <cmath>
#include <cstddef>
#include <optional>

namespace concino::agreement {

struct frames {
  static constexpr const char* name = "frame_field";
  template<class M> static constexpr bool runs_on = VolumeMesh<M> && Embedded<M>;

  /// The frames of m, unless it has no polys or they cannot be cut into tets.
  template<class M>
  static std::optional<frame_field_result<M>> frames_of(const M& m) {
    try {
      return frame_field(m, {.max_rounds = 3});
    } catch (const invalid_mesh&) { return {}; }
  }
  static bool are_close(const orthonormal_frame& a, const orthonormal_frame& b) {
    const auto nearest = detail::turned_to(a, b);
    return norm(nearest[0] - b[0]) + norm(nearest[1] - b[1]) < 1e-5;
  }

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const auto here = frames_of(n);
    const auto there = frames_of(m);
    expect(here.has_value() == there.has_value(), "whether there are frames");
    if (!here) return false;
    expect(here->rounds == there->rounds, "the rounds");
    bool tets = true;  // others are cut in a way that depends on the order of verts
    for (const auto p : both.polys.all) tets = tets && num_elements(adj_p2f(n, p)) == 4;
    for (const auto v : both.verts.all) {
      const auto& f = there->verts[both.verts.to(v)];
      if (tets) expect(are_close(f, here->verts[v]), "the frames at verts");
      const auto w = here->verts[v][0];
      if (is_boundary(n, v) && norm(w - vert_normal(n, v)) < 1e-9) expect(norm(f[0] - w) < 1e-9, "the normals");
    }
    if (!tets) return true;
    for (const auto p : both.polys.all)
      expect(are_close(there->polys[both.polys.to(p)], here->polys[p]), "the frames of polys");
    expect(singular_edges(*here).faces.size() == singular_edges(*there).faces.size(), "the singular edges");
    return true;
  }
};

}  // namespace concino::agreement
