// Where the boundary of a mesh has creases: at verts of a surface, at edges of a volume.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/error.hpp>
#include <concino/generate/dual_mesh_options.hpp>
#include <concino/geometry/dihedral_angles.hpp>
#include <concino/mesh/boundary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace concino::detail {

struct creases_by_angle {};

/// Which verts or edges of the boundary are creases: all, none, those of a map, or those at which the boundary turns by
/// an angle or more.
template<class M, class Creases>
class boundary_creases {
  static constexpr bool uses_map = !std::is_same_v<Creases, creases_by_angle>;

  const M& m_;
  const Creases& creases_;
  dual_boundary boundary_;
  double min_turning_angle_;  // in radians

  static vec3 rescaled(const vec3& x) { return x / std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

  /// The angle between the boundary edge before v and the one after it.
  double turning_angle(const vert_t<M>& v) const {
    vec3 away[2];
    std::size_t n = 0;
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      if (n == 2 || !is_boundary(m_, e)) continue;
      const auto [a, b] = end_verts(m_, e);
      away[n++] = rescaled(to_vec3(point(m_, a == v ? b : a)) - to_vec3(point(m_, v)));
    }
    return std::atan2(norm(cross(away[0], away[1])), -dot(away[0], away[1]));
  }

 public:
  /// Errors: invalid_argument if the options contradict each other or the angle is negative or not a number.
  boundary_creases(const M& m, const Creases& creases, const dual_mesh_options& o)
      : m_(m), creases_(creases), boundary_(o.boundary),
        min_turning_angle_(o.crease_angle_deg * std::numbers::pi / 180) {
    if (!(o.crease_angle_deg >= 0))
      throw invalid_argument(
          "dual_mesh: crease_angle_deg is negative or not a number; it is an angle in degrees, 0 or more");
    if (uses_map && boundary_ == dual_boundary::closed)
      throw invalid_argument("dual_mesh: creases are given, but closed cells have none; use dual_boundary::clipped");
    if (uses_map && o.crease_angle_deg != 0)
      throw invalid_argument("dual_mesh: creases are given by a map and by crease_angle_deg; give one of them");
  }

  /// Whether verts on the boundary have cells, and whether all verts or edges of the boundary are creases.
  bool has_boundary_cells() const { return boundary_ != dual_boundary::discarded; }
  bool all_are_creases() const { return boundary_ == dual_boundary::clipped && !uses_map && min_turning_angle_ == 0; }

  /// Whether a vert on the boundary of a surface is a crease.
  bool operator()(const vert_t<M>& v) const
    requires SurfaceMesh<M>
  {
    if (boundary_ == dual_boundary::closed) return false;
    if constexpr (uses_map) return static_cast<bool>(creases_[v]);
    else return min_turning_angle_ == 0 || turning_angle(v) >= min_turning_angle_;
  }
  /// Whether each edge on the boundary of a volume is a crease, by index.
  std::vector<unsigned char> at_edges() const
    requires VolumeMesh<M>
  {
    std::vector<unsigned char> is_crease(edge_index_bound(m_), all_are_creases());
    if (all_are_creases() || boundary_ != dual_boundary::clipped) return is_crease;
    const auto surface = boundary(m_);
    for (const edge_t<M> e : edges(surface)) {
      if constexpr (uses_map) is_crease[index_of(m_, e)] = static_cast<bool>(creases_[e]);
      else is_crease[index_of(m_, e)] = std::abs(std::numbers::pi - dihedral_angle(surface, e)) >= min_turning_angle_;
    }
    return is_crease;
  }
};

}  // namespace concino::detail
