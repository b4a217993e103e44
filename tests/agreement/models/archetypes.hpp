// Models: archetypes, which restrict a native mesh to one concept, so that algorithms cannot use more than they require.
#pragma once

#include <agreement/run.hpp>

#include <concino/concepts/archetypes.hpp>

namespace concino::agreement {

struct strip_to_primal_graph {
  static constexpr const char* name = "only_primal_graph";
  template<class M> auto operator()(const M& m) const { return only_primal_graph(m); }
};
struct strip_to_embedded_graph {
  static constexpr const char* name = "only_embedded_graph";
  template<class M> auto operator()(const M& m) const { return only_embedded_graph(m); }
};
struct strip_to_dual_graph {
  static constexpr const char* name = "only_dual_graph";
  template<class M> auto operator()(const M& m) const { return only_dual_graph(m); }
};
struct strip_to_mesh {
  static constexpr const char* name = "only_mesh";
  template<class M> auto operator()(const M& m) const { return only_mesh(m); }
};
struct strip_to_embedded_mesh {
  static constexpr const char* name = "only_embedded_mesh";
  template<class M> auto operator()(const M& m) const { return only_embedded_mesh(m); }
};
struct strip_to_fixed_arity {
  static constexpr const char* name = "only_fixed_arity_mesh";
  template<class M> auto operator()(const M& m) const { return only_fixed_arity_mesh(m); }
};

template<class K, class Strip>
struct archetype {
  using kind = K;
  static constexpr const char* column = "archetypes";
  static constexpr const char* name = Strip::name;
  static constexpr bool any_surface = true, gaps = true;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    K m(in.arrays);
    remove_elements(m, in.gone_polys, in.gone_verts);
    const archetypes::owner<decltype(Strip()(m))> weak(m);  // owns its elements and cannot be copied
    f(weak);
  }
};

using surface_archetypes = models<archetype<trimesh, strip_to_primal_graph>, archetype<polygonmesh, strip_to_embedded_graph>, archetype<quadmesh, strip_to_dual_graph>,
                                  archetype<polygonmesh, strip_to_mesh>, archetype<polygonmesh, strip_to_embedded_mesh>, archetype<trimesh, strip_to_fixed_arity>>;
using volume_archetypes = models<archetype<tetmesh, strip_to_embedded_graph>, archetype<hexmesh, strip_to_dual_graph>, archetype<polyhedralmesh, strip_to_mesh>,
                                 archetype<polyhedralmesh, strip_to_embedded_mesh>, archetype<tetmesh, strip_to_fixed_arity>>;

}  // namespace concino::agreement
