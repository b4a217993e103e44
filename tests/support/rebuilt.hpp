// Checks edited meshes: they obey all laws, and equal a mesh that is newly constructed from their polys.
#pragma once

#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::testing {

template<class M>
void keeps_all_laws(const M& m) {
  for (const auto& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what << " [" << b.witness << "]");
}

template<class R>
std::vector<unsigned> raw(const R& range) {
  std::vector<unsigned> all;
  for (const auto x : range) all.push_back(x.raw());
  return all;
}
template<class R>
std::set<unsigned> raw_set(const R& range) {
  const std::vector<unsigned> l = raw(range);
  return {l.begin(), l.end()};
}

template<class M, class R>
std::vector<unsigned> indices(const M& m, const R& range) {
  std::vector<unsigned> all;
  for (const auto x : range) all.push_back(static_cast<unsigned>(index_of(m, x)));
  return all;
}
template<class M, class R>
std::set<unsigned> index_set(const M& m, const R& range) {
  const std::vector<unsigned> l = indices(m, range);
  return {l.begin(), l.end()};
}

/// A new native mesh of the polys of m, on the same verts, and the indices that these polys have in m. It is of the kind of m, or polygonal if m is another library's.
template<class M>
auto rebuilt(const M& m) {
  using native = std::conditional_t<HasProperties<M>, M, polygonmesh>;
  std::vector<vec3> points(vert_index_bound(m));
  for (const auto v : verts(m)) points[index_of(m, v)] = to_vec3(point(m, v));
  const std::vector<unsigned> old = indices(m, polys(m));
  if constexpr (std::same_as<M, polyhedralmesh>) {
    std::vector<std::vector<unsigned>> face_verts;
    std::map<unsigned, unsigned> fresh;
    for (const auto f : faces(m)) fresh[f.raw()] = static_cast<unsigned>(face_verts.size()), face_verts.push_back(raw(adj_f2v(m, f)));
    std::vector<std::vector<std::pair<unsigned, bool>>> poly_faces;
    for (const unsigned p : old) {
      poly_faces.emplace_back();
      for (const auto f : adj_p2f(m, poly_id{p})) poly_faces.back().emplace_back(fresh[f.raw()], face_is_outward(m, poly_id{p}, f));
    }
    return std::pair{M(points, face_verts, poly_faces), old};
  } else {
    std::vector<std::vector<unsigned>> poly_verts;
    for (const auto p : polys(m)) poly_verts.push_back(indices(m, adj_p2v(m, p)));
    return std::pair{native(points, poly_verts), old};
  }
}

/// Compares all adjacency of two surfaces, with the order of all lists.
template<class M>
void has_same_adjacency(const M& m, const M& other) {
  REQUIRE(raw(verts(m)) == raw(verts(other)));
  REQUIRE(raw(edges(m)) == raw(edges(other)));
  REQUIRE(raw(polys(m)) == raw(polys(other)));
  bool verts_agree = true, edges_agree = true, polys_agree = true;
  for (const auto v : verts(m)) verts_agree &= raw(adj_v2v(m, v)) == raw(adj_v2v(other, v)) && raw(adj_v2e(m, v)) == raw(adj_v2e(other, v)) && raw(adj_v2p(m, v)) == raw(adj_v2p(other, v));
  for (const auto e : edges(m)) edges_agree &= raw(adj_e2v(m, e)) == raw(adj_e2v(other, e)) && raw(adj_e2p(m, e)) == raw(adj_e2p(other, e));
  for (const auto p : polys(m)) polys_agree &= raw(adj_p2v(m, p)) == raw(adj_p2v(other, p)) && raw(adj_p2e(m, p)) == raw(adj_p2e(other, p)) && raw(adj_p2p(m, p)) == raw(adj_p2p(other, p));
  CHECK(verts_agree);
  CHECK(edges_agree);
  CHECK(polys_agree);
}

template<class M>
void equals_rebuilt(const M& m) {
  const auto [fresh, old] = rebuilt(m);
  CHECK(num_edges(m) == num_edges(fresh));
  if constexpr (VolumeMesh<M>) CHECK(num_faces(m) == num_faces(fresh));
  for (const auto v : verts(m)) CHECK(index_set(m, adj_v2v(m, v)) == raw_set(adj_v2v(fresh, vert_id(index_of(m, v)))));
  unsigned i = 0;
  for (const auto p : polys(m)) {
    const poly_id q{i++};
    std::set<unsigned> across;
    for (const auto x : adj_p2p(fresh, q)) across.insert(old[x.raw()]);
    CHECK(index_set(m, adj_p2p(m, p)) == across);
    CHECK(index_set(m, adj_p2v(m, p)) == raw_set(adj_p2v(fresh, q)));
  }
}

}  // namespace concino::testing
