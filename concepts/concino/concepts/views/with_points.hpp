// with_points(m, map): a mesh whose coordinates are the values of a map. It replaces or adds points.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/views/forward.hpp>

namespace concino {

namespace views {

/// P is the map itself, or a const reference to it.
template<PrimalGraph M, class P>
class with_points_view : public view_base<M> {
  static constexpr bool by_reference = std::is_reference_v<P>;
  using kept = std::conditional_t<by_reference, const std::remove_cvref_t<P>*, std::remove_cvref_t<P>>;
  kept points_;

 public:
  constexpr with_points_view(const M& m, const std::remove_cvref_t<P>& points)
    requires by_reference
      : view_base<M>(m), points_(&points) {}
  constexpr with_points_view(const M& m, std::remove_cvref_t<P>&& points) requires(!by_reference)
      : view_base<M>(m), points_(static_cast<std::remove_cvref_t<P>&&>(points)) {}
  constexpr const auto& points() const {
    if constexpr (by_reference) return *points_;
    else return points_;
  }
};

}  // namespace views

template<class M, class P>
struct mesh_traits<views::with_points_view<M, P>> : detail::forward_all<views::with_points_view<M, P>, M>,
                                                    detail::forward_properties<views::with_points_view<M, P>, M>,
                                                    detail::fixed_arity<arity_v<M>> {
  static constexpr bool is_view = true;
  static decltype(auto) point(const views::with_points_view<M, P>& m, const vert_t<M>& v) { return m.points()[v]; }
};

/// Needs:  PrimalGraph M; points[v] is a point p with p[0], p[1], p[2] for each vert v. A mesh that owns its elements
///         must outlive the view, so a temporary one is refused. A map that is an lvalue must outlive it too; a
///         temporary map is stored in the view.
/// Result: models what M models, and Embedded. Its descriptors are those of m, and it has the named properties of m, if
///         there are any.
/// Cost:   none; copying the view copies a map that is stored in it.
/// Errors: none.
template<PrimalGraph M, class P>
  requires requirement::gives_points<P, vert_t<M>>
constexpr auto with_points(const M& m, P&& points) {
  if constexpr (std::is_lvalue_reference_v<P>)
    return views::with_points_view<M, const std::remove_cvref_t<P>&>(m, points);
  else return views::with_points_view<M, std::remove_cvref_t<P>>(m, static_cast<P&&>(points));
}
template<PrimalGraph M, class P, class R = mistake::remedy<mistake::name_the_mesh>>
  requires(!is_view_v<M>)
void with_points(const M&& m, P&& points) = delete;  // give the mesh a name: auto m = ...;

// What to write instead of calls that cannot compile.
template<class... T> void with_points(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
