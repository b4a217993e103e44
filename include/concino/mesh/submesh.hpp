// submesh(m, keep): a view of the polys of a mesh for which `keep` returns true, with their verts, edges and faces.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/mesh/detail/views/filtered.hpp>

namespace concino {

namespace views {

template<AnyMesh M>
class submesh_view : public partial_view<M> {
 public:
  using partial_view<M>::partial_view;
};

}  // namespace views

namespace detail {

template<class M>
struct submesh_traits : partial_view_traits<views::submesh_view<M>, M>,
                        forward_properties<views::submesh_view<M>, M>,
                        fixed_arity<arity_v<M>> {
  using V = views::submesh_view<M>;
  using base = partial_view_traits<V, M>;
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using poly = poly_t<M>;
  static constexpr int dimension = dimension_v<M>;

  static std::size_t num_polys(const V& m) { return m.elements().polys.count; }
  static std::size_t poly_index_bound(const V& m) { return concino::poly_index_bound(m.base()); }
  static std::size_t index_of(const V& m, const vert& x) { return concino::index_of(m.base(), x); }
  static std::size_t index_of(const V& m, const edge& x) { return concino::index_of(m.base(), x); }
  static std::size_t index_of(const V& m, const poly& x) { return concino::index_of(m.base(), x); }

  using base::contains;
  static bool contains(const V& m, const poly& x) { return base::is_visible(m, m.elements().polys, x); }

  static auto polys(const V& m) {
    return filtered([&]() -> decltype(auto) { return traits<M>::polys(m.base()); },
                    base::visible_in(m, m.elements().polys));
  }
  static auto adj_v2p(const V& m, const vert& v) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_v2p(m.base(), v); },
                    base::visible_in(m, m.elements().polys));
  }
  static auto adj_e2p(const V& m, const edge& e) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_e2p(m.base(), e); },
                    base::visible_in(m, m.elements().polys));
  }
  static auto adj_p2p(const V& m, const poly& p) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_p2p(m.base(), p); },
                    base::visible_in(m, m.elements().polys));
  }
  static decltype(auto) adj_p2v(const V& m, const poly& p) { return traits<M>::adj_p2v(m.base(), p); }
  static decltype(auto) adj_p2e(const V& m, const poly& p) { return concino::adj_p2e(m.base(), p); }
};

template<class M>
struct submesh_volume_traits : submesh_traits<M> {
  using base = submesh_traits<M>;
  using V = views::submesh_view<M>;
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using face = face_t<M>;
  using poly = poly_t<M>;

  static std::size_t num_faces(const V& m) { return m.elements().faces.count; }
  static std::size_t face_index_bound(const V& m) { return concino::face_index_bound(m.base()); }
  using base::index_of;
  static std::size_t index_of(const V& m, const face& x) { return concino::index_of(m.base(), x); }

  using base::contains;
  static bool contains(const V& m, const face& x) { return base::is_visible(m, m.elements().faces, x); }

  static auto faces(const V& m) {
    return filtered([&]() -> decltype(auto) { return traits<M>::faces(m.base()); },
                    base::visible_in(m, m.elements().faces));
  }
  static auto adj_v2f(const V& m, const vert& v) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_v2f(m.base(), v); },
                    base::visible_in(m, m.elements().faces));
  }
  static auto adj_e2f(const V& m, const edge& e) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_e2f(m.base(), e); },
                    base::visible_in(m, m.elements().faces));
  }
  static auto adj_f2p(const V& m, const face& f) {
    return filtered([&]() -> decltype(auto) { return traits<M>::adj_f2p(m.base(), f); },
                    base::visible_in(m, m.elements().polys));
  }
  static decltype(auto) adj_f2v(const V& m, const face& f) { return traits<M>::adj_f2v(m.base(), f); }
  static decltype(auto) adj_f2e(const V& m, const face& f) { return concino::adj_f2e(m.base(), f); }
  static decltype(auto) adj_p2f(const V& m, const poly& p) { return traits<M>::adj_p2f(m.base(), p); }
  static bool face_is_outward(const V& m, const poly& p, const face& f) {
    return concino::face_is_outward(m.base(), p, f);
  }
};

}  // namespace detail

template<class M>
struct mesh_traits<views::submesh_view<M>>
    : std::conditional_t<VolumeMesh<M>, detail::submesh_volume_traits<M>, detail::submesh_traits<M>> {};

/// Needs:  AnyMesh M; keep(p) says whether poly p is in the view; it is called once for each. A mesh that owns its
///         elements must outlive the view, so a temporary one is refused; of a view it keeps a copy.
/// Result: a mesh of the same kind with the kept polys and their verts, edges and faces. Its descriptors and indices
///         are those of m, and it has the named properties of m, if there are any. It does not follow later changes of
///         m.
/// Cost:   O(elements of m) time; five bits per vert, edge, face and poly, which copies of the view share.
/// Errors: those of keep.
template<AnyMesh M, class Keep>
  requires requires(const Keep& keep, const poly_t<M>& p) { { keep(p) } -> std::convertible_to<bool>; }
auto submesh(const M& m, const Keep& keep) {
  auto s = std::make_shared<detail::visible_elements>(detail::visible_elements{
      detail::element_mask(vert_index_bound(m)), detail::element_mask(edge_index_bound(m)), detail::element_mask(0),
      detail::element_mask(poly_index_bound(m)), detail::element_mask(vert_index_bound(m))});
  if constexpr (VolumeMesh<M>) s->faces = detail::element_mask(face_index_bound(m));  // surfaces have no faces
  for (const auto p : polys(m)) {
    if (!keep(p)) continue;
    s->polys.set(index_of(m, p));
    for (const auto v : adj_p2v(m, p)) s->verts.set(index_of(m, v));
    for (const auto e : adj_p2e(m, p)) s->edges.set(index_of(m, e));
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      for (const auto f : adj_p2f(m, p)) s->faces.set(index_of(m, f));
  }
  detail::mark_whole_verts(m, *s);
  return views::submesh_view<M>(m, std::move(s));
}
template<AnyMesh M, class Keep, class R = mistake::remedy<mistake::name_the_mesh>>
  requires(!is_view_v<M>)
void submesh(const M&& m, const Keep& keep) = delete;  // give the mesh a name: auto m = ...;

// What to write instead of calls that cannot compile.
template<class... T> void submesh(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
