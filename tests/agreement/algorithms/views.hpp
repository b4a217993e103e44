// Compares views of the mesh with the same views of the native mesh: primal, dual, with_points, submesh, and the boundary of a volume.
#pragma once

#include <agreement/algorithms/walk.hpp>

#include <concino/concepts/views.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/submesh.hpp>

namespace concino::agreement {

template<class N, class M, class In>
void walk_both(const N& n, const M& m, const In& in) { walk::check(matched<N, M>(n, m), in); }

struct thin_views {
  static constexpr const char* name = "views";
  template<class M> static constexpr bool runs_on = PrimalGraph<M> || DualGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    using M = typename B::other_mesh;
    if constexpr (PrimalGraph<M>) {
      walk_both(primal(both.native), primal(both.other), in);
      const auto moved = with_points(both.other, elsewhere<B>{&both});
      static_assert(Embedded<decltype(moved)>);
      for (const auto v : both.verts.all) expect(point(moved, both.verts.to(v))[1] == v.raw(), "with_points");
    }
    if constexpr (DualGraph<M>) walk_both(dual(both.native), dual(both.other), in);
    return true;
  }

 private:
  template<class B>
  struct elsewhere {
    const B* both;
    vec3 operator[](const vert_t<typename B::other_mesh>& v) const { return {0, double(both->verts.back(v).raw()), 0}; }
  };
};

struct parts_of_meshes {
  static constexpr const char* name = "submesh";
  template<class M> static constexpr bool runs_on = AnyMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    const auto keep = [](auto p) { return p.raw() % 3 != 1; };
    walk_both(submesh(both.native, keep), submesh(both.other, [&](const auto& p) { return keep(both.polys.back(p)); }), in);
    return true;
  }
};

struct boundaries {
  static constexpr const char* name = "boundary";
  template<class M> static constexpr bool runs_on = VolumeMesh<M>;

  /// The order of faces may differ, so the polys of the boundary surfaces are paired through the faces.
  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto n = boundary(both.native);
    const auto m = boundary(both.other);
    expect(std::size_t(num_polys(n)) == std::size_t(num_polys(m)) && std::size_t(num_verts(n)) == std::size_t(num_verts(m)) &&
               std::size_t(num_edges(n)) == std::size_t(num_edges(m)),
           "as many elements of the boundary");
    for (const auto f : polys(n)) {
      const auto& g = both.faces.to(f);
      expect(contains(m, g), "the same faces are of the boundary");
      expect(rotated(raw_numbers(adj_p2v(n, f))) == rotated(native_numbers(both.verts, adj_p2v(m, g))), "the verts of a polygon of the boundary");
      expect(sorted(raw_numbers(adj_p2p(n, f))) == sorted(native_numbers(both.faces, adj_p2p(m, g))), "the polygons around one of the boundary");
    }
    for (const auto v : verts(n))
      expect(sorted(raw_numbers(adj_v2p(n, v))) == sorted(native_numbers(both.faces, adj_v2p(m, both.verts.to(v)))), "the polygons at a vert of the boundary");
    return true;
  }
};

}  // namespace concino::agreement
