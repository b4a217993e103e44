// The faces of one polyhedron as lists of verts, and its volume.
#pragma once

#include <concino/mesh/arrays.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The faces of one polyhedron: face k has verts[offsets[k]] .. verts[offsets[k+1]-1], which are counter-clockwise as
/// seen from outside if outward[k].
struct oriented_faces {
  const std::uint32_t* offsets;
  const vert_id* verts;
  std::uint8_t* outward;
  std::uint32_t size;

  std::uint32_t num_corners() const { return offsets[size] - offsets[0]; }
  /// Calls use(a, b, up, k) for each edge of each face k: a < b, and `up` says whether the outward face runs from a to
  /// b.
  template<class Use>
  void for_each_edge(const Use& use) const {
    for (std::uint32_t k = 0; k < size; ++k) {
      std::uint32_t a = verts[offsets[k + 1] - 1].raw();
      for (std::uint32_t i = offsets[k]; i < offsets[k + 1]; ++i) {
        const std::uint32_t b = verts[i].raw();
        use(std::min(a, b), std::max(a, b), (a < b) == (outward[k] != 0), k);
        a = b;
      }
    }
  }
};

/// Lists the faces of the polys of a mesh, one poly at a time.
template<class Vert>  // vert_id, as in face_merger
class face_lister {
  std::vector<std::uint32_t> offsets_;
  std::vector<Vert> verts_;

 public:
  oriented_faces operator()(polyhedra_arrays& m, std::size_t p) {
    offsets_.assign(1, 0);
    verts_.clear();
    for (std::uint32_t i = m.poly_offsets[p]; i < m.poly_offsets[p + 1]; ++i) {
      const std::uint32_t f = m.poly_faces[i].raw();
      verts_.insert(verts_.end(), m.face_verts.data() + m.face_offsets[f], m.face_verts.data() + m.face_offsets[f + 1]);
      offsets_.push_back(static_cast<std::uint32_t>(verts_.size()));
    }
    return {offsets_.data(), verts_.data(), m.outward.data() + m.poly_offsets[p],
            m.poly_offsets[p + 1] - m.poly_offsets[p]};
  }
};

struct same_point {
  const vec3& operator()(const vec3& p) const { return p; }
};

/// Six times the volume of a poly: each face is split into triangles at its mean point, with the sign of its outward
/// flag. Points are mapped by `scaled` first. If the faces do not close the poly, the result depends on the point from
/// which volumes are measured: `center`, or the first vert.
template<class Scale = same_point>
double six_times_poly_volume(const oriented_faces& p, std::span<const vec3> points, const vec3* center = nullptr,
                             const Scale& scaled = {}) {
  double sum = 0;
  if (p.size == 0) return sum;
  const vec3 apex = scaled(center ? *center : points[p.verts[p.offsets[0]].raw()]);
  for (std::uint32_t k = 0; k < p.size; ++k) {
    const vert_id* const v = p.verts + p.offsets[k];
    const double one = six_times_volume_under(
        p.offsets[k + 1] - p.offsets[k], [&](std::size_t i) -> decltype(auto) { return scaled(points[v[i].raw()]); },
        apex);
    sum += p.outward[k] ? one : -one;
  }
  return sum;
}

/// Whether the volume of a poly is negative, by more than rounding errors. It is measured from the centre of its box,
/// so that the result does not depend on the order of the verts if faces do not close the poly.
inline bool has_negative_volume(const oriented_faces& p, std::span<const vec3> points) {
  if (p.num_corners() == 0) return false;
  volume_box box;
  for (std::uint32_t i = p.offsets[0]; i < p.offsets[p.size]; ++i) box.add(points[p.verts[i].raw()]);
  const vec3 center = box.center();
  const double x = box.is_moderate()
                       ? six_times_poly_volume(p, points, &center)
                       : six_times_poly_volume(p, points, &center, [&](const vec3& q) { return box.scaled(q); });
  return x < -box.error(p.num_corners());
}

}  // namespace concino::detail
