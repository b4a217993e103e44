// Lists the results of all verbs of a mesh as numbers. Two meshes with equal lists are indistinguishable to callers.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <vector>

namespace concino::testing {

/// A value that allocates memory.
struct value_with_memory {
  std::vector<int> numbers{1, 2, 3};
};

/// Adds properties of verts, edges, faces, polys and corners to m, of types that allocate and types that do not, with different values for every
/// element.
template<class M>
void give_properties(M& m) {
  const auto a = vert_property<double>(m, "a");
  const auto b = vert_property<value_with_memory>(m, "b");
  for (const auto v : verts(m)) a[v] = 0.5 + v.raw(), b[v].numbers[0] = static_cast<int>(v.raw());
  const auto c = edge_property<value_with_memory>(m, "c");
  for (const auto e : edges(m)) c[e].numbers[1] = static_cast<int>(e.raw());
  const auto d = poly_property<int>(m, "d");
  for (const auto p : polys(m)) d[p] = static_cast<int>(p.raw());
  const auto f = corner_property<value_with_memory>(m, "f");
  for (const auto p : polys(m))
    for (value_with_memory& x : f.of(p)) x.numbers[0] = static_cast<int>(p.raw());
  if constexpr (VolumeMesh<M>) {
    const auto e = face_property<value_with_memory>(m, "e");
    for (const auto x : faces(m)) e[x].numbers[2] = static_cast<int>(x.raw());
  }
}

/// Elements, index bounds, adjacencies in their order, points, and the values of give_properties(), if m has them.
template<class M>
std::vector<double> whole(const M& m) {
  std::vector<double> all;
  const auto number = [&](auto x) { all.push_back(static_cast<double>(x)); };
  const auto ring = [&](const auto& range) {
    number(-1);
    for (const auto x : range) number(x.raw());
  };
  const auto value = [&](const auto& map, auto x) {
    if (!map) return;
    if constexpr (requires { map[x].numbers; })
      for (const int i : map[x].numbers) number(i);
    else number(map[x]);
  };
  for (const std::size_t n : {num_verts(m), num_edges(m), num_polys(m), vert_index_bound(m), edge_index_bound(m), poly_index_bound(m)}) number(n);
  const auto a = find_vert_property<double>(m, "a");
  const auto b = find_vert_property<value_with_memory>(m, "b");
  for (const auto v : verts(m)) {
    number(v.raw());
    for (const std::size_t i : {0u, 1u, 2u}) number(point(m, v)[i]);
    ring(adj_v2v(m, v)), ring(adj_v2e(m, v)), ring(adj_v2p(m, v)), value(a, v), value(b, v);
  }
  const auto c = find_edge_property<value_with_memory>(m, "c");
  for (const auto e : edges(m)) number(e.raw()), ring(adj_e2v(m, e)), ring(adj_e2p(m, e)), value(c, e);
  const auto d = find_poly_property<int>(m, "d");
  for (const auto p : polys(m)) number(p.raw()), ring(adj_p2v(m, p)), ring(adj_p2e(m, p)), ring(adj_p2p(m, p)), value(d, p);
  if constexpr (VolumeMesh<M>) {
    number(num_faces(m)), number(face_index_bound(m));
    for (const auto v : verts(m)) ring(adj_v2f(m, v));
    for (const auto e : edges(m)) ring(adj_e2f(m, e));
    const auto g = find_face_property<value_with_memory>(m, "e");
    for (const auto f : faces(m)) number(f.raw()), ring(adj_f2v(m, f)), ring(adj_f2e(m, f)), ring(adj_f2p(m, f)), value(g, f);
    for (const auto p : polys(m)) {
      ring(adj_p2f(m, p));
      for (const auto f : adj_p2f(m, p)) number(face_is_outward(m, p, f));
    }
  }
  if (const auto h = find_corner_property<value_with_memory>(m, "f"))
    for (const auto p : polys(m))
      for (const value_with_memory& x : h.of(p))
        for (const int i : x.numbers) number(i);
  return all;
}

}  // namespace concino::testing
