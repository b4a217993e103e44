// Where a line is in a volume: in a cell, at a vert or at an edge; and how it gets there along a triangle.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/line_ridge.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>
#include <concino/lines/detail/follow/cycle_detector.hpp>
#include <concino/lines/detail/follow/line_recorder.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace concino::detail {

/// The state of a line, which is used from line to line.
template<class M, class G>
class volume_line_position {
 protected:
  const M* m_;
  field_reader<M, G> field_;
  polyhedron_reader<M> cell_;
  cycle_detector cycles_;

  enum class where { cell, ridge, vert, behind_tet } where_ = where::cell;
  vec3 x_;
  std::array<std::uint32_t, 3> entry_{};  // corners of the cell that was read last
  std::size_t entry_size_ = 0;
  std::optional<line_ridge<M>> ridge_;
  vert_t<M> vert_ = vert_t<M>();

  volume_line_position(const M& m, const field_reader<M, G>& field) : m_(&m), field_(field) {}

  void read(const poly_t<M>& p) {
    if (cell_.read(*m_, p)) cell_.field = field_.of(p);
  }
  void enter(const poly_t<M>& p, std::span<const std::uint32_t> entry) {
    read(p);
    std::copy(entry.begin(), entry.end(), entry_.begin());
    entry_size_ = entry.size();
    where_ = where::cell;
  }

  void add_vert(const vert_t<M>& v, line_recorder<M>& to) {
    to.add({v, x_}, cell_.poly());
    if (!to.done()) reach_vert(v, to);
  }
  void reach_vert(const vert_t<M>& v, line_recorder<M>& to) {
    vert_ = v;
    where_ = where::vert;
    if (cycles_.at_vert(index_of(*m_, v), to.num_points()) == cycle_detector::finding::repeats)
      to.repeat(cycles_.period());
  }

  void add_ridge(const cell_triangle& t, std::uint32_t k, double parameter, line_recorder<M>& to) {
    const line_ridge<M> r = ridge_of(*m_, cell_, t, k);
    if (r.edge)
      to.add({edge_point<M>{*r.edge, end_verts(*m_, *r.edge).first == r.from ? parameter : 1 - parameter}, x_},
             cell_.poly());
    else to.add({*r.face, x_}, cell_.poly());
    if (!to.done()) reach_ridge(r);
  }
  void reach_ridge(const line_ridge<M>& r) {
    ridge_ = r;
    where_ = where::ridge;
  }

  /// The line enters poly p through the triangle of face f with this number.
  void watch(const poly_t<M>& p, const face_t<M>& f, std::uint32_t number, line_recorder<M>& to) {
    const entry_key key = {index_of(*m_, p), index_of(*m_, f) << 32 | number};
    if (cycles_.at_face(key, x_, to.num_points()) == cycle_detector::finding::repeats) to.repeat(cycles_.period());
  }

  /// Moves in a triangle of the cell that was read last from x, which is inside (no entry), on the side with corners
  /// entry (2), or at a corner (1).
  void slide(const cell_triangle t, const vec3& velocity, std::span<const std::uint32_t> entry, line_recorder<M>& to) {
    if (velocity == vec3()) return to.stop(line_end::sink);
    std::array<vec3, 3> at;
    std::array<signed_value, 3> s;
    for (std::size_t k = 0; k < 3; ++k) at[k] = cell_.flat.points[t.corner[k]];
    const vec3 normal = triangle_normal(at[0], at[1], at[2]);
    for (std::size_t k = 0; k < 3; ++k) s[k] = side_in_plane(velocity, at[k], normal, x_);
    const auto is_entry = [&](std::uint32_t k) {
      return std::find(entry.begin(), entry.end(), t.corner[k]) != entry.end();
    };
    for (std::uint32_t k = 0; k < 3; ++k)
      if (!is_entry(k) && s[k].sign == 0 && dot(velocity, at[k] - x_) > 0) {
        x_ = at[k];
        return add_vert(cell_.verts[t.corner[k]], to);
      }
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t j = (k + 1) % 3;
      if (entry.size() == 1 && (is_entry(k) || is_entry(j))) continue;
      if (entry.size() == 2 && is_entry(k) && is_entry(j)) continue;
      const bool right = s[k].sign <= 0 || (entry.size() == 2 && is_entry(k)),
                 left = s[j].sign > 0 || (entry.size() == 2 && is_entry(j));
      if (entry.size() != 1 && !(right && left)) continue;
      const double a = std::max(0.0, -s[k].value), b = std::max(0.0, s[j].value),
                   parameter = a + b > 0 ? a / (a + b) : 0.5;
      x_ = at[k] + parameter * (at[j] - at[k]);
      return add_ridge(t, k, parameter, to);
    }
    std::uint32_t best = 0;  // x lies outside by rounding
    for (std::uint32_t k = 1; k < 3; ++k)
      if (dot(velocity, at[k] - at[best]) > 0) best = k;
    x_ = at[best];
    add_vert(cell_.verts[t.corner[best]], to);
  }
};

}  // namespace concino::detail
