// The polys around the edges of tables of tets and hexes: one fan, or a list; see cell_tables.hpp.
#pragma once

#include <concino/mesh/cell_tables.hpp>

namespace concino {

template<class Shape, class Lists>
std::uint32_t cell_tables<Shape, Lists>::count_polys(edge_id e) const {
  std::uint32_t n = 0;
  for_each_poly_at(e, [&](poly_id) { ++n; });
  return n;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::update_fan(edge_id e, std::uint32_t n) {
  const bool was_non_manifold = is_non_manifold(e);
  const std::size_t list = was_non_manifold ? poly_list_number(e) : poly_lists_.size();
  if (was_non_manifold) poly_lists_.clear_row(list);
  if (n == 0) {
    detail::remove_edge(edges_, e2v_, incident_edges_, e);
    return;
  }
  poly_id first;
  for_each_poly_at(e, [&](poly_id p) { first = first.is_none() ? p : first; });
  e2p_[e.raw()] = first.raw();
  check_fan(e, n);
  if (e2p_[e.raw()] != detail::encoded_neighbour::special) return;
  e2p_[e.raw()] |= static_cast<std::uint32_t>(list);
  if (!was_non_manifold) poly_lists_.add_row(&first, &first, n);
  for_each_poly_at(e, [&](poly_id p) { poly_lists_.push(list, p); });
}
template<class Shape, class Lists>
bool cell_tables<Shape, Lists>::closes_early(edge_id e, std::uint32_t n) const {
  const poly_id first = first_poly(e);
  poly_id p = first;
  std::uint32_t by = faces_at(p, e)[0];
  for (std::uint32_t steps = 3; steps < n; ++steps) {
    const poly_id next = neighbour_at_face(p, by);
    if (next.is_none()) return false;
    if (next == first) return true;
    const face_id f = adj_p2f(p)[by];
    const auto two = faces_at(next, e);
    by = adj_p2f(next)[two[0]] == f ? two[1] : two[0];
    p = next;
  }
  return neighbour_at_face(p, by) == first;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::check_fan(edge_id e, std::uint32_t uses) {
  std::uint32_t n = 0;
  const auto around = adj_e2p(e);
  for (auto it = around.begin(), last = around.end(); it != last; ++it) ++n;
  if (n != uses) e2p_[e.raw()] = detail::encoded_neighbour::special;
}

template<class Shape, class Lists>
void cell_tables<Shape, Lists>::list_polys_of_edges() {
  std::uint32_t num = 0;
  for (std::uint32_t *e = e2p_.data(), *last = e + e2p_.size(); e != last; ++e)
    if (*e & detail::encoded_neighbour::special) *e = detail::encoded_neighbour::special | num++;
  if (num == 0) return;
  const auto for_each_use = [&](auto&& use) {
    for (std::size_t p = 0; p < p2e_.size(); ++p)
      for (const edge_id e : p2e_[p])
        if (is_non_manifold(e)) use(poly_list_number(e), poly_id{p});
  };
  detail::offsets sizes(num + std::size_t{1}, 0);
  for_each_use([&](std::size_t list, poly_id) { ++sizes[list + 1]; });
  poly_lists_ = detail::make_jagged_array<poly_id>(std::move(sizes));
  detail::offsets next(poly_lists_.shared_offsets()->begin(), poly_lists_.shared_offsets()->end() - 1);
  poly_id* const listed = poly_lists_.begin(0);
  for_each_use([&](std::size_t list, poly_id p) { listed[next[list]++] = p; });
}

}  // namespace concino
