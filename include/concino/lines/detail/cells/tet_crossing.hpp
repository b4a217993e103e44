// One tet after another along a line that enters each through a face. Only what the line needs of a tet is read.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace concino::detail {

/// The face of tet p without its vert v.
template<class M>
face_t<M> opposite_face(const M& m, const poly_t<M>& p, const vert_t<M>& v) {
  std::optional<face_t<M>> found;
  for (const face_t<M> f : adj_p2f(m, p)) {
    bool has_v = false;
    for (const vert_t<M> w : adj_f2v(m, f)) has_v |= w == v;
    if (!has_v) found = f;
  }
  return *found;
}

template<class M>
class tet_crossing {
 public:
  poly_t<M> poly = poly_t<M>();
  vec3 field;
  std::array<vert_t<M>, 4> verts;  // those of the face of entry, counter-clockwise seen from outside, and the one
                                   // opposite
  std::array<vec3, 4> points;
  std::array<std::uint32_t, 4> corners{};  // their numbers in adj_p2v

  /// Where the line leaves the tet: through the face without verts[left_out], which is not 3.
  struct exit {
    std::uint32_t left_out;
    vec3 position;
  };

  /// A tet that was read elsewhere; its verts and points are in the order of adj_p2v. entry: the numbers of those of
  /// the face of entry.
  void set(const poly_t<M>& p, std::span<const vert_t<M>> of_tet, std::span<const vec3> at,
           std::span<const std::uint32_t, 3> entry) {
    poly = p;
    for (std::uint32_t k = 0; k < 4; ++k) {
      corners[k] = k < 3 ? entry[k] : 6 - entry[0] - entry[1] - entry[2];
      verts[k] = of_tet[corners[k]];
      points[k] = at[corners[k]];
    }
  }

  /// The tet p behind the face by which the line left the one before.
  void read_behind(const M& m, const exit& out, const poly_t<M>& p) {
    const std::uint32_t a = (out.left_out + 1) % 3, b = (out.left_out + 2) % 3;
    const std::array<vert_t<M>, 3> v = {verts[a], verts[b], verts[3]};
    const std::array<vec3, 3> x = {points[a], points[b], points[3]};
    for (std::uint32_t k = 0; k < 3; ++k) {
      verts[k] = v[k];
      points[k] = x[k];
    }
    poly = p;
    std::uint32_t number = 0;
    for (const vert_t<M> w : adj_p2v(m, p)) {
      std::uint32_t k = w == v[2] ? 2 : 3;
      k = w == v[1] ? 1 : k;
      k = w == v[0] ? 0 : k;
      corners[k] = number++;
      verts[k] = w;
    }
    points[3] = to_vec3(point(m, verts[3]));
  }

  /// Whether the field certainly leads in through the face of entry.
  bool leads_in() const {
    const rounded_value s = rounded_line_sign(field, points[1] - points[0], points[2] - points[0]);
    return s.value < -s.error;
  }

  /// Where the line from x leaves; none unless that is certain from rounded determinants, and inside a face.
  std::optional<exit> leave(const vec3& x) const {
    constexpr std::uint32_t none = 3;  // the sides on which the edges to the opposite vert pass the line tell the face
    static constexpr std::array<std::uint32_t, 8> left_out = {none, 2, 0, 0, 1, 2, 1, none};
    const vec3 to_top = points[3] - x;
    std::array<double, 3> s;
    std::uint32_t sides = 0;
    bool certain = true;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const rounded_value r = rounded_line_sign(field, points[k] - x, to_top);
      s[k] = r.value;
      sides |= static_cast<std::uint32_t>(r.value > 0) << k;
      certain &= std::abs(r.value) > r.error;
    }
    const std::uint32_t out = left_out[sides];
    if (!certain || out == none) return {};
    const std::uint32_t a = (out + 1) % 3, b = (out + 2) % 3;
    const rounded_value entered = rounded_line_sign(field, points[b] - x, points[a] - x);
    if (!(std::abs(entered.value) > entered.error)) return {};
    // rounding may have moved x out of the face of entry
    const double side = entered.value > 0 ? entered.value : 0, whole = -s[b] + side + s[a];
    return exit{out, points[3] + (s[a] * (points[b] - points[3]) + -s[b] * (points[a] - points[3])) / whole};
  }
};

}  // namespace concino::detail
