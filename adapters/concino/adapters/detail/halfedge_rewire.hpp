// Replaces polys of a half-edge mesh of another library at once, after a plan. The struct K of halfedge_edge_plan.hpp
// also has:
//
//   static void reserve(mesh&, unsigned verts, unsigned edges, unsigned polys, bool removes);  // then nothing below
//   fails static unsigned add_vert(mesh&), add_edge(mesh&), add_poly(mesh&);                         // the index
//   static void remove_vert(mesh&, unsigned), remove_edge(mesh&, unsigned), remove_poly(mesh&, unsigned);
#pragma once

#include <concino/adapters/detail/halfedge_plan.hpp>

namespace concino::detail {

/// Nothing is recorded: no transaction is open.
struct no_record {
  static constexpr bool records = false;
  template<class Plan, class Cavity> void save(const Plan&, const Cavity&) const {}
  void add_removed_vert(unsigned) const {}
  void add_removed_edge(unsigned) const {}
  void add_removed_poly(unsigned) const {}
};

/// Makes the changes of a plan.
template<class K, class Record>
class halfedge_change {
  using mesh = typename K::mesh;
  static constexpr unsigned none = ~0u;

  mesh& m_;
  const halfedge_cavity<K>& c_;
  const halfedge_plan<K>& plan_;
  Record& record_;
  const unsigned edge_bound_;
  core::small_array<unsigned, 32> removed_edges_, new_edges_;  // indices. Removed ones are taken for new ones as long
                                                               // as there are any
  core::small_array<unsigned, 32> new_verts_;
  core::small_array<unsigned, 32> new_polys_;

  /// The half-edge in the mesh of one in the plan.
  unsigned real(unsigned h) const {
    return h >> 1 < edge_bound_ ? h : 2 * new_edges_[(h >> 1) - edge_bound_] + (h & 1);
  }
  unsigned vert(unsigned local) const {
    return local < c_.num_verts() ? c_.verts[local] : new_verts_[local - c_.num_verts()];
  }

  void add_elements() {
    for (std::size_t i = 0; i < c_.num_new_verts; ++i) new_verts_.push_back(K::add_vert(m_));
    for (unsigned i = 0; i < plan_.num_new_edges; ++i)
      new_edges_.push_back(i < removed_edges_.size() ? removed_edges_[i] : K::add_edge(m_));
    for (std::size_t k = 0; k < c_.ends.size(); ++k) new_polys_.push_back(k < c_.kept ? c_.polys[k] : K::add_poly(m_));
  }
  void link_edges() {
    for (const unsigned e : removed_edges_)
      for (const unsigned h : {2 * e, 2 * e + 1}) K::set_poly(m_, h, none);
    for (const planned_edge& e : plan_.edges) {
      if (!e.remains()) continue;
      const unsigned h = real(e.halfedge);
      if (e.is_new) K::set_target(m_, h, vert(e.verts[1])), K::set_target(m_, h ^ 1, vert(e.verts[0]));
      for (const unsigned d : {0u, 1u})
        if (e.corner[d] == none && !e.has_other_poly[d]) K::set_poly(m_, h ^ d, none);
    }
  }
  void link_polys() {
    unsigned i = 0;
    for (std::size_t k = 0; k < c_.ends.size(); ++k) {
      for (; i < c_.ends[k]; ++i) {
        const unsigned h = real(plan_.corner_halfedges[i]);
        K::set_poly(m_, h, new_polys_[k]);
        K::set_next(m_, h, real(plan_.corner_halfedges[plan_.next_corner(i)]));
      }
      K::set_halfedge_of(m_, new_polys_[k], real(plan_.corner_halfedges[i - 1]));
    }
  }
  void link_verts() {
    for (const auto& x : plan_.border_links) K::set_next(m_, real(x.in), real(x.out));
    for (const auto& x : plan_.leaving)
      K::set_halfedge_from(m_, vert(x.vert), x.halfedge == none ? none : real(x.halfedge));
  }
  void remove_elements() {
    for (std::size_t i = plan_.num_new_edges; i < removed_edges_.size(); ++i)
      record_.add_removed_edge(removed_edges_[i]), K::remove_edge(m_, removed_edges_[i]);
    for (std::size_t k = c_.kept; k < c_.polys.size(); ++k)
      record_.add_removed_poly(c_.polys[k]), K::remove_poly(m_, c_.polys[k]);
    for (unsigned v = 0; v < c_.num_verts(); ++v)
      if (c_.is_removed(v)) record_.add_removed_vert(c_.verts[v]), K::remove_vert(m_, c_.verts[v]);
  }

 public:
  /// Allocates the memory that the change needs.
  halfedge_change(mesh& m, const halfedge_cavity<K>& c, const halfedge_plan<K>& plan, Record& record)
      : m_(m), c_(c), plan_(plan), record_(record), edge_bound_(K::num_edges(m)) {
    for (const planned_edge& e : plan.edges)
      if (!e.remains()) removed_edges_.push_back(e.halfedge >> 1);
    new_verts_.reserve(c.num_new_verts), new_edges_.reserve(plan.num_new_edges), new_polys_.reserve(c.ends.size());
    const auto removed = static_cast<unsigned>(removed_edges_.size());
    const bool removes = removed > plan.num_new_edges || c.polys.size() > c.kept || c.removed > 0;
    const unsigned spare = Record::records ? 1 : 0;  // see K::revive
    K::reserve(m, static_cast<unsigned>(c.num_new_verts) + spare,
               plan.num_new_edges - std::min(removed, plan.num_new_edges) + spare,
               static_cast<unsigned>(c.ends.size() - c.kept) + spare, removes);
    record.save(plan, c);
  }

  void make() noexcept {
    if constexpr (Record::records) {  // a removed element that is an element again after undoing must have its values
      const bool was_recycling = K::set_recycling(m_, false);
      add_elements();
      K::set_recycling(m_, was_recycling);
    } else {
      add_elements();
    }
    link_edges();
    link_polys();
    link_verts();
    remove_elements();
  }
  unsigned new_vert(std::size_t i) const { return new_verts_[i]; }
  unsigned new_poly(std::size_t k) const { return new_polys_[k]; }
};

/// Errors: unsupported if the library cannot represent the mesh that the plan leads to.
template<class K>
void check_representable(const halfedge_plan<K>& plan, const halfedge_cavity<K>& c) {
  const auto& x = plan.refused;
  if (!x.why) return;
  const auto name = [&](unsigned v) {
    return v < c.num_verts() ? core::joined({"vert ", c.verts[v]}) : core::joined({"new vert ", v - c.num_verts()});
  };
  if (x.other_vert == plan.none)
    core::throw_joined<unsupported>({"rewire: the polys at ", name(x.vert), " cannot be linked: ", x.why});
  core::throw_joined<unsupported>(
      {"rewire: the polys at the edge from ", name(x.vert), " to ", name(x.other_vert), " cannot be linked: ", x.why});
}

/// Calls set_point(index, k) for the k-th new vert, and writes the descriptors of new elements to `made`.
template<class K, class Record, class SetPoint>
void rewire_halfedges(typename K::mesh& m, const typename halfedge_cavity<K>::cavity& lists, unsigned arity,
                      Record& record, const SetPoint& set_point,
                      const cavity_result_of<typename K::vert, typename K::poly>& made) {
  const halfedge_cavity<K> c(m, lists, arity);
  const halfedge_plan<K> plan(m, c);
  check_representable(plan, c);
  halfedge_change<K, Record> change(m, c, plan, record);
  change.make();
  for (std::size_t i = 0; i < c.num_new_verts; ++i) {
    set_point(change.new_vert(i), i);
    if (made.verts) made.verts[i] = K::vert_at(change.new_vert(i));
  }
  if (made.polys)
    for (std::size_t k = 0; k < c.ends.size(); ++k) made.polys[k] = K::poly_at(change.new_poly(k));
}

}  // namespace concino::detail
