// Merges verts of any mesh into one, as when two meshes are glued together.
#pragma once

#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/propose.hpp>
#include <concino/edit/detail/relabelled_origins.hpp>
#include <concino/edit/detail/representable.hpp>

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

namespace concino {

/// What happens to polys that become degenerate.
enum class degenerate_polys : unsigned char {
  refuse,  // the edit is refused
  remove,  // they are removed
};

struct merge_verts_options {
  degenerate_polys degenerate = degenerate_polys::refuse;  // what happens to polys that become degenerate
  bool at_mean = false;  // the remaining vert moves to the mean of all points, and has the mean of interpolated values;
                         // else it stays and keeps them
  std::vector<invariant> keep = {};  // see edit_options; asked about each removed vert. Polys at the verts must be
                                     // triangles or tets if any is given
};

namespace detail {

inline constexpr permission equal_verts{refusal::wrong_set, "the verts that are merged are not all different"};
inline constexpr permission becomes_degenerate{refusal::degenerate,
                                               "a poly would become degenerate; options.degenerate can remove it"};
inline constexpr permission face_without_polys{
    refusal::loose_face, "a face without polys is at a vert that is removed; remove_unreferenced(m) removes it"};

template<class M>
bool has_loose_face(const M& m, const vert_t<M>& v) {
  if constexpr (VolumeMesh<M>)  // surfaces have no faces
    for (const face_t<M> f : adj_v2f(m, v))
      if (num_elements(adj_f2p(m, f)) == 0) return true;
  return false;
}

/// Whether a survivor has the same verts as another poly.
template<class M>
bool has_polys_on_same_verts(const M& m, const vert_t<M>& kept, const relabelled_cavity<M>& c) {
  struct entry {
    std::vector<std::size_t> verts;
    bool is_new;
  };
  std::vector<entry> all;
  const auto add = [&](const auto& verts, bool is_new) {
    entry x{{}, is_new};
    for (const auto& v : verts) x.verts.push_back(v);
    std::sort(x.verts.begin(), x.verts.end());
    x.verts.erase(std::unique(x.verts.begin(), x.verts.end()), x.verts.end());
    all.push_back(std::move(x));
  };
  for (const unsigned k : c.survivors()) {
    std::vector<std::size_t> verts;
    for (const unsigned label : c.labels(k)) verts.push_back(index_of(m, c.vert_at(label)));
    add(verts, true);
  }
  for (const poly_t<M> p : adj_v2p(m, kept)) {
    if (c.has(p)) continue;
    std::vector<std::size_t> verts;
    for (const vert_t<M> v : adj_p2v(m, p)) verts.push_back(index_of(m, v));
    add(verts, false);
  }
  std::sort(all.begin(), all.end(), [](const entry& a, const entry& b) { return a.verts < b.verts; });
  for (std::size_t i = 1; i < all.size(); ++i)
    if ((all[i - 1].is_new || all[i].is_new) && all[i - 1].verts == all[i].verts) return true;
  return false;
}

/// The polys at removed verts are replaced by those that have `kept` instead.
template<class M>
permission merge_cavity(const M& m, const vert_t<M>& kept, std::span<const vert_t<M>> removed,
                        const merge_verts_options& options, relabelled_cavity<M>& c) {
  for (const vert_t<M>& v : removed) {
    const unsigned before = c.num_verts();
    if (v == kept || c.number(v) < before) return equal_verts;
    if (has_loose_face(m, v)) return face_without_polys;
  }
  c.end_removed();
  const unsigned a = c.number(kept);
  for (unsigned i = 0; i < c.num_removed(); ++i)
    for (const poly_t<M> p : adj_v2p(m, c.vert_at(i))) c.set_label(c.add(p), i, a);
  if (!c.build() && options.degenerate == degenerate_polys::refuse) return becomes_degenerate;
  if (has_polys_on_same_verts(m, kept, c)) return polys_on_same_verts;
  c.prepare();
  return is_representable(m, c.lists());
}

template<class M>
vec3 mean_of_merged(const M& m, const vert_t<M>& kept, std::span<const vert_t<M>> removed) {
  vec3 mean = to_vec3(point(m, kept));
  for (const vert_t<M>& v : removed) mean += to_vec3(point(m, v));
  return mean / static_cast<double>(removed.size() + 1);
}

/// Asks the invariants about the edit of c, as one in which removed vert i becomes one with `kept`.
template<class M>
permission ask_about_removed(const M& m, const vert_t<M>& kept, std::span<const vert_t<M>> removed, std::size_t i,
                             const merge_verts_options& options, const relabelled_cavity<M>& c) {
  cavity_builder<M> simplices(m);
  for (const poly_t<M>& p : c.polys())
    if (!simplices.add_old(p)) return not_simplices;
  for (const poly_t<M> p : adj_v2p(m, kept))
    if (!c.has(p) && !simplices.add_neighbour(p)) return not_simplices;
  const unsigned a = simplices.vert(kept), b = simplices.vert(removed[i]);
  for (const unsigned k : c.survivors()) {
    std::array<unsigned, cavity_builder<M>::size> corners{};
    std::size_t n = 0;
    for (const unsigned label : c.labels(k)) corners[n++] = simplices.vert(c.vert_at(label));
    simplices.add_new(corners.data(), k);
  }
  simplices.merge(a, b, options.at_mean ? 0.5 : 0);
  if (options.at_mean) simplices.move(a, mean_of_merged(m, kept, removed));
  return ask(options.keep, m, simplices);
}

/// The edit, and whether it is allowed.
template<class M>
permission propose_merge(const M& m, const vert_t<M>& kept, std::span<const vert_t<M>> removed,
                         const merge_verts_options& options, relabelled_cavity<M>& c) {
  const permission p = merge_cavity<M>(m, kept, removed, options, c);
  if (!p || options.keep.empty()) return p;
  for (std::size_t i = 0; i < removed.size(); ++i)
    if (const permission x = ask_about_removed(m, kept, removed, i, options, c); !x) return x;
  return p;
}

template<class M>
void check_merge(const M& m, const vert_t<M>& kept, std::span<const vert_t<M>> removed, const char* edit) {
  check_element(m, kept, edit, "vert");
  for (const vert_t<M>& v : removed) check_element(m, v, edit, "vert");
}

/// Where the values of the remaining vert come from.
template<class M>
relabelled_vert origins_of_merged(const M& m, const vert_t<M>& kept, std::span<const vert_t<M>> removed, bool is_mean,
                                  unsigned label) {
  relabelled_vert x{label, {}, {{static_cast<std::uint32_t>(index_of(m, kept))}}};
  for (const vert_t<M>& v : removed) x.of_sums.push_back({static_cast<std::uint32_t>(index_of(m, v))});
  x.from = x.of_sums;
  if (!is_mean) x.from.resize(1);
  return x;
}

}  // namespace detail

/// Whether verts can be merged: they are different, no poly becomes degenerate unless options allow that, no two polys
/// would have the same verts, the library of m can represent the result, and the invariants hold.
/// Needs:  EditableMesh M, verts of m.      Result: true, or the reason.
/// Cost:   the polys at the verts, and sorting these.
/// Errors: invalid_mesh if one of the verts is not a vert of m, and what an invariant throws.
template<EditableMesh M>
permission can_merge_verts(const M& m, vert_t<M> kept, std::span<const std::type_identity_t<vert_t<M>>> removed,
                           const merge_verts_options& options = {}) {
  detail::check_merge<M>(m, kept, removed, "can_merge_verts");
  detail::relabelled_cavity<M> c(m);
  return detail::propose_merge<M>(m, kept, removed, options, c);
}
template<EditableMesh M>
permission can_merge_verts(const M& m, vert_t<M> kept, std::initializer_list<vert_t<M>> removed,
                           const merge_verts_options& options = {}) {
  return can_merge_verts(m, kept, std::span<const vert_t<M>>(removed.begin(), removed.size()), options);
}

/// Merges verts: polys at the removed ones get `kept` instead. Edges and faces that have the same verts then become
/// one, so meshes can be glued together. A poly becomes degenerate if it would have a vert twice. But polygons and the
/// faces of general polyhedra lose a corner where neighbouring verts become one, and faces of which two verts are left
/// vanish. A polyhedron is degenerate if less than four faces remain, if it would have one twice, or would touch
/// itself.
/// Needs:  EditableMesh M, verts of m.
/// Result: the remaining vert, or the reason why not. Other descriptors remain valid, apart from those of the removed
///         verts, of degenerate polys, and of one of each two edges or faces that become one. The values of properties
///         at elements that become one follow their rules.
/// Cost:   that of can_merge_verts, and the elements at the verts of the polys at the removed verts, but O(mesh) the
///         first time.
/// Errors: invalid_mesh if one of the verts is not a vert of m, and what an invariant throws. The mesh is unchanged
///         then, also if memory runs out.
template<EditableMesh M>
vert_result<M> merge_verts(M& m, vert_t<M> kept, std::span<const std::type_identity_t<vert_t<M>>> removed,
                           const merge_verts_options& options = {}) {
  detail::check_merge<M>(m, kept, removed, "merge_verts");
  detail::relabelled_cavity<M> c(m);
  if (const permission p = detail::propose_merge<M>(m, kept, removed, options, c); !p) return {p};
  if (removed.empty()) return {{}, kept};
  const std::vector<detail::relabelled_vert> changed{
      detail::origins_of_merged<M>(m, kept, removed, options.at_mean, c.num_removed())};
  const vec3 mean = detail::mean_of_merged<M>(m, kept, removed);
  detail::apply_relabelling(m, c, changed, [&] {
    // while a transaction is open, moving the vert may fail, so it comes first
    const bool is_recorded = detail::has_open_transaction(m);
    if (options.at_mean && is_recorded) set_point(m, kept, mean);
    c.apply(m);
    if (options.at_mean && !is_recorded) set_point(m, kept, mean);
  });
  return {{}, kept};
}
template<EditableMesh M>
vert_result<M> merge_verts(M& m, vert_t<M> kept, std::initializer_list<vert_t<M>> removed,
                           const merge_verts_options& options = {}) {
  return merge_verts(m, kept, std::span<const vert_t<M>>(removed.begin(), removed.size()), options);
}

}  // namespace concino
