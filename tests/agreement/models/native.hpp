// Models: the six native meshes. Each is compared with a native mesh without fixed arity.
#pragma once

#include <agreement/run.hpp>

namespace concino::agreement {

template<class K> inline constexpr const char* name_of_kind = nullptr;
template<> inline constexpr const char* name_of_kind<trimesh> = "trimesh";
template<> inline constexpr const char* name_of_kind<quadmesh> = "quadmesh";
template<> inline constexpr const char* name_of_kind<polygonmesh> = "polygonmesh";
template<> inline constexpr const char* name_of_kind<tetmesh> = "tetmesh";
template<> inline constexpr const char* name_of_kind<hexmesh> = "hexmesh";
template<> inline constexpr const char* name_of_kind<polyhedralmesh> = "polyhedralmesh";

/// A mesh M constructed from the arrays of kind K.
template<class K, class M = K>
struct native {
  using kind = K;
  static constexpr const char* column = name_of_kind<M>;
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = true;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    auto m = [&] {
      if constexpr (std::same_as<K, M>) return M(in.arrays);
      else return general_copy(K(in.arrays));
    }();
    remove_elements(m, in.gone_polys, in.gone_verts);
    f(std::as_const(m));
  }
};

using native_surfaces = models<native<trimesh>, native<quadmesh>, native<polygonmesh>, native<trimesh, polygonmesh>>;
using native_volumes = models<native<tetmesh>, native<hexmesh>, native<polyhedralmesh>, native<tetmesh, polyhedralmesh>>;

}  // namespace concino::agreement
