// The normals with which the corners at a vert of a surface are seen: their mean or, where lines part the surface, that
// of each part.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/remesh/detail/smoothing/corner_frames.hpp>
#include <concino/remesh/detail/smoothing/kept_surface.hpp>

#include <algorithm>
#include <vector>

namespace concino::detail {

/// Corners of volumes need no normals: there all are 0.
template<class M>
class corner_normals {
  const corner_frames<M>& corners_;
  std::vector<unsigned> fans_;  // by place of a corner; empty if the corners at each vert are in one

 public:
  using by_fan = core::small_array<vec3, 4>;

  explicit corner_normals(const corner_frames<M>& corners) : corners_(corners) {}

  /// After this call lines end fans: the corners at a vert of a line are seen with the normals of the parts between
  /// lines.
  void find_fans(const kept_surface& kept) {
    fans_.resize(corners_.num_places());
    std::vector<poly_id> polys;
    std::vector<unsigned> fans;
    for (const vert_id v : verts(kept.mesh())) {
      polys.clear();
      for (const poly_id p : adj_v2p(kept.mesh(), v)) polys.push_back(p);
      kept.find_fans(v, polys, fans);
      for (const unsigned* k = corners_.begin(v.raw()); k != corners_.end(v.raw()); ++k) {
        const auto at = std::find(polys.begin(), polys.end(), poly_id{corners_.poly_of(*k)});
        fans_[corners_.place(k)] = fans[static_cast<std::size_t>(at - polys.begin())];
      }
    }
  }

  /// The normals at v. Returns false if one is missing.
  bool find(unsigned v, const std::vector<vec3>& points, by_fan& n) const {
    n.resize(1, vec3{});
    // the determinants of corners of volumes need no normal
    if constexpr (dimension_v<M> == 3) return true;
    for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k) {
      const unsigned* const x = corners_.frames[*k].verts;
      const unsigned i = fan(k);
      if (i >= n.size()) n.resize(i + 1, vec3{});
      n[i] += cross(points[x[1]] - points[x[0]], points[x[2]] - points[x[0]]);
    }
    bool has_all = true;
    for (vec3& x : n) {
      const double length = norm(x);
      x = length > 0 ? x / length : vec3{};
      has_all = has_all && dot(x, x) > 0;
    }
    return has_all;
  }

  /// The place in by_fan of the normal of the corner that k points to.
  unsigned fan(const unsigned* k) const {
    // volumes have no fans of corners; this is asked for each corner at each step
    if constexpr (dimension_v<M> == 3) return 0;
    return fans_.empty() ? 0 : fans_[corners_.place(k)];
  }
};

}  // namespace concino::detail
