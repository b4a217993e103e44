// primal(m): the primal graph of a mesh and nothing else, to select the graph for algorithms that run on either one.
#pragma once

#include <concino/concepts/views/forward.hpp>

namespace concino {

namespace views {

template<PrimalGraph M>
class primal_view : public view_base<M> {
 public:
  using view_base<M>::view_base;
};

}  // namespace views

template<class M>
struct mesh_traits<views::primal_view<M>> : detail::forward_verts<views::primal_view<M>, M>,
                                            detail::forward_points<views::primal_view<M>, M> {
  static constexpr bool is_view = true;
};

/// Needs:  PrimalGraph M. A mesh that owns its elements must outlive the view, so a temporary one is refused; of a view
///         it keeps a copy.
/// Result: models PrimalGraph, and Embedded if M does, but no DualGraph. Its descriptors are those of m.
/// Cost:   none.
/// Errors: none.
template<PrimalGraph M> constexpr auto primal(const M& m) { return views::primal_view<M>(m); }
template<PrimalGraph M, class R = mistake::remedy<mistake::name_the_mesh>>
  requires(!is_view_v<M>)
void primal(const M&& m) = delete;  // give the mesh a name: auto m = ...;

// What to write instead of calls that cannot compile.
template<class... T> void primal(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
