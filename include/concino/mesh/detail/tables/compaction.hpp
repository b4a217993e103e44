// Compaction of tables after elements were removed: the remaining elements are numbered 0, 1, 2, ... in the same order,
// and rows become packed.
#pragma once

#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/detail/rows/incident_lists.hpp>
#include <concino/mesh/detail/facets/facet_adjacency.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The numbers of the elements of one kind before and after a compaction.
template<class Id>
class compact_numbers {
  std::vector<std::uint32_t> before_;       // by new number
  core::flat_array<std::uint32_t> after_;   // by old number

 public:
  explicit compact_numbers(const alive_elements<Id>& all) : after_(all.bound(), ~0u) {
    before_.reserve(all.size());
    for (const Id x : all.all()) {
      after_[x.raw()] = static_cast<std::uint32_t>(before_.size());
      before_.push_back(x.raw());
    }
  }
  std::size_t size() const { return before_.size(); }
  std::uint32_t before(std::size_t i) const { return before_[i]; }
  std::uint32_t after(std::uint32_t i) const { return after_[i]; }
  Id operator()(Id x) const { return Id{after_[x.raw()]}; }
  std::vector<std::uint32_t> take_before() { return std::move(before_); }
};

/// The numbers of all elements of tables.
struct compaction {
  compact_numbers<vert_id> verts;
  compact_numbers<edge_id> edges;
  compact_numbers<face_id> faces;
  compact_numbers<poly_id> polys;

  template<class Tables>
  explicit compaction(const Tables& t) : verts(t.verts()), edges(t.edges()), faces(faces_of(t)), polys(t.polys()) {}

 private:
  template<class Tables>
  static compact_numbers<face_id> faces_of(const Tables& t) {
    if constexpr (requires { t.faces(); }) return compact_numbers<face_id>(t.faces());
    else return compact_numbers<face_id>(alive_elements<face_id>());
  }
};

/// The rows of the remaining elements; each value becomes renumber(value). row(i): that of element i before.
template<class T, class Id, class Row, class F>
jagged_array<T, 0> pack_rows(const compact_numbers<Id>& kept, const Row& row, const F& renumber) {
  offsets lengths(kept.size() + 1, 0);
  for (std::size_t i = 0; i < kept.size(); ++i) lengths[i + 1] = static_cast<std::uint32_t>(row(kept.before(i)).size());
  auto packed = make_jagged_array<T>(std::move(lengths));
  T* to = packed.begin(0);
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (const T& x : row(kept.before(i))) *to++ = renumber(x);
  return packed;
}
template<class T, class Id, class F>
jagged_array<T, 0> packed_rows(const jagged_array<T, 0>& rows, const compact_numbers<Id>& kept, const F& renumber) {
  return pack_rows<T>(kept, [&rows](std::size_t i) { return rows[i]; }, renumber);
}
template<class T, unsigned N, class Id, class F>
jagged_array<T, N> packed_rows(const jagged_array<T, N>& rows, const compact_numbers<Id>& kept, const F& renumber) {
  jagged_array<T, N> packed(kept.size());
  T* to = packed.begin(0);
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (const T& x : rows[kept.before(i)]) *to++ = renumber(x);
  return packed;
}

/// The edges of the remaining verts.
template<bool WithPolys>
incident_edges packed_edges(const incident_lists<WithPolys>& all, const compact_numbers<vert_id>& kept_verts,
                            const compact_numbers<edge_id>& kept_edges) {
  offsets where(kept_verts.size() + 1, 0);
  for (std::size_t i = 0; i < kept_verts.size(); ++i) where[i + 1] = all.num_edges(vert_id{kept_verts.before(i)});
  prefix_sum(where);
  core::flat_array<vert_id> verts(where.back());
  core::flat_array<edge_id> edges(where.back());
  std::size_t at = 0;
  for (std::size_t i = 0; i < kept_verts.size(); ++i) {
    const vert_id v{kept_verts.before(i)};
    for (std::size_t k = 0; k < all.num_edges(v); ++k, ++at)
      verts[at] = kept_verts(all.verts(v)[k]), edges[at] = kept_edges(all.edges(v)[k]);
  }
  return {std::make_shared<const offsets>(std::move(where)), std::move(verts), std::move(edges)};
}

inline non_manifold_facets non_manifold_facets::compacted(const std::vector<std::uint32_t>& lists,
                                                          const compact_numbers<poly_id>& kept) const {
  non_manifold_facets all;
  std::size_t polys = 0;
  for (const std::uint32_t i : lists) polys += length(i);
  if (!lists.empty()) all.reserve_rows(lists.size(), polys);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    all.add_row(begin(lists[i]), end(lists[i]));
    for (poly_id *p = all.base::begin(i), *last = p + all.length(i); p != last; ++p) *p = kept(*p);
  }
  return all;
}

template<class Facet, unsigned N>
facet_adjacency<Facet, N> facet_adjacency<Facet, N>::compacted(const compact_numbers<Facet>& kept_facets,
                                                               const compact_numbers<poly_id>& kept) const {
  facet_adjacency all;
  all.facets_ = packed_rows(facets_, kept, kept_facets);
  std::vector<std::uint32_t> lists, new_lists(poly_lists_.size(), ~0u);
  for (std::size_t i = 0; i < kept.size() && !new_lists.empty(); ++i)
    for (const encoded_neighbour& x : neighbours_[kept.before(i)])
      if (x.is_non_manifold() && new_lists[x.poly_list()] == ~0u) {
        new_lists[x.poly_list()] = static_cast<std::uint32_t>(lists.size());
        lists.push_back(x.poly_list());
      }
  all.poly_lists_ = poly_lists_.compacted(lists, kept);
  all.neighbours_ = packed_rows(neighbours_, kept, [&](encoded_neighbour x) {
    if (x.is_none()) return x;
    const std::uint32_t flags = x.raw & ~encoded_neighbour::mask;
    return encoded_neighbour{flags | (x.is_non_manifold() ? new_lists[x.poly_list()] : kept.after(x.poly()))};
  });
  all.owner_.resize(kept_facets.size());
  for (std::size_t f = 0; f < kept_facets.size(); ++f) {
    const std::uint32_t o = owner_[kept_facets.before(f)];
    if constexpr (N > 0) all.owner_[f] = o == ~0u ? o : N * kept.after(o / N) + o % N;
    else all.owner_[f] = o == ~0u ? o : kept.after(o);
  }
  if constexpr (N == 0) {
    all.neighbours_.share_offsets(all.facets_);
    all.facet_lookup_ = row_lookup(all.facets_);
    all.poly_lists_.index_poly_lists(all.neighbours_, few_facets);
  }
  return all;
}

}  // namespace concino::detail
