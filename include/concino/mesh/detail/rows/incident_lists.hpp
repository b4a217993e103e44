// incident_lists: the edges of every vert, the verts at their other ends, and on a surface its polys, in parallel rows.
#pragma once

#include <concino/mesh/detail/rows/jagged_array.hpp>

#include <type_traits>

namespace concino::detail {

/// Like two or three jagged_arrays whose rows are at the same places, which are stored once. The polys of a vert are
/// another number than its edges. In a volume these numbers differ too much for common places, so a volume stores its
/// polys apart.
template<bool WithPolys>
class incident_lists {
  template<bool> friend class incident_lists;
  struct no_polys {};
  row_places<WithPolys> places_;
  core::flat_array<vert_id> verts_;
  core::flat_array<edge_id> edges_;
  [[no_unique_address]] std::conditional_t<WithPolys, core::flat_array<poly_id>, no_polys> polys_;

  void check_index_range(std::size_t more) const {
    if (verts_.size() + more > std::numeric_limits<std::uint32_t>::max())
      throw unsupported("incident_lists: the mesh has more than 2^32 adjacencies of one kind");
  }
  template<class F>
  void for_each_array(const F& f) {
    f(verts_), f(edges_);
    if constexpr (WithPolys) f(polys_);
  }
  void reserve_back(std::size_t n) {
    for_each_array([n](auto& a) { a.reserve_back(n); });
  }
  /// Adds n values of none, in reserved memory.
  template<class T>
  static void append(core::flat_array<T>& a, std::size_t n) {
    const std::size_t at = a.size();
    a.resize(at + n);
    std::fill_n(a.data() + at, n, T{});
  }
  void append(std::size_t n) {
    for_each_array([n](auto& a) { append(a, n); });
  }

  void move_row(std::size_t i, std::uint32_t room) {
    check_index_range(room);
    const std::uint32_t from = places_.first(i), n = places_.longest(i);
    const std::size_t to = verts_.size();
    reserve_back(room);
    for_each_array([&](auto& a) {
      append(a, room);
      std::copy_n(a.data() + from, n, a.data() + to);
    });
    places_.move_row(i, to, room);
  }
  void add_spare_capacity() {
    incident_lists growable;
    growable.places_ = places_.with_spare_capacity();
    growable.places_.copy_rows(places_, verts_, growable.verts_);
    growable.places_.copy_rows(places_, edges_, growable.edges_);
    if constexpr (WithPolys) growable.places_.copy_second_rows(places_, polys_, growable.polys_);
    *this = std::move(growable);
  }
  void enlarge_row(vert_id v, std::uint32_t edges, std::uint32_t polys) {
    make_growable();
    std::uint32_t needed = num_edges(v) + edges;
    if constexpr (WithPolys) needed = std::max(needed, num_polys(v) + polys);
    if (needed > places_.room(v.raw())) move_row(v.raw(), places_.larger_room(v.raw(), needed));
  }

 public:
  incident_lists() = default;
  /// Packed rows.
  incident_lists(std::shared_ptr<const offsets> where, core::flat_array<vert_id> verts, core::flat_array<edge_id> edges)
    requires(!WithPolys)
      : places_(std::move(where)), verts_(std::move(verts)), edges_(std::move(edges)) {
    assert(shared_offsets()->back() == verts_.size() && verts_.size() == edges_.size());
  }
  /// The same with the polys of each vert. Equal offsets, for which null stands too, are stored once.
  incident_lists(std::shared_ptr<const offsets> where, core::flat_array<vert_id> verts, core::flat_array<edge_id> edges,
                 std::shared_ptr<const offsets> of_polys, core::flat_array<poly_id> polys) requires WithPolys
      : places_(where, of_polys&&* of_polys != *where ? std::move(of_polys) : where),
        verts_(std::move(verts)),
        edges_(std::move(edges)),
        polys_(std::move(polys)) {
    assert(shared_offsets()->back() == verts_.size() && verts_.size() == edges_.size() &&
           places_.second_shared_offsets()->back() == polys_.size());
  }
  incident_lists(incident_lists<false>&& edges, jagged_array<poly_id, 0>&& polys) requires WithPolys
      : incident_lists(edges.shared_offsets(), std::move(edges.verts_), std::move(edges.edges_), polys.shared_offsets(),
                       std::move(polys).values()) {}

  std::uint32_t num_edges(vert_id v) const { return places_.length(v.raw()); }
  id_span<vert_id> verts(vert_id v) const {
    return {verts_.data() + places_.first(v.raw()), verts_.data() + places_.last(v.raw())};
  }
  id_span<edge_id> edges(vert_id v) const {
    return {edges_.data() + places_.first(v.raw()), edges_.data() + places_.last(v.raw())};
  }
  std::uint32_t num_polys(vert_id v) const { return places_.second_length(v.raw()); }
  id_span<poly_id> polys(vert_id v) const {
    return {polys_.data() + places_.second_first(v.raw()), polys_.data() + places_.second_last(v.raw())};
  }
  /// The same, for changes.
  vert_id* verts_begin(vert_id v) { return verts_.data() + places_.first(v.raw()); }
  edge_id* edges_begin(vert_id v) { return edges_.data() + places_.first(v.raw()); }
  std::size_t num_values() const { return verts_.size(); }
  const std::shared_ptr<const offsets>& shared_offsets() const { return places_.shared_offsets(); }
  bool is_packed() const { return places_.is_packed(); }

  /// The place of an edge of v, which has it.
  std::uint32_t position(vert_id v, edge_id e) const { return position_in(edges(v), e); }
  /// The place of a poly of v, which has it.
  std::uint32_t position(vert_id v, poly_id p) const { return position_in(polys(v), p); }
  /// The place of the edge from v to `other`, or the number of edges of v if there is none.
  std::uint32_t find(vert_id v, vert_id other) const { return position_in(verts(v), other); }
  edge_id edge_between(vert_id v, vert_id other) const {
    const std::uint32_t k = find(v, other);
    return k == num_edges(v) ? edge_id{} : edges_[places_.first(v.raw()) + k];
  }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// After this call rows can become shorter, which cannot fail. Most rows get room for more values, so that they need
  /// not move soon.
  void make_growable() {
    if (places_.is_packed()) add_spare_capacity();
  }
  /// After this call, n calls of add_vert() with that room in all cannot fail.
  void reserve_verts(std::size_t n, std::size_t room) {
    make_growable();
    places_.reserve(n);
    check_index_range(room + n * places_.room_unit);
    reserve_back(room + n * places_.room_unit);
  }
  /// Adds a vert without edges, with room for so many.
  void add_vert(std::uint32_t room) {
    room = places_.room_for(room);
    places_.add(verts_.size(), 0, room);
    append(room);
  }
  /// After this call, n calls of push() for v cannot fail. It uses memory that reserve_verts() reserved, so it must
  /// come before that.
  void reserve_at(vert_id v, std::uint32_t n) {
    if (!places_.has_room(v.raw(), n)) enlarge_row(v, n, 0);
  }
  void reserve_at(vert_id v, std::uint32_t edges, std::uint32_t polys) {
    if (!places_.has_room(v.raw(), edges) || !places_.has_second_room(v.raw(), polys)) enlarge_row(v, edges, polys);
  }
  /// Adds an edge of v, which has room for it.
  void push(vert_id v, vert_id other, edge_id e) {
    const std::uint32_t at = places_.extend(v.raw());
    verts_[at] = other, edges_[at] = e;
  }
  void push(vert_id v, poly_id p) { polys_[places_.extend_second(v.raw())] = p; }
  void set_other_end(vert_id v, edge_id e, vert_id other) { verts_begin(v)[position(v, e)] = other; }
  /// Removes an edge of v; the last one takes its place.
  void replace_by_last(vert_id v, edge_id e) {
    const std::uint32_t at = places_.first(v.raw()) + position(v, e), last = places_.shorten(v.raw());
    verts_[at] = verts_[last], edges_[at] = edges_[last];
  }
  /// Removes an edge of v; the others keep their order.
  void remove(vert_id v, edge_id e) {
    vert_id* const verts = verts_begin(v);
    edge_id* const edges = edges_begin(v);
    const std::uint32_t n = num_edges(v), k = position(v, e);
    std::copy(verts + k + 1, verts + n, verts + k), std::copy(edges + k + 1, edges + n, edges + k);
    places_.shorten(v.raw());
  }
  /// Removes a poly of v; the others keep their order.
  void remove(vert_id v, poly_id p) {
    poly_id* const polys = polys_.data() + places_.second_first(v.raw());
    const std::uint32_t k = position(v, p), n = num_polys(v);
    std::copy(polys + k + 1, polys + n, polys + k);
    places_.set_second_length(v.raw(), n - 1);
  }
  void clear(vert_id v) {
    make_growable();
    places_.set_length(v.raw(), 0);
    if constexpr (WithPolys) places_.set_second_length(v.raw(), 0);
  }

  // For undoing, as in jagged_array.
  std::size_t size() const { return places_.size(); }
  auto extent_of(std::size_t i) const { return places_.extent_of(i); }
  template<class F>
  void for_each_array_at(std::size_t i, const F& f) const { visit_row(*this, i, f); }
  template<class F>
  void for_each_array_at(std::size_t i, const F& f) { visit_row(*this, i, f); }
  void restore_extent(std::size_t i, const typename row_places<WithPolys>::row_extent& x) {
    places_.restore_extent(i, x);
  }
  std::size_t values_to_restore() const {
    return places_.is_packed() ? jagged_array<vert_id, 0>::any_number : verts_.size();
  }
  void restore_size(std::size_t rows, std::size_t values) {
    if (places_.is_packed()) return;
    places_.restore_size(rows);
    if (values != jagged_array<vert_id, 0>::any_number) for_each_array([values](auto& a) { a.resize(values); });
  }

 private:
  template<class T>
  static std::uint32_t position_in(const id_span<T>& row, const T& value) {
    return static_cast<std::uint32_t>(std::find(row.begin(), row.end(), value) - row.begin());
  }
  template<class Self, class F>
  static void visit_row(Self& all, std::size_t i, const F& f) {
    const auto& at = all.places_;
    f(all.verts_.data() + at.first(i), all.verts_.data() + at.last(i)),
        f(all.edges_.data() + at.first(i), all.edges_.data() + at.last(i));
    if constexpr (WithPolys) f(all.polys_.data() + at.second_first(i), all.polys_.data() + at.second_last(i));
  }
};

/// Of a volume.
using incident_edges = incident_lists<false>;
/// Of a surface.
using incident_edges_and_polys = incident_lists<true>;

}  // namespace concino::detail
