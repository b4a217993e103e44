// One step of root-3 subdivision.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/generate/detail/subdivide/smooth_rules.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>
#include <concino/mesh/trimesh.hpp>

#include <initializer_list>

namespace concino::detail {

/// A step. Even steps divide sharp edges into three; each triangle has at most one such edge then, because the step
/// before was an odd one.
template<class M, class Creases>
class root3_stepper {
  static constexpr std::uint32_t none = ~0u;

  /// The two verts on a sharp edge, next to its first and second end.
  struct thirds {
    vert_id near_first, near_second;
  };

  const char* caller_;
  const M& m_;
  const sharp_edges<M, Creases> sharp_;
  const bool divides_sharp_;
  refined_verts<M, refined_kinds{}> refined_;
  std::vector<vert_id> centre_;      // by index of a poly; a triangle with a divided edge has none
  std::vector<thirds> thirds_;       // of divided edges
  std::vector<std::uint32_t> slot_;  // by index of an edge: of its thirds, or `none`
  surface_arrays a_{{}, {}, {}, 3};
  std::vector<vert_id> near_;        // by third: the end of its edge next to it
  element_origins verts_, linear_, polys_;  // those of verts with the weights of their points, and as if they were
                                            // means
  std::vector<origin> list_;                // of one vert
  const bool wanted_;

  /// Where a triangle ends towards each of its edges: at its centre, or at one of the thirds of its divided edge.
  struct triangle {
    triangle_elements<M> parts;
    std::array<vert_id, 3> ends{};
    std::size_t divided = 3;  // which edge
  };
  triangle read(const poly_t<M>& p) const {
    triangle t{triangle_elements<M>(caller_, m_, p)};
    for (std::size_t k = 0; k < 3; ++k)
      if (slot_[index(t.parts.edges[k])] != none) t.divided = k;
    t.ends.fill(centre_[index(p)]);
    if (t.divided != 3) {
      const auto [x, y] = thirds_along(t, t.divided);
      t.ends[(t.divided + 1) % 3] = y;
      t.ends[(t.divided + 2) % 3] = x;
    }
    return t;
  }
  /// The thirds of edge k of a triangle, in the direction of the triangle.
  std::array<vert_id, 2> thirds_along(const triangle& t, std::size_t k) const {
    const thirds& s = thirds_[slot_[index(t.parts.edges[k])]];
    if (end_verts(m_, t.parts.edges[k]).first == t.parts.verts[k]) return {s.near_first, s.near_second};
    return {s.near_second, s.near_first};
  }

  /// rule(take) calls take(v, weight) for each vert of which the new vert is a mean; `linear` are its origins without
  /// smoothing.
  template<class Rule>
  vert_id add_vert(const Rule& rule, std::initializer_list<origin> linear) {
    vec3 x;
    list_.clear();
    rule([&](const vert_t<M>& v, double weight) {
      x += weight * to_vec3(point(m_, v));
      if (wanted_) list_.push_back({index(v), weight});
    });
    if (wanted_) {
      verts_.add(list_);
      linear_.add(linear);
    }
    a_.points.push_back(x);
    return vert_id{a_.points.size() - 1};
  }
  template<class X>
  std::uint32_t index(const X& x) const {
    return static_cast<std::uint32_t>(index_of(m_, x));
  }
  void add_poly(vert_id a, vert_id b, vert_id c, const poly_t<M>& p, const poly_t<M>& q) {
    a_.verts.insert(a_.verts.end(), {a, b, c});
    if (!wanted_) return;
    if (p == q) polys_.add(index(p));
    else polys_.add({{index(p), 0.5}, {index(q), 0.5}});
  }

  template<class Take>
  void take_vert(const vert_t<M>& v, const Take& take) const {
    const auto at = sharp_(v);
    if (at.edges > 0 && at.sharp < 2) {
      const double n = static_cast<double>(at.edges), moved = (4 - 2 * std::cos(2 * std::numbers::pi / n)) / 9;
      take(v, 1 - moved);
      for (const vert_t<M> w : adj_v2v(m_, v)) take(w, moved / n);
    } else if (divides_sharp_ && at.sharp == 2) {
      take(v, 19.0 / 27), take(at.ends[0], 4.0 / 27), take(at.ends[1], 4.0 / 27);
    } else {
      take(v, 1.0);
    }
  }
  /// The vert on a sharp edge next to `from`.
  template<class Take>
  void take_third(const vert_t<M>& from, const vert_t<M>& to, const Take& take) const {
    const auto at = sharp_(from);
    if (at.sharp == 2)
      take(at.ends[0] == to ? at.ends[1] : at.ends[0], 1.0 / 27), take(from, 16.0 / 27), take(to, 10.0 / 27);
    else take(from, 2.0 / 3), take(to, 1.0 / 3);
  }

  void add_verts() {
    for (const vert_t<M> v : verts(m_)) add_vert([&](const auto& take) { take_vert(v, take); }, {{index(v)}});
    std::vector<edge_t<M>> divided;
    slot_.assign(edge_index_bound(m_), none);
    if (divides_sharp_)
      for (const edge_t<M> e : edges(m_))
        if (sharp_[e]) {
          slot_[index(e)] = static_cast<std::uint32_t>(divided.size());
          divided.push_back(e);
        }
    centre_.resize(poly_index_bound(m_));
    for (const poly_t<M> p : polys(m_)) {
      const triangle_elements<M> t(caller_, m_, p);
      bool is_divided = false;
      for (const edge_t<M>& e : t.edges) is_divided = is_divided || slot_[index(e)] != none;
      if (is_divided) continue;
      const auto rule = [&](const auto& take) {
        for (const vert_t<M>& v : t.verts) take(v, 1.0 / 3);
      };
      centre_[index(p)] = add_vert(rule, {{index(t.verts[0])}, {index(t.verts[1])}, {index(t.verts[2])}});
    }
    for (const edge_t<M>& e : divided) {
      const auto ends = end_verts(m_, e);
      thirds_.push_back({add_third(ends.first, ends.second), add_third(ends.second, ends.first)});
    }
  }
  vert_id add_third(const vert_t<M>& from, const vert_t<M>& to) {
    near_.push_back(refined_[from]);
    return add_vert([&](const auto& take) { take_third(from, to, take); },
                    {{index(from), 2.0 / 3}, {index(to), 1.0 / 3}});
  }

  /// A triangle seen from one of its edges.
  struct triangle_at {
    vert_id from, to, end;
    poly_t<M> poly{};
    bool is_set = false;
  };
  triangle_at at_edge(const triangle& t, const edge_t<M>& e, const poly_t<M>& p) const {
    std::size_t k = 0;
    while (k < 2 && t.parts.edges[k] != e) ++k;
    return {refined_[t.parts.verts[k]], refined_[t.parts.verts[(k + 1) % 3]], t.ends[k], p, true};
  }

  void add_polys() {
    for (const edge_t<M> e : edges(m_)) {
      const bool stays = sharp_[e];
      if (stays && slot_[index(e)] != none) continue;
      triangle_at first{}, second{};
      for (const poly_t<M> p : adj_e2p(m_, e)) {
        const triangle_at here = at_edge(read(p), e, p);
        if (stays) add_poly(here.from, here.to, here.end, p, p);
        (first.is_set ? second : first) = here;
      }
      if (stays) continue;
      add_poly(first.from, second.end, first.end, first.poly, second.poly);
      add_poly(second.end, first.to, first.end, first.poly, second.poly);
    }
    for (const poly_t<M> p : polys(m_)) {
      if (thirds_.empty()) break;
      const triangle t = read(p);
      if (t.divided == 3) continue;
      const auto [x, y] = thirds_along(t, t.divided);
      add_poly(x, y, refined_[t.parts.verts[(t.divided + 2) % 3]], p, p);
    }
  }

 public:
  root3_stepper(const char* caller, const M& m, const Creases& creases, bool divides_sharp, bool wanted)
      : caller_(caller), m_(m), sharp_{m, creases}, divides_sharp_(divides_sharp), refined_(m), wanted_(wanted) {
    a_.points.reserve(num_verts(m) + num_polys(m));
    a_.verts.reserve(9 * num_polys(m));
    add_verts();
    add_polys();
  }

  subdivided<trimesh> result(const subdivide_options& o) && {
    const std::size_t first_third = a_.points.size() - 2 * thirds_.size();
    subdivided<trimesh> r{trimesh(std::move(a_))};
    if (wanted_) {
      r.from.polys = std::move(polys_);
      set_origins(m_, std::move(linear_), std::move(verts_), o, r);
    }
    if constexpr (!std::is_same_v<Creases, no_creases>) {
      for (const edge_id e : edges(r.mesh)) {
        const auto ends = end_verts(r.mesh, e);
        r.has_crease.push_back(is_on_crease(ends.first.raw(), ends.second.raw(), first_third));
      }
    }
    return r;
  }

 private:
  /// Whether the edge between two new verts is a crease, or a third of one. A crease that is not divided is the only
  /// kind of edge between old verts.
  bool is_on_crease(std::size_t a, std::size_t b, std::size_t first_third) const {
    if (a > b) std::swap(a, b);
    if (b < first_third) return !divides_sharp_ && b < refined_.size();
    const std::size_t k = b - first_third;
    if (a >= first_third) return (a - first_third) / 2 == k / 2;
    return near_[k].raw() == a;
  }
};

template<class M, class Creases>
subdivided<trimesh> root3_step(const char* caller, const M& m, const Creases& creases, const subdivide_options& o,
                               bool divides_sharp) {
  check_subdivided_counts<trimesh>(caller, static_cast<double>(num_verts(m) + num_polys(m) + num_edges(m)),
                                   3.0 * static_cast<double>(num_polys(m)));
  return root3_stepper<M, Creases>(caller, m, creases, divides_sharp, wants_origins(m, o)).result(o);
}

}  // namespace concino::detail
