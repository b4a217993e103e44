// The caps of tets that a level set crosses, by the signs of their four verts.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/polygon_sheets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A cap as a cycle of crossed edges, counter-clockwise seen from above. Edges 0 to 5 join the verts 01 02 03 12 13 23.
struct tet_cap {
  std::uint8_t size;
  std::uint8_t edges[4];
};
inline constexpr std::uint8_t tet_edge_verts[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// Bit k of the number of an entry says whether vert k is above.
inline constexpr tet_cap tet_caps[16] = {
    {0, {}}, {3, {1, 0, 2}}, {3, {0, 3, 4}}, {4, {1, 3, 4, 2}},
    {3, {3, 1, 5}}, {4, {3, 0, 2, 5}}, {4, {0, 1, 5, 4}}, {3, {4, 2, 5}},
    {3, {2, 4, 5}}, {4, {1, 0, 4, 5}}, {4, {0, 3, 5, 2}}, {3, {1, 3, 5}},
    {4, {3, 1, 2, 4}}, {3, {3, 0, 4}}, {3, {0, 1, 2}}, {0, {}},
};

/// Adds the caps of tets to a list. Each step of a cap crosses the face of its two edges: the caps of both tets at a face are neighbours there. Where no vert of a
/// tet is strictly above, its cap has no size, or is a face on the level set; the list removes it if the cap of the tet beyond is its opposite.
template<class M>
class tet_cap_reader {
  const M& m_;
  crossed_volume_reader<M>& crossed_;
  polygon_sheets& sheets_;
  core::local_numbers steps_;          // by the edges of the step
  struct step_users { std::uint32_t first, size; };
  std::vector<step_users> users_;      // by step: the corner that uses it first, and how many do

 public:
  tet_cap_reader(const M& m, std::size_t num_tets, crossed_volume_reader<M>& crossed, polygon_sheets& sheets) : m_(m), crossed_(crossed), sheets_(sheets) {
    crossed.reserve(num_tets, 0, 0);
    sheets.reserve(num_tets, 4 * num_tets);
    users_.reserve(2 * num_tets);
  }

  template<class U>
  void add(const U& u, const poly_t<M>& p, std::uint32_t cell) {
    std::uint32_t verts[4], edges[6];
    unsigned signs = 0, num_on = 0, k = 0;
    bool any_above = false;
    vert_t<M> below{};
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      verts[k] = crossed_.number_of_vert(m_, u, v);
      const unsigned char state = crossed_.arrays.states[verts[k]];
      signs |= unsigned{state != below_level} << k++;
      num_on += state == on_level;
      any_above = any_above || state == above_level;
      if (state == below_level) below = v;
    }
    if (num_on == 3 && !any_above && !has_two_tets(p, below)) return;
    k = 0;
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      const auto [a, b] = tet_edge_verts[k];
      const bool is_crossed = (signs >> a & 1u) != (signs >> b & 1u);
      edges[k++] = is_crossed ? crossed_.add_crossed_edge(m_, e) : 0;
    }
    const tet_cap& cap = tet_caps[signs];
    for (unsigned i = 0; i < cap.size; ++i) {
      const std::uint8_t e = cap.edges[i];
      const auto [a, b] = tet_edge_verts[e];
      const std::uint32_t corner = sheets_.add_corner(crossed_.arrays.place_between(level_place::edge, edges[e], verts[a], verts[b]));
      use_step(edges[e], edges[cap.edges[i + 1 < cap.size ? i + 1 : 0]], corner);
    }
    sheets_.end_polygon(cell);
  }

 private:
  /// Whether the face of p without one of its verts has two tets.
  bool has_two_tets(const poly_t<M>& p, const vert_t<M>& opposite) const {
    for (const face_t<M> f : adj_p2f(m_, p)) {
      bool has_vert = false;
      for (const vert_t<M> v : adj_f2v(m_, f)) has_vert = has_vert || v == opposite;
      if (!has_vert) return num_elements(adj_f2p(m_, f)) == 2;
    }
    return false;
  }
  void use_step(std::uint32_t a, std::uint32_t b, std::uint32_t corner) {
    const unsigned step = steps_.add(std::size_t{std::min(a, b)} << 32 | std::max(a, b));
    if (step == users_.size()) users_.push_back({corner, 1});
    else if (++users_[step].size == 2) sheets_.make_neighbours(users_[step].first, corner);
    else sheets_.separate(users_[step].first);  // three tets or more at a face: none are neighbours
  }
};

}  // namespace concino::detail
