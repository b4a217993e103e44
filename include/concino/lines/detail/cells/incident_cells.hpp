// The cells at a vert or an edge of a volume that a line has reached.
#pragma once

#include <concino/lines/detail/cells/line_ridge.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>
#include <concino/lines/detail/cells/volume_exits.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino::detail {

/// Reuses its memory from place to place.
template<class M>
class incident_cells {
  std::vector<incident_cell> cells_;  // those in front are in use
  std::size_t size_ = 0;
  std::vector<poly_t<M>> polys_;

  incident_cell& add(const polyhedron_reader<M>& cell) {
    polys_.push_back(cell.poly());
    if (size_ == cells_.size()) cells_.emplace_back();
    incident_cell& c = cells_[size_++];
    c.field = cell.field;
    c.triangles.clear();
    return c;
  }
  static incident_triangle triangle_at(const M& m, const polyhedron_reader<M>& cell, const cell_triangle& t,
                                       std::uint32_t k, const incident_key& side_a, const incident_key& side_b) {
    const auto& at = cell.flat.points;
    return {at[t.corner[(k + 1) % 3]],
            at[t.corner[(k + 2) % 3]],
            {index_of(m, cell.faces[t.face]), t.number},
            side_a,
            side_b};
  }

 public:
  void clear() {
    size_ = 0;
    polys_.clear();
  }
  std::span<const incident_cell> all() const { return std::span(cells_).first(size_); }
  const poly_t<M>& poly(std::size_t i) const { return polys_[i]; }

  /// Adds the triangles at a vert of the cell that was read last.
  void add_at_vert(const M& m, const polyhedron_reader<M>& cell, const vert_t<M>& v) {
    incident_cell& c = add(cell);
    for (const cell_triangle& t : cell.flat.triangles)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (cell.verts[t.corner[k]] == v)
          c.triangles.push_back(
              triangle_at(m, cell, t, k, ridge_of(m, cell, t, k).key, ridge_of(m, cell, t, (k + 2) % 3).key));
  }

  /// Adds the two triangles at a ridge of the cell that was read last. The keys of their other sides are not needed.
  void add_at_ridge(const M& m, const polyhedron_reader<M>& cell, const line_ridge<M>& r) {
    incident_cell& c = add(cell);
    for (const cell_triangle& t : cell.flat.triangles)
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (!(cell.verts[t.corner[k]] == r.from)) continue;
        const std::uint32_t a = (k + 1) % 3, b = (k + 2) % 3;
        if (cell.verts[t.corner[a]] == r.to && ridge_of(m, cell, t, k).key == r.key)
          c.triangles.push_back(triangle_at(m, cell, t, k, r.key, {}));
        if (cell.verts[t.corner[b]] == r.to && ridge_of(m, cell, t, b).key == r.key)
          c.triangles.push_back(triangle_at(m, cell, t, k, {}, r.key));
      }
  }

  /// The triangle by which an exit leads, of the cell that was read last.
  cell_triangle triangle_of(const M& m, const polyhedron_reader<M>& cell, const volume_exit& out) const {
    const incident_key key = cells_[out.cell].triangles[out.triangle].face;
    for (const cell_triangle& t : cell.flat.triangles)
      if (index_of(m, cell.faces[t.face]) == key.element && t.number == key.part) return t;
    return {};
  }

  bool all_are_zero() const {
    for (const incident_cell& c : all())
      if (!(c.field == vec3())) return false;
    return true;
  }
};

}  // namespace concino::detail
