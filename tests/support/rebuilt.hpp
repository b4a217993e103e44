// Checks edited meshes: they obey all laws, and equal a mesh that is newly constructed from their polys.
#pragma once

#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <doctest/doctest.h>

#include <map>
#include <set>
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

/// A new mesh of the polys of m, on the same verts, and the names that these polys have in m.
template<class M>
std::pair<M, std::vector<unsigned>> rebuilt(const M& m) {
  std::vector<vec3> points(vert_index_bound(m));
  for (const auto v : verts(m)) points[v.raw()] = point(m, v);
  const std::vector<unsigned> old = raw(polys(m));
  if constexpr (std::same_as<M, polyhedralmesh>) {
    std::vector<std::vector<unsigned>> face_verts;
    std::map<unsigned, unsigned> fresh;
    for (const auto f : faces(m)) fresh[f.raw()] = static_cast<unsigned>(face_verts.size()), face_verts.push_back(raw(adj_f2v(m, f)));
    std::vector<std::vector<std::pair<unsigned, bool>>> poly_faces;
    for (const unsigned p : old) {
      poly_faces.emplace_back();
      for (const auto f : adj_p2f(m, poly_id{p})) poly_faces.back().emplace_back(fresh[f.raw()], face_is_outward(m, poly_id{p}, f));
    }
    return {M(points, face_verts, poly_faces), old};
  } else {
    std::vector<std::vector<unsigned>> poly_verts;
    for (const unsigned p : old) poly_verts.push_back(raw(adj_p2v(m, poly_id{p})));
    return {M(points, poly_verts), old};
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
  for (const auto v : verts(m)) CHECK(raw_set(adj_v2v(m, v)) == raw_set(adj_v2v(fresh, v)));
  for (unsigned i = 0; i < old.size(); ++i) {
    std::set<unsigned> across;
    for (const auto q : adj_p2p(fresh, poly_id{i})) across.insert(old[q.raw()]);
    CHECK(raw_set(adj_p2p(m, poly_id{old[i]})) == across);
    CHECK(raw_set(adj_p2v(m, poly_id{old[i]})) == raw_set(adj_p2v(fresh, poly_id{i})));
  }
}

}  // namespace concino::testing
