// What a caller wants smoothing to keep besides the boundary and sharp edges: edges that it names and what separates
// polys of different labels; and the surface and the edges that follow from it.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/convert/convert.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/remesh/detail/smoothing/feature_polylines.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// No edge is named; all polys have one label.
struct no_features {
  template<class E>
  bool operator()(const E&) const {
    return false;
  }
};

template<class M, class E, class L>
class kept_features {
  static constexpr bool names_edges = !std::is_same_v<E, no_features>, has_labels = !std::is_same_v<L, no_features>;

  const M& m_;
  const E& is_named_;
  const L& labels_;
  std::vector<unsigned> number_;  // by index of the vert

  decltype(auto) label(const poly_t<M>& p) const {
    if constexpr (requires { labels_[p]; }) return labels_[p];  // a map
    else return labels_(p);
  }

  /// Whether polys of different labels lie at x.
  bool is_interface(const facet_t<M>& x) const {
    if constexpr (has_labels) {
      poly_t<M> first{};
      unsigned n = 0;
      for (const poly_t<M> p : adj_facet2p(m_, x))
        if (n++ == 0) first = p;
        else if (!(label(p) == label(first))) return true;
    }
    return false;
  }

  bool is_kept(const edge_t<M>& e) const {
    if (is_named_(e)) return true;
    // the interfaces of volumes are faces
    if constexpr (dimension_v<M> == 2) return is_interface(e);
    return false;
  }

 public:
  kept_features(const M& m, const E& is_named, const L& labels)
      : m_(m), is_named_(is_named), labels_(labels), number_(vert_index_bound(m)) {
    unsigned n = 0;
    for (const vert_t<M> v : verts(m)) number_[index_of(m, v)] = n++;
  }

  unsigned number(const vert_t<M>& v) const { return number_[index_of(m_, v)]; }

  /// The edges that are named or, in surfaces, interfaces.
  vert_pairs edges_of_lines() const {
    vert_pairs found;
    // only edges that can be kept are visited: the interfaces of volumes are faces
    if constexpr (names_edges || (has_labels && dimension_v<M> == 2))
      for (const edge_t<M> e : edges(m_)) {
        if (!is_kept(e)) continue;
        const auto [a, b] = end_verts(m_, e);
        found.emplace_back(number(a), number(b));
      }
    return found;
  }

  /// Calls each(f) for the faces of a volume between polys of different labels.
  template<class F>
  void for_each_interface(const F& each) const {
    if constexpr (has_labels)
      for (const face_t<M> f : faces(m_))
        if (is_interface(f)) each(f);
  }

  /// The surface itself, or the boundary and the interfaces of a volume. Its verts are numbered as in verts(m).
  polygonmesh surface(const unit_points& unit) const {
    // only here a surface and a volume differ
    if constexpr (dimension_v<M> == 2) {
      auto s = convert<polygonmesh>(m_);
      for (const vert_id v : verts(s)) set_point(s, v, unit.at(s, v));
      return s;
    } else {
      surface_arrays a;
      for (const vert_t<M> v : verts(m_)) a.points.push_back(unit.at(m_, v));
      a.offsets.push_back(0);
      for (const face_t<M> f : faces(m_)) {
        if (!is_boundary(m_, f) && !is_interface(f)) continue;
        for (const vert_t<M> v : adj_f2v(m_, f)) a.verts.push_back(vert_id{number(v)});
        a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
      }
      return polygonmesh(std::move(a));
    }
  }
};

}  // namespace concino::detail
