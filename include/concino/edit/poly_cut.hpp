// Cuts a polygon along a chord between two of its verts, or a polyhedron along a closed loop of its edges.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/edit/face_cut.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// What poly_cut has made, which is valid only if it was allowed: the edge or face between two polys.
template<class M> struct poly_cut_result;
template<SurfaceMesh M>
struct poly_cut_result<M> : permission {
  edge_t<M> edge{};
  std::array<poly_t<M>, 2> polys{poly_t<M>{}, poly_t<M>{}};
};
template<VolumeMesh M>
struct poly_cut_result<M> : permission {
  face_t<M> face{};
  std::array<poly_t<M>, 2> polys{poly_t<M>{}, poly_t<M>{}};
};

namespace detail {

inline constexpr permission no_loop{refusal::wrong_set,
                                    "the edges are not those of one closed loop that divides the polyhedron into two"};
inline constexpr permission small_part{refusal::degenerate, "a polyhedron would have fewer than four faces"};

template<class M>
permission polygon_cut_cavity(const M& m, const poly_t<M>& p, const vert_t<M>& a, const vert_t<M>& b,
                              general_cavity<M>& c) {
  c.add_old(p);
  std::array<std::vector<unsigned>, 2> parts;
  if (!cut_list(c.old_polys().list(0), c.vert(a), c.vert(b), parts)) return no_chord;
  for (const auto& part : parts) c.add_list(part), c.end_new(0);
  return are_joined_by_edge(m, a, b) ? general_same_verts : permission{};
}

/// The new face of one part of the faces, counter-clockwise seen from outside it. Returns false if these do not run
/// once along each edge of the loop, or it is not one cycle.
inline bool close_part(std::span<const std::span<const unsigned>> lists, const std::vector<unsigned>& part,
                       unsigned wanted, std::span<const std::pair<unsigned, unsigned>> loop,
                       std::vector<unsigned>& face) {
  std::vector<std::pair<unsigned, unsigned>> next;  // against the faces of the part
  for (unsigned i = 0; i < lists.size(); ++i) {
    if (part[i] != wanted) continue;
    for_each_edge_of(lists[i], [&](unsigned a, unsigned b) {
      if (std::binary_search(loop.begin(), loop.end(), std::pair{std::min(a, b), std::max(a, b)}))
        next.emplace_back(b, a);
    });
  }
  std::sort(next.begin(), next.end());
  if (next.size() != loop.size()) return false;
  face.clear();
  for (unsigned at = next.front().first; face.size() < next.size();) {
    const auto i = std::lower_bound(next.begin(), next.end(), std::pair{at, 0u});
    if (i == next.end() || i->first != at) return false;
    face.push_back(at), at = i->second;
    if (at == face.front()) break;
  }
  return face.size() == next.size();
}

template<class M>
permission polyhedron_cut_cavity(const M& m, const poly_t<M>& p, std::span<const edge_t<M>> edges,
                                 general_cavity<M>& c) {
  c.add_old(p);
  std::vector<std::span<const unsigned>> lists;
  for (std::size_t i = 0; i < c.old_polys().num_lists(); ++i) lists.push_back(c.old_polys().list(i));
  std::vector<std::pair<unsigned, unsigned>> loop;
  for (const edge_t<M>& e : edges) {
    unsigned ends[2] = {}, n = 0;
    for (const vert_t<M> v : adj_e2v(m, e)) ends[n++] = c.find_vert(index_of(m, v));
    if (ends[0] == core::local_numbers::none || ends[1] == core::local_numbers::none) return no_loop;
    loop.emplace_back(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
  }
  std::sort(loop.begin(), loop.end());
  if (loop.size() < 3 || std::adjacent_find(loop.begin(), loop.end()) != loop.end()) return no_loop;
  std::vector<unsigned> part;
  if (find_parts(lists, loop, part) != 2) return no_loop;
  std::array<std::vector<unsigned>, 2> faces;
  for (unsigned k = 0; k < 2; ++k)
    if (!close_part(lists, part, k, loop, faces[k])) return no_loop;
  for (unsigned k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < lists.size(); ++i)
      if (part[i] == k) c.add_list(lists[i]);
    c.add_list(faces[k]);
    c.end_new(0);
  }
  // a part of one face has the verts of the new one
  return std::min(std::count(part.begin(), part.end(), 0u), std::count(part.begin(), part.end(), 1u)) < 3
             ? small_part
             : permission{};
}

/// The facet that both polys have.
template<class M>
facet_t<M> facet_between(const M& m, const poly_t<M>& p, const poly_t<M>& q) {
  for (const facet_t<M> f : adj_p2facet(m, p))
    for (const poly_t<M> x : adj_facet2p(m, f))
      if (x == q) return f;
  return facet_t<M>{};
}

template<class M>
poly_cut_result<M> cut_poly(M& m, const permission& before, const edit_options& options, const general_cavity<M>& c) {
  poly_cut_result<M> r;
  static_cast<permission&>(r) = before ? allow_general(options.keep, c) : before;
  if (!r) return r;
  typename general_cavity<M>::prepared x;
  c.apply(m, x);
  r.polys = {x.polys[0], x.polys[1]};
  if constexpr (SurfaceMesh<M>) r.edge = facet_between(m, x.polys[0], x.polys[1]);  // the facet by its name
  else r.face = facet_between(m, x.polys[0], x.polys[1]);
  return r;
}

}  // namespace detail

/// Whether polygon p can be cut between a and b: they are verts of it, not neighbours and not joined by an edge, and
/// the invariants hold.
/// Needs:  EditableSurfaceMesh M that is an EditableGeneralMesh, a poly and verts of m.
/// Result: true, or the reason.      Cost: the polys at a and at one vert of each part.      Errors: as poly_cut.
template<EditableSurfaceMesh M>
  requires EditableGeneralMesh<M>
permission can_poly_cut(const M& m, poly_t<M> p, vert_t<M> a, vert_t<M> b, const edit_options& options = {}) {
  detail::check_element(m, p, "can_poly_cut", "poly");
  detail::check_element(m, a, "can_poly_cut", "vert");
  detail::check_element(m, b, "can_poly_cut", "vert");
  detail::general_cavity<M> c(m);
  if (const permission x = detail::polygon_cut_cavity(m, p, a, b, c); !x) return x;
  return detail::allow_general(options.keep, c);
}

/// Cuts polygon p along the chord between a and b. merge_polys of the new edge is the inverse.
/// Needs:  EditableSurfaceMesh M that is an EditableGeneralMesh.
/// Result: the edge and the two polys, or the reason why not. The first poly, which has the verts from a on to b in the
///         order of adj_p2v, has the descriptor of p. All other descriptors remain valid. If p is not convex, parts may
///         overlap; no_inversion refuses some of these.
/// Cost:   that of can_poly_cut, and the elements at the verts of p, but O(mesh) the first time.
/// Errors: invalid_mesh if p, a or b is not an element of m, and what an invariant throws. The mesh is unchanged then,
///         also if memory runs out.
template<EditableSurfaceMesh M>
  requires EditableGeneralMesh<M>
poly_cut_result<M> poly_cut(M& m, poly_t<M> p, vert_t<M> a, vert_t<M> b, const edit_options& options = {}) {
  detail::check_element(m, p, "poly_cut", "poly");
  detail::check_element(m, a, "poly_cut", "vert");
  detail::check_element(m, b, "poly_cut", "vert");
  detail::general_cavity<M> c(m);
  const permission x = detail::polygon_cut_cavity(m, p, a, b, c);
  return detail::cut_poly(m, x, options, c);
}

/// Whether polyhedron p can be cut along a loop. Its edges are different ones of p, in any order. They form one closed
/// curve that divides the faces of p into two parts of at least three. No face has the verts of the loop, and the
/// invariants hold.
/// Needs:  EditableVolumeMesh M that is an EditableGeneralMesh, a poly and edges of m.
/// Result: true, or the reason.      Cost: sorting the edges of p, and the elements at some of its verts.
/// Errors: as poly_cut.
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
permission can_poly_cut(const M& m, poly_t<M> p, std::span<const std::type_identity_t<edge_t<M>>> loop,
                        const edit_options& options = {}) {
  detail::check_element(m, p, "can_poly_cut", "poly");
  for (const edge_t<M>& e : loop) detail::check_element(m, e, "can_poly_cut", "edge");
  detail::general_cavity<M> c(m);
  if (const permission x = detail::polyhedron_cut_cavity<M>(m, p, loop, c); !x) return x;
  return detail::allow_general(options.keep, c);
}
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
permission can_poly_cut(const M& m, poly_t<M> p, std::initializer_list<edge_t<M>> loop,
                        const edit_options& options = {}) {
  return can_poly_cut(m, p, std::span<const edge_t<M>>(loop.begin(), loop.size()), options);
}

/// Cuts polyhedron p by one new face along a loop. merge_polys of the new face is the inverse.
/// Needs:  EditableVolumeMesh M that is an EditableGeneralMesh.
/// Result: the face and the two polys, or the reason why not. The first poly, which has the first face of adj_p2f, has
///         the descriptor of p. All other descriptors remain valid. The volume of both together is that of p.
/// Cost:   that of can_poly_cut, and the elements at the verts of p, but O(mesh) the first time.
/// Errors: invalid_mesh if p or an edge is not an element of m, and what an invariant throws. The mesh is unchanged
///         then, also if memory runs out.
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
poly_cut_result<M> poly_cut(M& m, poly_t<M> p, std::span<const std::type_identity_t<edge_t<M>>> loop,
                            const edit_options& options = {}) {
  detail::check_element(m, p, "poly_cut", "poly");
  for (const edge_t<M>& e : loop) detail::check_element(m, e, "poly_cut", "edge");
  detail::general_cavity<M> c(m);
  const permission x = detail::polyhedron_cut_cavity<M>(m, p, loop, c);
  return detail::cut_poly(m, x, options, c);
}
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
poly_cut_result<M> poly_cut(M& m, poly_t<M> p, std::initializer_list<edge_t<M>> loop,
                            const edit_options& options = {}) {
  return poly_cut(m, p, std::span<const edge_t<M>>(loop.begin(), loop.size()), options);
}

// What to write instead of calls that cannot compile.
template<EditableMesh M, class... T>
  requires(arity_v<M> > 0)
void poly_cut(const M&, const T&...) = delete;  // fixed number of verts: make m a polygonmesh or polyhedralmesh

}  // namespace concino
