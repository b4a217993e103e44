// Collapses an edge: its two ends become one vert.
#pragma once

#include <concino/edit/detail/direct_edits.hpp>
#include <concino/edit/detail/link_condition.hpp>
#include <concino/edit/detail/polys/collapse_of_polys.hpp>
#include <concino/edit/detail/propose.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/core/number_text.hpp>

#include <optional>

namespace concino {

struct edge_collapse_options {
  std::vector<invariant> keep = {};  // see edit_options
  double at = 0.5;  // in [0, 1]: the remaining vert lies at (1 - at) a + at b, where a and b are the ends as end_verts
                    // lists them
  std::optional<vec3> point = {};  // if given, the remaining vert lies here; values of properties are interpolated by
                                   // `at`
  bool keeps_second = false;       // b remains instead of a
  bool only_simplices = false;     // whether other polys than triangles and tets refuse instead of losing a corner
};

namespace detail {

/// Old polys are those at the end that is removed, first the ones that the other end lacks; neighbours the other ones
/// at the end that remains.
template<class M>
permission edge_collapse_cavity(const M& m, const edge_t<M>& e, const edge_collapse_options& options,
                                cavity_builder<M>& c) {
  constexpr unsigned n = cavity_builder<M>::size - 1;
  auto ends = end_verts(m, e);
  if (options.keeps_second) std::swap(ends.first, ends.second);
  const unsigned a = c.vert(ends.first), b = c.vert(ends.second);
  simplex_list<n> link_a, link_b;
  simplex_list<n - 1> link_ab;
  const auto has = [&](const poly_t<M>& p, const vert_t<M>& v) {
    for (const vert_t<M> x : adj_p2v(m, p))
      if (x == v) return true;
    return false;
  };
  for (const poly_t<M> p : adj_v2p(m, ends.second)) {
    if constexpr (SurfaceMesh<M> && arity_v<M> == 0)  // a polygon may have both ends, but not e
      if (num_elements(adj_p2v(m, p)) != c.size) return not_simplices;
    if (!has(p, ends.first) && !c.add_old(p)) return not_simplices;
  }
  const unsigned moved = c.num_old();
  for (const poly_t<M> p : adj_e2p(m, e))
    if (!c.add_old(p)) return not_simplices;
  for (const poly_t<M> p : adj_v2p(m, ends.first))
    if (!has(p, ends.second) && !c.add_neighbour(p)) return not_simplices;
  for (unsigned k = 0; k < moved; ++k) {
    add_link_simplex<n>(link_b, c.corners(k), c.size, b, b);
    c.add_new(k, b, a);
  }
  for (unsigned k = moved; k < c.num_old(); ++k) {
    add_link_simplex<n>(link_a, c.corners(k), c.size, a, a);
    add_link_simplex<n>(link_b, c.corners(k), c.size, b, b);
    add_link_simplex<n - 1>(link_ab, c.corners(k), c.size, a, b);
  }
  for (unsigned k = c.num_old(); k < c.num_polys(); ++k) add_link_simplex<n>(link_a, c.corners(k), c.size, a, a);
  c.keep(moved);
  const double t = options.keeps_second ? 1 - options.at : options.at;
  c.merge(a, b, t);
  if (!can_collapse<n>(link_a, link_b, link_ab, c.num_verts())) return breaks_link_condition;
  const vec3 x = to_vec3(point(m, ends.first)), y = to_vec3(point(m, ends.second));
  if (options.point || t > 0) c.move(a, options.point ? *options.point : point_between(x, y, t));
  return {};
}

template<class M>
collapse_of_polys<M> collapse_at(const M& m, const edge_t<M>& e, const edge_collapse_options& options) {
  const auto ends = end_verts(m, e);
  if (options.keeps_second) return {m, ends.second, ends.first, 1 - options.at, options.point};
  return {m, ends.first, ends.second, options.at, options.point};
}

inline void check_collapse(const edge_collapse_options& options, const char* edit) {
  if (!(options.at >= 0 && options.at <= 1))
    core::throw_joined<invalid_argument>(
        {edit, ": options.at is ", core::number_text(options.at), "; it must be in [0, 1]"});
  if (options.point && !is_finite(*options.point))
    core::throw_joined<invalid_argument>({edit, ": options.point is not finite"});
}

}  // namespace detail

/// Whether e can be collapsed without a change of the topology: the link condition holds. Boundaries, non-manifold
/// edges and non-manifold verts are kept.
/// Needs:  EditableMesh M, an edge of m.
/// Result: true, or the reason. The link condition does not hold, as for the last triangle or tet of a part. Two faces
///         or two polys would have the same verts. Two polys, each at one end, would share more than a chain of edges
///         or a disk of faces. A polyhedron that is no tet would keep fewer than four faces. A poly at an end is one of
///         a quadmesh or hexmesh. An invariant does not hold.
/// Cost:   the polys at the ends, and sorting these; of general polys also the pairs of them that share a vert.
/// Errors: as edge_collapse.
/// Source: Dey, Edelsbrunner, Guha and Nekhayev 1999, "Topology preserving edge contraction".
template<EditableMesh M>
permission can_edge_collapse(const M& m, edge_t<M> e, const edge_collapse_options& options = {}) {
  detail::check_element(m, e, "can_edge_collapse", "edge");
  detail::check_collapse(options, "can_edge_collapse");
  detail::cavity_builder<M> c(m);
  const permission p = detail::edge_collapse_cavity(m, e, options, c);
  if constexpr (EditableGeneralMesh<M>)
    if (!options.only_simplices && p.reason == refusal::not_simplices)
      return detail::collapse_at(m, e, options).propose(options.keep);
  if (!p) return p;
  return detail::ask(options.keep, m, c);
}

/// Collapses e: its first end remains, or its second one if the options say so. The other end and the triangles or tets
/// at e are removed. Other polys at e, and their faces, lose a corner, and triangles at e that are faces vanish.
/// Needs:  EditableMesh M.
/// Result: the remaining vert, or the reason why not. The other polys at the removed end keep their descriptors, and
///         their corners there are now at the remaining end; they are those that vert_split needs to undo the collapse.
///         Other descriptors remain valid, apart from those of the removed end, of e, of the polys at e, and of one of
///         each two edges or faces that become one, which is that of the removed end.
/// Cost:   that of can_edge_collapse, and the elements at the verts of the polys at the removed end, but O(mesh) the
///         first time.
/// Errors: invalid_mesh if e is not an edge of m; invalid_argument if options.at is not in [0, 1] or options.point is
///         not finite. The mesh is unchanged then, also if memory runs out.
template<EditableMesh M>
vert_result<M> edge_collapse(M& m, edge_t<M> e, const edge_collapse_options& options = {}) {
  detail::check_element(m, e, "edge_collapse", "edge");
  detail::check_collapse(options, "edge_collapse");
  const auto ends = end_verts(m, e);
  const vert_t<M> kept = options.keeps_second ? ends.second : ends.first;
  detail::cavity_builder<M> c(m);
  const auto propose = [&] {
    const permission p = detail::edge_collapse_cavity(m, e, options, c);
    return p ? detail::ask(options.keep, m, c) : p;
  };
  permission allowed;
  if (!options.keep.empty()) allowed = propose();
  if constexpr (detail::collapses_edges<M>) {
    if (allowed && !options.keeps_second) {
      const vec3 at = options.point ? *options.point
                                    : detail::point_between(to_vec3(point(m, ends.first)),
                                                            to_vec3(point(m, ends.second)), options.at);
      if (traits<M>::collapse_edge(m, e, at)) return {{}, kept};
    }
  }
  if (options.keep.empty()) allowed = propose();
  if constexpr (EditableGeneralMesh<M>)
    if (!options.only_simplices && allowed.reason == refusal::not_simplices) {
      auto general = detail::collapse_at(m, e, options);
      if (const permission p = general.propose(options.keep); !p) return {p};
      general.apply(m);
      return {{}, kept};
    }
  if (!allowed) return {allowed};
  c.apply(m);
  return {{}, kept};
}

}  // namespace concino
