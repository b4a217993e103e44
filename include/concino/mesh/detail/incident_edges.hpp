// incident_edges: the edges of every vert, and the verts at their other ends, in parallel rows.
#pragma once

#include <concino/mesh/detail/jagged_array.hpp>

namespace concino::detail {

/// Like two jagged_arrays whose rows are at the same places, which are stored once.
class incident_edges {
  row_places places_;
  core::flat_array<vert_id> verts_;
  core::flat_array<edge_id> edges_;

  bool has_eight(vert_id v) const { return verts_.size() - places_.first(v.raw()) >= 8; }
  void check_index_range(std::size_t more) const {
    if (verts_.size() + more > std::numeric_limits<std::uint32_t>::max()) throw unsupported("incident_edges: the mesh has more than 2^32 adjacencies of one kind");
  }
  /// Makes n reserved values part of the arrays, the first `used` of which the caller has written or will write.
  void append(std::size_t n, std::size_t used = 0) {
    const std::size_t at = verts_.size();
    verts_.resize(at + n), edges_.resize(at + n);
    std::fill_n(verts_.data() + at + used, n - used, vert_id{}), std::fill_n(edges_.data() + at + used, n - used, edge_id{});
  }

  [[gnu::noinline]] void move_row(std::size_t i, std::uint32_t room) {
    check_index_range(room);
    const std::uint32_t from = places_.first(i), n = places_.length(i);
    const std::size_t to = verts_.size();
    verts_.reserve_back(room), edges_.reserve_back(room);
    append(room, n);
    std::copy_n(verts_.data() + from, n, verts_.data() + to), std::copy_n(edges_.data() + from, n, edges_.data() + to);
    places_.move_row(i, to, room);
  }
  [[gnu::noinline]] void spread_rows() {
    row_places spread = places_.spread();
    core::flat_array<vert_id> verts;
    core::flat_array<edge_id> edges;
    spread.copy_rows(places_, verts_, verts);
    spread.copy_rows(places_, edges_, edges);
    places_.swap(spread), verts_.swap(verts), edges_.swap(edges);
  }
  [[gnu::noinline]] void enlarge_row(vert_id v, std::uint32_t n) {
    make_growable();
    if (!places_.has_room(v.raw(), n)) move_row(v.raw(), places_.larger_room(v.raw(), num_edges(v) + n));
  }

 public:
  incident_edges() = default;
  /// Packed rows.
  incident_edges(std::shared_ptr<const offsets> where, core::flat_array<vert_id> verts, core::flat_array<edge_id> edges)
      : places_(std::move(where)), verts_(std::move(verts)), edges_(std::move(edges)) {
    assert(places_.shared_offsets()->back() == verts_.size() && verts_.size() == edges_.size());
  }

  std::uint32_t num_edges(vert_id v) const { return places_.length(v.raw()); }
  id_span<vert_id> verts(vert_id v) const { return {verts_.data() + places_.first(v.raw()), verts_.data() + places_.last(v.raw())}; }
  id_span<edge_id> edges(vert_id v) const { return {edges_.data() + places_.first(v.raw()), edges_.data() + places_.last(v.raw())}; }
  /// The same, for changes.
  vert_id* verts_begin(vert_id v) { return verts_.data() + places_.first(v.raw()); }
  edge_id* edges_begin(vert_id v) { return edges_.data() + places_.first(v.raw()); }
  std::size_t num_values() const { return verts_.size(); }
  const std::shared_ptr<const offsets>& shared_offsets() const { return places_.shared_offsets(); }

  /// The place of an edge of v, which has it.
  std::uint32_t position(vert_id v, edge_id e) const {
    const edge_id* const row = edges_.data() + places_.first(v.raw());
    std::uint32_t k = has_eight(v) ? find_in_eight(row, e) : 0;
    while (!(row[k] == e)) ++k;
    return k;
  }
  /// The place of the edge from v to `other`, or the number of edges of v if there is none.
  std::uint32_t find(vert_id v, vert_id other) const {
    const vert_id* const row = verts_.data() + places_.first(v.raw());
    const std::uint32_t n = num_edges(v);
    std::uint32_t k = has_eight(v) ? find_in_eight(row, other) : 0;
    while (k < n && row[k] != other) ++k;
    return std::min(k, n);
  }
  edge_id edge_between(vert_id v, vert_id other) const {
    const std::uint32_t k = find(v, other);
    return k == num_edges(v) ? edge_id{} : edges_[places_.first(v.raw()) + k];
  }

  void prefetch_place(vert_id v) const { places_.prefetch(v.raw()); }
  /// The same as prefetch_values() for most verts if the rows are loose, without reading the place.
  void prefetch_slot(vert_id v) const {
    if (!places_.has_slot(v.raw())) return;
    __builtin_prefetch(verts_.data() + row_places::slot(v.raw()), 1);
    __builtin_prefetch(edges_.data() + row_places::slot(v.raw()), 1);
  }
  void prefetch_values(vert_id v) const {
    __builtin_prefetch(verts_.data() + places_.first(v.raw()), 1);
    __builtin_prefetch(edges_.data() + places_.first(v.raw()), 1);
  }

  // Edits allocate their memory first, which changes no row, and cannot fail afterwards.

  /// After this call remove_at(), remove() and clear() cannot fail. Most rows get room for more edges, so that they need not move soon.
  void make_growable() {
    if (places_.is_packed()) [[unlikely]] spread_rows();
  }
  /// The same, but rows stay where they are until they become too long; for the case that few do.
  void make_few_growable() {
    if (!places_.is_packed()) return;
    const std::size_t more = row_places::next_begin(verts_.size()) - verts_.size();
    check_index_range(more);
    verts_.reserve_back(more + 1), edges_.reserve_back(more + 1);
    places_.make_loose();
    append(more);
  }
  /// After this call, n calls of add_vert() with that many edges in all cannot fail.
  void reserve_verts(std::size_t n, std::size_t edges) {
    make_growable();
    places_.reserve(n);
    check_index_range(edges + n * row_places::room_unit);
    verts_.reserve_back(edges + n * row_places::room_unit), edges_.reserve_back(edges + n * row_places::room_unit);
  }
  /// Adds a vert without edges, with room for so many.
  void add_vert(std::uint32_t room) {
    room = row_places::room_for(room);
    places_.add(verts_.size(), 0, room);
    append(room);
  }
  /// After this call, n calls of push() for v cannot fail. It uses memory that reserve_verts() reserved, so it must come before that.
  void reserve_at(vert_id v, std::uint32_t n) {
    if (!places_.has_room(v.raw(), n)) [[unlikely]] enlarge_row(v, n);
  }
  /// Adds an edge of v, which has room for it.
  void push(vert_id v, vert_id other, edge_id e) {
    const std::uint32_t at = places_.extend(v.raw());
    verts_[at] = other, edges_[at] = e;
  }
  void set_other_end(vert_id v, edge_id e, vert_id other) { verts_begin(v)[position(v, e)] = other; }
  /// Removes an edge of v; the last one takes its place.
  void replace_by_last(vert_id v, edge_id e) { replace_by_last_at(v, position(v, e)); }
  /// The same for the k-th edge of v.
  void replace_by_last_at(vert_id v, std::uint32_t k) {
    const std::size_t at = places_.first_of_loose(v.raw()) + k, last = places_.shorten(v.raw());
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
  void clear(vert_id v) {
    make_growable();
    places_.set_length(v.raw(), 0);
  }

  // For undoing, as in jagged_array.
  std::size_t size() const { return places_.size(); }
  row_places::place place_of(std::size_t i) const { return places_.place_of(i); }
  template<class F>
  void for_each_array_at(std::size_t i, const F& f) const {
    f(verts_.data() + places_.first(i), verts_.data() + places_.last(i)), f(edges_.data() + places_.first(i), edges_.data() + places_.last(i));
  }
  template<class F>
  void for_each_array_at(std::size_t i, const F& f) {
    f(verts_.data() + places_.first(i), verts_.data() + places_.last(i)), f(edges_.data() + places_.first(i), edges_.data() + places_.last(i));
  }
  void restore_place(std::size_t i, const row_places::place& x) { places_.restore_place(i, x); }
  std::size_t values_to_restore() const { return places_.is_packed() ? jagged_array<vert_id, 0>::any_number : verts_.size(); }
  void restore_size(std::size_t rows, std::size_t values) {
    if (places_.is_packed()) return;
    places_.restore_size(rows);
    if (values != jagged_array<vert_id, 0>::any_number) verts_.resize(values), edges_.resize(values);
  }
};

}  // namespace concino::detail
