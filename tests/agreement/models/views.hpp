// Models: views that are meshes: a submesh, the boundary of a volume, a mesh with other points.
#pragma once

#include <agreement/run.hpp>

#include <concino/concepts/views.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/submesh.hpp>

namespace concino::agreement {

/// The mesh as a submesh of one with twice as many polys.
template<class K>
struct part_of_a_mesh {
  using kind = K;
  static constexpr const char* column = "views";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = false;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    const K small(in.arrays);
    K m(in.arrays);
    std::vector<vert_id> copy(vert_index_bound(m));
    for (const auto v : verts(small)) {
      if (!(adj_v2p(small, v).begin() != adj_v2p(small, v).end())) return;  // a submesh has no isolated verts
      copy[v.raw()] = add_vert(m, point(small, v) + vec3{0, 0, 9});
    }
    const auto first = num_polys(m);
    for (const auto p : polys(small)) {
      std::vector<vert_id> corners;
      for (const auto v : adj_p2v(small, p)) corners.push_back(copy[v.raw()]);
      add_poly(m, std::span<const vert_id>(corners));
    }
    const auto part = submesh(m, [&](poly_id p) { return p.raw() < first; });
    f(part);
  }
};

/// The boundary of a volume. Its native reference is a copy of it, so this only checks that algorithms run on it. tests/mesh/boundary_test.cpp checks
/// that the boundary itself is right.
template<class K, class Volume>
struct boundary_of {
  using kind = K;
  static constexpr const char* column = "views";
  static constexpr const char* name = "boundaries";
  static constexpr bool any_surface = true, gaps = false;
  static constexpr bool own_inputs = true;

  template<class F>
  static void each(F&& f) {
    const Volume m(crooked(testing::grid_arrays<Volume>(2)));
    const auto surface = boundary(m);
    f(input<surface_arrays>{"boundary", {}, true, true}, general_copy(surface), surface);
  }
};

/// A mesh with points from a map instead of its own.
template<class K>
struct moved {
  using kind = K;
  static constexpr const char* column = "views";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = true;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    K m(in.arrays);
    remove_elements(m, in.gone_polys, in.gone_verts);
    auto x = make_vert_map<vec3>(m);
    for (const auto v : verts(m)) {
      x[v] = point(m, v);
      set_point(m, v, vec3{7, 7, 7});
    }
    const auto view = with_points(m, x);
    f(view);
  }
};

using mesh_views = models<part_of_a_mesh<polygonmesh>, part_of_a_mesh<tetmesh>, boundary_of<trimesh, tetmesh>, moved<quadmesh>>;

}  // namespace concino::agreement
