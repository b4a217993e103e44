// Editing half-edge meshes of other libraries, and undoing it: what their traits have in common. The struct K of
// halfedge_log.hpp also has:
//
//   static halfedge_edits<K>* find_edits(mesh&);    // null if the mesh has had no transaction
//   static halfedge_edits<K>& edits_of(mesh&);      // made if there are none
//   static void assign_point(point&, const X&);
#pragma once

#include <concino/adapters/detail/halfedge_log.hpp>
#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/vec3.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace concino::detail {

/// The record of a mesh while a transaction is open.
template<class K>
class halfedge_recorder {
  using mesh = typename K::mesh;

  mesh& m_;
  typename K::points points_;

 public:
  static constexpr bool records = true;
  halfedge_log<K> log;

  explicit halfedge_recorder(mesh& m) : m_(m), points_(K::find_points(m)) {}

  void save_point(unsigned v) {
    log.begin_step(m_, 0, 1, 0, 0, 0);
    log.save_point(m_, points_, v);
  }
  /// Begins the step of a plan.
  void save(const halfedge_plan<K>& plan, const halfedge_cavity<K>& c) {
    log.begin_step(m_, 2 * plan.edges.size() + plan.border_links.size() + c.verts.size() + c.polys.size(), 0, c.removed,
                   plan.edges.size(), c.polys.size());
    const unsigned bound = 2 * K::num_edges(m_);
    for (const planned_edge& e : plan.edges)
      if (!e.is_new) log.save_halfedge(m_, e.halfedge), log.save_halfedge(m_, e.halfedge ^ 1);
    for (const auto& x : plan.border_links)
      if (x.in < bound) log.save_halfedge(m_, x.in);
    for (const unsigned v : c.verts) log.save_vert(m_, v);
    for (const unsigned p : c.polys) log.save_poly(m_, p);
  }
  /// These meshes have no properties of this library.
  template<class Visit> void save_values(const Visit&) const {}
  void add_removed_vert(unsigned v) { log.add_removed_vert(v); }
  void add_removed_edge(unsigned e) { log.add_removed_edge(e); }
  void add_removed_poly(unsigned p) { log.add_removed_poly(p); }

  void roll_back(std::size_t to_step) noexcept { log.roll_back(m_, points_, to_step); }
  void undo() {
    K::reserve(m_, 1, 1, 1, false);  // revive() adds an element of each kind for a moment
    log.restore_before(m_, points_);
  }
  halfedge_log<K> changes() { return log.of_changes(m_, points_); }
  void redo(const halfedge_log<K>& after) { after.restore_after(m_, points_); }
};

/// What is known of the edits of a mesh, as edit_state of native meshes. The first number differs between meshes.
template<class K>
struct halfedge_edits {
  halfedge_recorder<K>* recorder = nullptr;
  std::uint64_t version, last_version;

  halfedge_edits()
      : version(static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count()) << 20),
        last_version(version) {}
};

/// Called after an edit. `edits` may be null.
template<class K>
void count_edit(halfedge_edits<K>* edits) noexcept {
  if (edits) edits->version = ++edits->last_version;
}

/// A value that a mesh stores as a property and that copies of the mesh do not have.
template<class T>
class uncopied {
  std::unique_ptr<T> value_;

 public:
  uncopied() = default;
  uncopied(const uncopied&) noexcept {}
  uncopied(uncopied&&) noexcept = default;
  uncopied& operator=(const uncopied&) noexcept { return *this; }  // a default value that is assigned to the property
                                                                   // changes nothing
  uncopied& operator=(uncopied&&) noexcept = default;
  ~uncopied() = default;

  T* get() const { return value_.get(); }
  T& get_or_make() {
    if (!value_) value_ = std::make_unique<T>();
    return *value_;
  }
};

/// The record of the open transaction, or null.
template<class K>
halfedge_recorder<K>* halfedge_recorder_of(typename K::mesh& m) {
  const halfedge_edits<K>* const edits = K::find_edits(m);
  return edits ? edits->recorder : nullptr;
}

/// What traits of meshes with points that can be written have for editing. Half-edges are linked here, since libraries
/// refuse polys that they could hold later. New edges take the places of removed ones, as in their own flips.
template<class K, unsigned Arity>
struct halfedge_editing {
  using mesh = typename K::mesh;
  using vert = typename K::vert;
  using poly = typename K::poly;

  static vert add_vert(mesh& m, const vec3& x) {
    const vec3 copy = x;  // x may be a point of m, which moves
    vert v;
    rewire(m, {.points = {&copy, &copy + 1}}, {&v, nullptr});
    return v;
  }
  static void rewire(mesh& m, const cavity_of<vert, poly>& c, const cavity_result_of<vert, poly>& made) {
    const auto set_point = [&, points = K::find_points(m)](unsigned v, std::size_t k) {
      K::assign_point(K::point_of(m, points, v), c.points[k]);
    };
    halfedge_edits<K>* const edits = K::find_edits(m);
    no_record none;
    if (edits && edits->recorder) rewire_halfedges<K>(m, c, Arity, *edits->recorder, set_point, made);
    else rewire_halfedges<K>(m, c, Arity, none, set_point, made);
    count_edit(edits);
  }
  static const char* why_not_rewire(const mesh& m, const cavity_of<vert, poly>& lists) {
    const halfedge_cavity<K> c(m, lists, Arity);
    return halfedge_plan<K>(m, c).refused.why;
  }
  static auto& edits(mesh& m) { return K::edits_of(m); }
  static auto* edits_if_any(mesh& m) { return K::find_edits(m); }
};
struct no_halfedge_editing {};

/// Edits of one element as replacements.
template<class M>
poly_t<M> add_poly_by_rewire(M& m, std::span<const vert_t<M>> corners) {
  std::vector<unsigned> all(corners.size());
  for (unsigned k = 0; k < all.size(); ++k) all[k] = k;
  const auto n = static_cast<unsigned>(all.size());
  poly_t<M> p;
  traits<M>::rewire(
      m, {.verts = {corners.data(), corners.data() + n}, .corners = {all.data(), all.data() + n}, .ends = {&n, &n + 1}},
      {nullptr, &p});
  return p;
}
template<class M>
void remove_poly_by_rewire(M& m, const poly_t<M>& p) {
  std::vector<vert_t<M>> all;
  for (const vert_t<M> v : traits<M>::adj_p2v(m, p)) all.push_back(v);
  traits<M>::rewire(m, {.polys = {&p, &p + 1}, .verts = {all.data(), all.data() + all.size()}}, {});
}
template<class M>
void remove_vert_by_rewire(M& m, const vert_t<M>& v) {
  traits<M>::rewire(m, {.verts = {&v, &v + 1}, .removed = 1}, {});
}

[[noreturn]] inline void refuse_garbage_collection() {
  throw unsupported(
      "garbage_collect: elements cannot be renumbered while a transaction is open; call it before or after");
}

}  // namespace concino::detail
