// Splits an edge at a point between its ends.
#pragma once

#include <concino/edit/detail/direct_edits.hpp>
#include <concino/edit/detail/polys/general_checks.hpp>
#include <concino/edit/detail/propose.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/core/number_text.hpp>

#include <vector>

namespace concino {

struct edge_split_options {
  std::vector<invariant> keep = {};  // see edit_options
  bool only_simplices = false;       // whether other polys than triangles and tets refuse instead of getting a corner
};

namespace detail {

/// The polys at e, each of which is replaced by two.
template<class M>
permission edge_split_cavity(const M& m, const edge_t<M>& e, double t, cavity_builder<M>& c) {
  const auto ends = end_verts(m, e);
  const unsigned a = c.vert(ends.first), b = c.vert(ends.second), split[] = {b, a};
  for (const poly_t<M> p : adj_e2p(m, e))
    if (!c.add_old(p)) return not_simplices;
  if (has_repeated_polys(c)) return polys_on_same_verts;
  const vec3 first = to_vec3(point(m, ends.first)), second = to_vec3(point(m, ends.second));
  c.add_point(point_between(first, second, t), {a, b, t});
  split_old_polys(c, split, 2);
  return {};
}

/// The polys at e, with the new vert between its ends.
template<class M>
permission general_split_cavity(const M& m, const edge_t<M>& e, double t, general_cavity<M>& c) {
  if constexpr (VolumeMesh<M>)  // surfaces have no faces
    if (is_any_loose(m, adj_e2f(m, e))) return loose_face_at_element;
  for (const poly_t<M> p : adj_e2p(m, e)) c.add_old(p);
  if (c.num_old() == 0) return {refusal::wrong_number, "the edge has no polys"};
  const auto ends = end_verts(m, e);
  const unsigned a = c.vert(ends.first), b = c.vert(ends.second);
  const unsigned x = c.add_point(point_between(c.point_of(a), c.point_of(b), t), {{a, 1 - t}, {b, t}});
  std::vector<unsigned> list;
  for (unsigned k = 0; k < c.num_old(); ++k) {
    for (std::size_t i = c.old_polys().first_list(k); i < c.old_polys().last_list(k); ++i) {
      list.clear();
      for_each_edge_of(c.old_polys().list(i), [&](unsigned from, unsigned to) {
        list.push_back(from);
        if ((from == a && to == b) || (from == b && to == a)) list.push_back(x);
      });
      c.add_list(list);
    }
    c.end_new(k);
  }
  return {};
}

/// Whether splitting e adds a corner to the polys at it instead of dividing them. simplices: whether these can be
/// divided. Tets that are general polyhedra are not.
template<class M>
bool adds_corners(const permission& simplices) {
  return dimension_v<M> == 3 || simplices.reason == refusal::not_simplices;
}

inline void check_parameter(double t, const char* edit) {
  if (!(t > 0 && t < 1))
    core::throw_joined<invalid_argument>(
        {edit, ": the parameter is ", core::number_text(t), "; it must be between 0 and 1"});
}

}  // namespace detail

/// Whether e can be split: no two polys at it have the same verts, and the invariants hold. Any number of polys is
/// allowed.
/// Needs:  as edge_split.      Result: true, or the reason.      Cost: O(polys at e).      Errors: as edge_split.
template<EditableMesh M>
  requires requirement::can_split_edges<M>
permission can_edge_split(const M& m, edge_t<M> e, double t = 0.5, const edge_split_options& options = {}) {
  detail::check_element(m, e, "can_edge_split", "edge");
  detail::check_parameter(t, "can_edge_split");
  detail::cavity_builder<M> c(m);
  const permission p = detail::edge_split_cavity(m, e, t, c);
  if constexpr (EditableGeneralMesh<M>)
    if (!options.only_simplices && detail::adds_corners<M>(p)) {
      detail::general_cavity<M> general(m);
      const permission x = detail::general_split_cavity(m, e, t, general);
      return x ? detail::allow_general(options.keep, general) : x;
    }
  if (!p) return p;
  return detail::ask(options.keep, m, c);
}

/// Splits e at (1 - t) a + t b, where a and b are its ends as end_verts lists them. If all polys at it are triangles of
/// a surface, or tets of a tetmesh, each is divided into two. Else the new vert becomes a corner of all of them, and of
/// their faces; edge_merge is the inverse.
/// Needs:  EditableMesh M whose polys are simplices, or may have any number of verts: quads are made polygons and hexes
///         polyhedra first, by convert<polygonmesh>(m) and convert<polyhedralmesh>(m). An edge of m; 0 < t < 1.
/// Result: the new vert, or the reason why not. Of each poly that is divided the half at a keeps the descriptor. Other
///         descriptors remain valid, apart from e and, in general polyhedra, the faces at it.
/// Cost:   the elements at the verts of the polys at e, but O(mesh) the first time.
/// Errors: invalid_mesh if e is not an edge of m; invalid_argument if t is not between 0 and 1. The mesh is unchanged
///         then, also if memory runs out.
template<EditableMesh M>
  requires requirement::can_split_edges<M>
vert_result<M> edge_split(M& m, edge_t<M> e, double t = 0.5, const edge_split_options& options = {}) {
  detail::check_element(m, e, "edge_split", "edge");
  detail::check_parameter(t, "edge_split");
  if constexpr (detail::splits_edges<M>)
    if (options.keep.empty()) {
      const auto ends = end_verts(m, e);
      const auto made = traits<M>::split_edge(
          m, e, detail::point_between(to_vec3(point(m, ends.first)), to_vec3(point(m, ends.second)), t));
      if (made) return {{}, *made};
    }
  detail::cavity_builder<M> c(m);
  const permission p = detail::edge_split_cavity(m, e, t, c);
  if constexpr (EditableGeneralMesh<M>)
    if (!options.only_simplices && detail::adds_corners<M>(p)) {
      detail::general_cavity<M> general(m);
      if (const permission x = detail::general_split_cavity(m, e, t, general); !x) return {x};
      if (const permission x = detail::allow_general(options.keep, general); !x) return {x};
      typename detail::general_cavity<M>::prepared x;
      general.apply(m, x);
      return {{}, x.new_verts.front()};
    }
  if (!p) return {p};
  if (const permission x = detail::ask(options.keep, m, c); !x) return {x};
  c.apply(m);
  return {{}, c.new_vert()};
}

// What to write instead of calls that cannot compile.
template<EditableMesh M, class... T>
  requires(!requirement::can_split_edges<M>)
void can_edge_split(const M&, const T&...) = delete;  // quads or hexes: make m a polygonmesh or polyhedralmesh
template<EditableMesh M, class... T>
  requires(!requirement::can_split_edges<M>)
void edge_split(const M&, const T&...) = delete;  // quads or hexes: make m a polygonmesh or polyhedralmesh

}  // namespace concino
