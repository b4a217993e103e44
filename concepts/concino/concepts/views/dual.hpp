// dual(m): the dual graph of a mesh and nothing else, to select the graph for algorithms that run on either one.
#pragma once

#include <concino/concepts/views/forward.hpp>

namespace concino {

namespace views {

template<DualGraph M>
class dual_view : public view_base<M> {
 public:
  using view_base<M>::view_base;
};

}  // namespace views

template<class M>
struct mesh_traits<views::dual_view<M>> : detail::forward_polys<views::dual_view<M>, M> {
  static constexpr bool is_view = true;
};

/// Needs:  DualGraph M. A mesh that owns its elements must outlive the view, so a temporary one is refused; of a view
///         it keeps a copy.
/// Result: models DualGraph, but no PrimalGraph: its nodes are the polys of m, joined if they share an edge (surface)
///         or a face (volume).
/// Cost:   none.
/// Errors: none.
template<DualGraph M> constexpr auto dual(const M& m) { return views::dual_view<M>(m); }
template<DualGraph M, class R = mistake::remedy<mistake::name_the_mesh>>
  requires(!is_view_v<M>)
void dual(const M&& m) = delete;  // give the mesh a name: auto m = ...;

// What to write instead of calls that cannot compile.
template<class... T> void dual(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
