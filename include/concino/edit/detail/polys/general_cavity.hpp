// Collects the cavity of an edit of polys with any number of verts: old polys and new ones, as lists of corners.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/detail/polys/poly_lists.hpp>
#include <concino/edit/proposed_edit.hpp>
#include <concino/edit/replace_polys.hpp>

#include <cmath>
#include <span>
#include <vector>

namespace concino::detail {

/// All verts have local numbers, in the order in which they are met; new ones have `new_vert`, `new_vert` + 1, ...
template<class M>
class general_cavity {
  const M* m_;
  core::local_numbers numbers_, poly_numbers_;
  std::vector<vert_t<M>> verts_;
  std::vector<poly_t<M>> polys_;        // old polys, then neighbours: polys that stay, at a vert that remains of two
  std::vector<facet_t<M>> faces_;       // of the lists of these, in volumes
  poly_lists old_, new_;                // of these; of the new polys, then, if the vert moves, of neighbours
  std::vector<poly_origin> origins_;    // of new polys
  std::vector<vec3> points_;
  std::vector<std::vector<origin>> vert_origins_;  // of new verts: local numbers
  std::vector<unsigned> removed_;
  std::vector<replaced_vert> replaced_verts_;
  unsigned kept_vert_ = none, moved_ = none;
  std::size_t num_old_ = 0, num_new_ = 0;
  vec3 moved_to_;

  template<class T>
  static id_span<T> ids(const std::vector<T>& v) { return {v.data(), v.data() + v.size()}; }

  void read(const poly_t<M>& p) {
    if constexpr (SurfaceMesh<M>) {  // a polygon is one list
      for (const vert_t<M> v : adj_p2v(*m_, p)) old_.add_corner(vert(v));
      old_.end_list();
    } else {
      for (const face_t<M> f : adj_p2f(*m_, p)) {
        for (const vert_t<M> v : adj_f2v(*m_, f)) old_.add_corner(vert(v));
        if (!face_is_outward(*m_, p, f)) old_.reverse_open_list();
        old_.end_list();
        faces_.push_back(f);
      }
    }
    old_.end_poly();
    polys_.push_back(p);
  }

 public:
  static constexpr unsigned none = proposed_edit::none, new_vert = 1u << 31;

  explicit general_cavity(const M& m) : m_(&m) {}

  const M& mesh() const { return *m_; }
  unsigned vert(const vert_t<M>& v) {
    const unsigned i = numbers_.add(index_of(*m_, v));
    if (i == verts_.size()) verts_.push_back(v);
    return i;
  }
  unsigned find_vert(std::size_t index) const { return numbers_.find(index); }
  unsigned find_poly(std::size_t index) const { return poly_numbers_.find(index); }
  /// Adds an old poly. Returns its number.
  unsigned add_old(const poly_t<M>& p) {
    const unsigned k = poly_numbers_.add(index_of(*m_, p));
    if (k == num_old_) read(p), ++num_old_;
    return k;
  }
  /// Adds a poly that stays, at a vert that remains of two; it may move. Old and new polys come before.
  void add_neighbour(const poly_t<M>& p) {
    read(p);
    if (moved_ == none) return;
    const std::size_t k = polys_.size() - 1;
    for (std::size_t i = old_.first_list(k); i < old_.last_list(k); ++i) new_.add_list(old_.list(i));
    new_.end_poly();
    origins_.push_back({static_cast<unsigned>(k), 1});
  }

  const poly_lists& old_polys() const { return old_; }
  const poly_lists& new_polys() const { return new_; }
  /// The number of lists of old polys, without those of neighbours.
  std::size_t num_old_lists() const { return num_old_ == 0 ? 0 : old_.last_list(num_old_ - 1); }
  unsigned num_old() const { return static_cast<unsigned>(num_old_); }
  std::size_t num_new() const { return num_new_; }
  unsigned num_polys() const { return static_cast<unsigned>(polys_.size()); }
  unsigned num_verts() const { return static_cast<unsigned>(verts_.size()); }
  const poly_t<M>& poly(std::size_t k) const { return polys_[k]; }
  const vert_t<M>& vert_at(unsigned i) const { return verts_[i]; }
  bool has(std::size_t k, unsigned v) const { return old_.has(k, v); }
  /// The face of list i of old polys, in volumes.
  const facet_t<M>& face(std::size_t i) const { return faces_[i]; }
  const std::vector<poly_origin>& origins() const { return origins_; }
  const std::vector<vec3>& points() const { return points_; }
  unsigned removed_vert() const { return removed_.empty() || kept_vert_ == none ? none : removed_.front(); }
  unsigned kept_vert() const { return kept_vert_; }
  unsigned moved_vert() const { return moved_; }
  const vec3& moved_to() const { return moved_to_; }
  vec3 point_of(unsigned v) const {
    return v >= new_vert ? points_[v - new_vert] : to_vec3(concino::point(*m_, verts_[v]));
  }

  /// Adds a new vert, which has the values of these verts with these weights. Returns its number.
  unsigned add_point(const vec3& x, std::vector<origin> from) {
    points_.push_back(x), vert_origins_.push_back(std::move(from));
    return new_vert + static_cast<unsigned>(points_.size() - 1);
  }
  void add_list(std::span<const unsigned> list) { new_.add_list(list); }
  /// Ends a new poly, which comes from `count` old ones. It has the descriptor of the first of these, unless an earlier
  /// new poly has it; those that have one come first.
  void end_new(unsigned first, unsigned count = 1) {
    new_.end_poly();
    origins_.push_back({first, count});
    ++num_new_;
  }
  /// Removes a vert, which no new poly has.
  void remove(unsigned v) { removed_.push_back(v); }
  /// Removes vert b, which becomes one with a.
  void merge(unsigned a, unsigned b) { kept_vert_ = a, removed_.push_back(b); }
  void move(unsigned v, const vec3& x) { moved_ = v, moved_to_ = x; }
  /// Says what becomes of a vert, in edits that replace several at once.
  void replace_vert(const replaced_vert& x) { replaced_verts_.push_back(x); }
  const std::vector<replaced_vert>& replaced_verts() const { return replaced_verts_; }

  /// The lists of the new polys with verts in the order of the cavity.
  struct prepared {
    std::vector<poly_t<M>> replaced, polys;
    std::vector<vert_t<M>> verts, new_verts;
    std::vector<unsigned> corners, ends, poly_ends;
    correspondence from;
    cavity<M> lists;
  };
  /// Allocates what the edit needs.
  void prepare(prepared& x) const {
    std::vector<unsigned char> goes(verts_.size(), 0), is_taken(polys_.size(), 0);
    std::vector<unsigned> number(verts_.size());
    for (const unsigned v : removed_) goes[v] = 1;
    for (unsigned v = 0; v < verts_.size(); ++v)
      if (!goes[v]) number[v] = static_cast<unsigned>(x.verts.size()), x.verts.push_back(verts_[v]);
    for (const unsigned v : removed_) x.verts.push_back(verts_[v]);
    const auto num_verts = static_cast<unsigned>(verts_.size());
    for (std::size_t k = 0; k < num_new_; ++k) {
      for (const unsigned v : new_.corners_of(k))
        x.corners.push_back(v >= new_vert ? num_verts + (v - new_vert) : number[v]);
      const unsigned first = origins_[k].first;
      if (!is_taken[first] && x.replaced.size() == k) is_taken[first] = 1, x.replaced.push_back(polys_[first]);
    }
    const std::size_t kept = x.replaced.size();
    for (unsigned k = 0; k < num_old_; ++k)
      if (!is_taken[k]) x.replaced.push_back(polys_[k]);
    const std::size_t num_lists = num_new_ == 0 ? 0 : new_.last_list(num_new_ - 1);
    x.ends.assign(new_.ends().begin(), new_.ends().begin() + static_cast<std::ptrdiff_t>(num_lists));
    if constexpr (VolumeMesh<M>)  // faces end in corners, polys in faces
      x.poly_ends.assign(new_.poly_ends().begin(), new_.poly_ends().begin() + static_cast<std::ptrdiff_t>(num_new_));
    x.polys.resize(num_new_), x.new_verts.resize(points_.size());
    x.lists = {ids(x.replaced), ids(x.verts), ids(points_), ids(x.corners), ids(x.ends), ids(x.poly_ends),
               kept,            removed_.size()};
  }
  permission is_representable() const {
    if constexpr (says_why_not_rewire<M>) {
      prepared x;
      prepare(x);
      return detail::is_representable(*m_, x.lists);
    }
    return {};
  }

  /// The area or volume of a poly of these lists.
  double measure_of(const poly_lists& all, std::size_t k) const {
    vec3 area;
    double volume = 0;
    const vec3 origin = point_of(all.corners_of(k)[0]);
    for (std::size_t i = all.first_list(k); i < all.last_list(k); ++i) {
      const auto list = all.list(i);
      for (std::size_t j = 2; j < list.size(); ++j) {
        const vec3 a = point_of(list[0]) - origin, b = point_of(list[j - 1]) - origin,
                   c = point_of(list[j]) - origin;
        area += cross(b - a, c - a), volume += dot(a, cross(b, c));
      }
    }
    const double size = SurfaceMesh<M> ? norm(area) : std::abs(volume);  // of a polygon, or of a polyhedron
    return std::isfinite(size) ? size : 0;
  }

  /// Replaces the polys. Named properties follow, and an open transaction can undo it.
  void apply(M& m, prepared& x) const {
    prepare(x);
    std::vector<origin> list;
    for (const auto& from : vert_origins_) {
      list.clear();
      for (const origin o : from)
        list.push_back({static_cast<std::uint32_t>(index_of(m, verts_[o.index])), o.weight});
      x.from.verts.add(std::span<const origin>(list));
    }
    for (std::size_t k = 0; k < num_new_; ++k) {
      list.clear();
      const poly_origin& o = origins_[k];
      for (unsigned i = o.first; i < o.first + o.count; ++i)
        list.push_back({static_cast<std::uint32_t>(index_of(m, polys_[i])),
                        o.count > 1 ? measure_of(old_, i) : measure_of(new_, k)});
      x.from.polys.add(std::span<const origin>(list));
    }
    replace_polys(m, x.lists, cavity_result<M>{x.new_verts.data(), x.polys.data()}, x.from, {}, [] {});
  }
};

}  // namespace concino::detail
