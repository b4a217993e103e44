// boundary(m): the surface of a volume mesh, as a surface mesh.
#pragma once

#include <concino/concepts/derived.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/detail/views/filtered.hpp>

#include <cstdint>

namespace concino {

namespace views {

/// A surface whose polys are faces of M. A face whose verts run clockwise seen from outside in M has its verts and
/// edges stored here in reversed order.
template<VolumeMesh M>
class boundary_view : public partial_view<M> {
 public:
  struct turned_faces {
    std::vector<vert_t<M>> verts;
    std::vector<edge_t<M>> edges;
    std::vector<std::size_t> first;  // by face index, one more than the bound; empty if no face is reversed
  };

  boundary_view(const M& m, std::shared_ptr<const detail::visible_elements> elements,
                std::shared_ptr<const turned_faces> turned)
      : partial_view<M>(m, std::move(elements)), turned_(std::move(turned)) {}
  const turned_faces& turned() const { return *turned_; }

 private:
  std::shared_ptr<const turned_faces> turned_;
};

}  // namespace views

namespace detail {

/// The verts or edges, X, of a face, in the order of the mesh or reversed.
template<class M, class X, class Verb>
class outward_ring {
  using ring = decltype(std::declval<const Verb&>()(std::declval<const M&>(), std::declval<face_t<M>>()));
  using base_iterator = decltype(std::declval<const std::remove_reference_t<ring>&>().begin());

  ring listed_;
  const X* first_ = nullptr;
  const X* last_ = nullptr;

 public:
  struct sentinel {};
  class iterator {
    const outward_ring* r_;
    base_iterator listed_;
    const X* turned_;

   public:
    explicit iterator(const outward_ring& r) : r_(&r), listed_(r.listed_.begin()), turned_(r.first_) {}
    X operator*() const { return turned_ ? *turned_ : X(*listed_); }
    iterator& operator++() {
      if (turned_) ++turned_;
      else ++listed_;
      return *this;
    }
    bool operator!=(sentinel) const { return turned_ ? turned_ != r_->last_ : listed_ != r_->listed_.end(); }
  };

  outward_ring(const views::boundary_view<M>& b, const face_t<M>& f, const Verb& verb, const std::vector<X>& turned)
      : listed_(verb(b.base(), f)) {
    const auto& t = b.turned();
    if (t.first.empty()) return;
    const std::size_t i = index_of(b.base(), f);
    if (t.first[i] == t.first[i + 1]) return;
    first_ = turned.data() + t.first[i];
    last_ = turned.data() + t.first[i + 1];
  }
  outward_ring(const outward_ring&) = delete;
  iterator begin() const { return iterator(*this); }
  sentinel end() const { return {}; }
};

}  // namespace detail

template<class M>
struct mesh_traits<views::boundary_view<M>> : detail::partial_view_traits<views::boundary_view<M>, M>,
                                              detail::fixed_arity<arity_v<M> == 4   ? 3
                                                                  : arity_v<M> == 8 ? 4
                                                                                    : 0> {
  using V = views::boundary_view<M>;
  using base = detail::partial_view_traits<V, M>;
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using poly = face_t<M>;
  static constexpr int dimension = 2;

  static std::size_t num_polys(const V& m) { return m.elements().faces.count; }
  static std::size_t poly_index_bound(const V& m) { return face_index_bound(m.base()); }
  static std::size_t index_of(const V& m, const vert& x) { return concino::index_of(m.base(), x); }
  static std::size_t index_of(const V& m, const edge& x) { return concino::index_of(m.base(), x); }
  static std::size_t index_of(const V& m, const poly& x) { return concino::index_of(m.base(), x); }

  using base::contains;
  static bool contains(const V& m, const poly& x) { return base::is_visible(m, m.elements().faces, x); }

  static auto polys(const V& m) {
    return detail::filtered([&]() -> decltype(auto) { return traits<M>::faces(m.base()); },
                            base::visible_in(m, m.elements().faces));
  }
  static auto adj_v2p(const V& m, const vert& v) {
    return detail::filtered([&]() -> decltype(auto) { return traits<M>::adj_v2f(m.base(), v); },
                            base::visible_in(m, m.elements().faces));
  }
  static auto adj_e2p(const V& m, const edge& e) {
    return detail::filtered([&]() -> decltype(auto) { return traits<M>::adj_e2f(m.base(), e); },
                            base::visible_in(m, m.elements().faces));
  }
  static auto adj_p2p(const V& m, const poly& p) {
    return detail::filtered([&]() -> decltype(auto) { return adj_f2f(m.base(), p); },
                            base::visible_in(m, m.elements().faces));
  }
  static auto adj_p2v(const V& m, const poly& p) {
    return detail::outward_ring<M, vert, adj_f2v_verb>(m, p, adj_f2v, m.turned().verts);
  }
  static auto adj_p2e(const V& m, const poly& p) {
    return detail::outward_ring<M, edge, adj_f2e_verb>(m, p, adj_f2e, m.turned().edges);
  }
};

/// Needs:  VolumeMesh M. A mesh that owns its elements must outlive the view, so a temporary one is refused; of a view
///         it keeps a copy.
/// Result: a SurfaceMesh (a TriMesh of tets, a QuadMesh of hexes) whose polys are the faces with exactly one poly,
///         wound counter-clockwise seen from outside that poly, and whose verts and edges are those of these faces.
///         Descriptors and indices are those of m, so a poly of the surface is a face_t<M>. The view does not follow
///         later changes of m.
/// Cost:   O(elements of m) time; four bits per vert, edge and face and the verts and edges of the reversed faces,
///         which copies share.
/// Errors: none of its own.
template<VolumeMesh M>
auto boundary(const M& m) {
  auto s = std::make_shared<detail::visible_elements>(detail::visible_elements{
      detail::element_mask(vert_index_bound(m)), detail::element_mask(edge_index_bound(m)),
      detail::element_mask(face_index_bound(m)), detail::element_mask(0), detail::element_mask(vert_index_bound(m))});
  auto turned = std::make_shared<typename views::boundary_view<M>::turned_faces>();
  std::vector<std::uint32_t> sizes;  // of the reversed faces, by face index
  for (const auto f : faces(m)) {
    if (!is_boundary(m, f)) continue;
    const auto& polys_of_f = adj_f2p(m, f);
    const poly_t<M> inside = *polys_of_f.begin();
    s->faces.set(index_of(m, f));
    std::uint32_t size = 0;
    for (const auto v : adj_f2v(m, f)) {
      s->verts.set(index_of(m, v));
      ++size;
    }
    for (const auto e : adj_f2e(m, f)) s->edges.set(index_of(m, e));
    if (face_is_outward(m, inside, f)) continue;
    sizes.resize(face_index_bound(m));
    sizes[index_of(m, f)] = size;
  }
  if (!sizes.empty()) {
    turned->first.reserve(sizes.size() + 1);
    turned->first.push_back(0);
    for (const std::uint32_t n : sizes) turned->first.push_back(turned->first.back() + n);
    turned->verts.resize(turned->first.back());
    turned->edges.resize(turned->first.back());
    for (const auto f : faces(m)) {
      const std::size_t i = index_of(m, f);
      std::size_t k = turned->first[i + 1];
      if (k == turned->first[i]) continue;
      for (const auto v : adj_f2v(m, f)) turned->verts[--k] = v;
      // The last edge joins the last vert and the first, also after reversal.
      const std::size_t end = turned->first[i + 1], last = end - 1;
      k = last;
      for (const auto e : adj_f2e(m, f)) turned->edges[k == turned->first[i] ? last : --k] = e;
    }
  }
  detail::mark_whole_verts(m, *s);
  return views::boundary_view<M>(m, std::move(s), std::move(turned));
}
template<VolumeMesh M, class R = mistake::remedy<mistake::name_the_mesh>>
  requires(!is_view_v<M>)
void boundary(const M&& m) = delete;  // give the mesh a name: auto m = ...;

// What to write instead of calls that cannot compile.
template<class... T> void boundary(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
