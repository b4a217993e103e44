// Compares the results of algorithms on a mesh and on the native mesh to which it is converted.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/core/message.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/testing/detail/adjacencies.hpp>
#include <concino/validate/broken_law.hpp>

#include <cmath>
#include <exception>
#include <type_traits>

namespace concino::testing::detail {

inline bool near(double a, double b) { return a == b || std::abs(a - b) <= 1e-9 * (1 + std::abs(a) + std::abs(b)); }

/// KIT5: algorithms give the same results as on the mesh converted to a native mesh.
template<EmbeddedMesh M>
void check_against_native(const M& m, concino::detail::law_log& log) {
  using native = std::conditional_t<dimension_v<M> == 2, polygonmesh, polyhedralmesh>;
  const auto c = convert_with_correspondence<native>(m, {.properties = false});
  const auto differ = [&](const std::string& what, const std::string& witness = "") {
    log.add("KIT5",
            concino::core::joined({what, " differs from the same mesh converted to ",
                                   dimension_v<M> == 2 ? "polygonmesh" : "polyhedralmesh"}),
            witness);
  };
  const auto same = [&](const char* what, const auto& elements, char letter, const auto& values,
                        const auto& native_values, const auto& of) {
    for (const auto x : elements)
      if (!near(static_cast<double>(values[x]), static_cast<double>(native_values[of(x)])))
        return differ(what, name(letter, index_of(m, x)));
  };
  const auto vert_of = [&](const vert_t<M>& v) { return c.vert_of(v); };
  const auto poly_of = [&](const poly_t<M>& p) { return c.poly_of(p); };

  if (num_edges(m) != num_edges(c.mesh)) differ("the number of edges");
  if constexpr (dimension_v<M> == 3)  // surfaces have no faces
    if (num_faces(m) != num_faces(c.mesh)) differ("the number of faces");
  if (!near(total_measure(m), total_measure(c.mesh))) differ("total_measure");
  if (connected_components(m).count != connected_components(c.mesh).count) differ("the number of components");
  for (const vert_t<M> v : verts(m)) {
    same("bfs from a vert", verts(m), 'v', bfs(m, v), bfs(c.mesh, c.vert_of(v)), vert_of);
    same("dijkstra from a vert", verts(m), 'v', dijkstra(m, v), dijkstra(c.mesh, c.vert_of(v)), vert_of);
    break;
  }
  for (const poly_t<M> p : polys(m)) {
    same("bfs from a poly", polys(m), 'p', bfs(m, p), bfs(c.mesh, c.poly_of(p)), poly_of);
    same("dijkstra from a poly", polys(m), 'p', dijkstra(m, p), dijkstra(c.mesh, c.poly_of(p)), poly_of);
    // a field that is 0 and 1 at two verts of the poly; in components that contain neither, one vert has the value 0
    std::vector<std::pair<vert_t<M>, double>> prescribed;
    std::vector<std::pair<vert_id, double>> also;
    const auto component = connected_components(m);
    std::vector<bool> has(static_cast<std::size_t>(component.count), false);
    const auto prescribe = [&](const vert_t<M>& v, double x) {
      prescribed.emplace_back(v, x);
      also.emplace_back(c.vert_of(v), x);
      has[static_cast<std::size_t>(component[v])] = true;
    };
    double x = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      if (x < 2) prescribe(v, x);
      ++x;
    }
    for (const vert_t<M> v : verts(m))
      if (!has[static_cast<std::size_t>(component[v])]) prescribe(v, 0);
    same("harmonic_map", verts(m), 'v', harmonic_map(m, prescribed, uniform), harmonic_map(c.mesh, also, uniform),
         vert_of);
    break;
  }
}

}  // namespace concino::testing::detail
