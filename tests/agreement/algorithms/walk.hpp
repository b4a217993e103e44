// Compares elements, adjacencies, points and maps, on which all other algorithms depend.
#pragma once

#include <agreement/matched.hpp>

#include <concino/concepts/derived.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino::agreement {

struct walk {
  static constexpr const char* name = "walk";
  template<class M> static constexpr bool runs_on = PrimalGraph<M> || DualGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    const auto& n = both.native;
    const auto& m = both.other;
    if constexpr (PrimalGraph<M>) {
      expect(std::size_t(num_verts(m)) == both.verts.all.size(), "num_verts");
      same_sets(both, both.verts, both.verts, adj_v2v, "adj_v2v");
      for (const auto v : both.verts.all) expect(contains(m, both.verts.to(v)), "contains");
      check_map(make_vert_map<unsigned>(m), both.verts);
    }
    if constexpr (DualGraph<M>) {
      expect(std::size_t(num_polys(m)) == both.polys.all.size(), "num_polys");
      same_sets(both, both.polys, both.polys, adj_p2p, "adj_p2p");
      check_map(make_poly_map<unsigned>(m), both.polys);
    }
    if constexpr (AnyMesh<M>) {
      expect(std::size_t(num_edges(m)) == both.edges.all.size(), "num_edges");
      same_sets(both, both.verts, both.edges, adj_v2e, "adj_v2e");
      same_sets(both, both.verts, both.polys, adj_v2p, "adj_v2p");
      same_sets(both, both.edges, both.polys, adj_e2p, "adj_e2p");
      same_sets(both, both.edges, both.edges, adj_e2e, "adj_e2e");
      same_sets(both, both.polys, both.verts, adj_p2v, "adj_p2v");
      same_sets(both, both.polys, both.edges, adj_p2e, "adj_p2e");
      check_map(make_edge_map<unsigned>(m), both.edges);
      for (const auto p : both.polys.all)  // equal edges have their ends in the same order, from wherever they were reached
        for (const auto& e : adj_p2e(m, both.polys.to(p)))
          expect(native_numbers(both.verts, adj_e2v(m, e)) == native_numbers(both.verts, adj_e2v(m, both.edges.to(both.edges.back(e)))), "adj_e2v");
    }
    if constexpr (AnyMesh<M>) check_order(both);
    if constexpr (SurfaceMesh<M>) check_facets(both, both.edges);
    if constexpr (VolumeMesh<M>) check_facets(both, both.faces);
    if constexpr (SurfaceMesh<M>)
      for (const auto p : both.polys.all)
        expect(rotated(raw_numbers(adj_p2v(n, p))) == rotated(native_numbers(both.verts, adj_p2v(m, both.polys.to(p)))), "adj_p2v in cyclic order");
    if constexpr (VolumeMesh<M>) {
      expect(std::size_t(num_faces(m)) == both.faces.all.size(), "num_faces");
      same_sets(both, both.verts, both.faces, adj_v2f, "adj_v2f");
      same_sets(both, both.edges, both.faces, adj_e2f, "adj_e2f");
      same_sets(both, both.faces, both.edges, adj_f2e, "adj_f2e");
      same_sets(both, both.faces, both.polys, adj_f2p, "adj_f2p");
      same_sets(both, both.faces, both.faces, adj_f2f, "adj_f2f");
      same_sets(both, both.polys, both.faces, adj_p2f, "adj_p2f");
      check_map(make_face_map<unsigned>(m), both.faces);
      for (const auto p : both.polys.all)
        for (const auto f : adj_p2f(n, p)) {
          const auto& g = both.faces.to(f);
          const bool same_sense = rotated(raw_numbers(adj_f2v(n, f))) == rotated(native_numbers(both.verts, adj_f2v(m, g)));
          expect((face_is_outward(n, p, f) == bool(face_is_outward(m, both.polys.to(p), g))) == same_sense, "face_is_outward");
        }
    }
    if constexpr (Embedded<M> && PrimalGraph<M>)
      for (const auto v : both.verts.all) {
        const auto& x = point(n, v);
        const auto& y = point(m, both.verts.to(v));
        expect(x[0] == double(y[0]) && x[1] == double(y[1]) && x[2] == double(y[2]), "point");
      }
    return true;
  }

 private:
  /// Checks that the neighbours of each element are the same, each once, in any order.
  template<class B, class From, class To, class Verb>
  static void same_sets(const B& both, const From& from, const To& to, const Verb& verb, const char* what) {
    for (const auto x : from.all)
      expect(sorted(raw_numbers(verb(both.native, x))) == sorted(native_numbers(to, verb(both.other, from.to(x)))), what);
  }
  /// Checks that edge k of a polygon joins its verts k and k + 1, and that the edges of a tet are 01 02 03 12 13 23.
  template<class B>
  static void check_order(const B& both) {
    using M = typename B::other_mesh;
    const auto& m = both.other;
    const auto in_order = [&](const auto& loop, const auto& edges_of_it, const auto& ends_of, const char* what) {
      std::vector<vert_t<M>> ring;
      for (const vert_t<M> v : loop) ring.push_back(v);
      std::size_t k = 0;
      for (const edge_t<M> e : edges_of_it) {
        const auto [i, j] = ends_of(k++, ring.size());
        const auto [a, b] = end_verts(m, e);
        expect((a == ring[i] && b == ring[j]) || (a == ring[j] && b == ring[i]), what);
      }
    };
    const auto around = [](std::size_t k, std::size_t n) { return std::pair(k, k + 1 == n ? 0 : k + 1); };
    if constexpr (SurfaceMesh<M>)
      for (const poly_t<M> p : polys(m)) in_order(adj_p2v(m, p), adj_p2e(m, p), around, "adj_p2e follows adj_p2v");
    if constexpr (VolumeMesh<M>)
      for (const face_t<M> f : faces(m)) in_order(adj_f2v(m, f), adj_f2e(m, f), around, "adj_f2e follows adj_f2v");
    if constexpr (TetMesh<M>) {
      const auto of_tet = [](std::size_t k, std::size_t) { return std::pair<std::size_t, std::size_t>(k < 3 ? 0 : k < 5 ? 1 : 2, k < 3 ? k + 1 : k < 5 ? k - 1 : 3); };
      for (const poly_t<M> p : polys(m)) in_order(adj_p2v(m, p), adj_p2e(m, p), of_tet, "the edges of a tet in order");
    }
  }
  /// Compares facets; `pairs` is their pairing.
  template<class B, class P>
  static void check_facets(const B& both, const P& pairs) {
    const auto& n = both.native;
    const auto& m = both.other;
    expect(num_facets(m) == pairs.all.size() && num_elements(facets(m)) == pairs.all.size() && facet_index_bound(m) >= pairs.all.size(), "num_facets");
    same_sets(both, both.polys, pairs, adj_p2facet, "adj_p2facet");
    same_sets(both, pairs, both.polys, adj_facet2p, "adj_facet2p");
    same_sets(both, pairs, both.verts, adj_facet2v, "adj_facet2v");
    for (const auto x : pairs.all)
      for (const auto p : adj_facet2p(n, x))
        expect(sorted(raw_numbers(other_polys(n, p, x))) == sorted(native_numbers(both.polys, other_polys(m, both.polys.to(p), pairs.to(x)))), "other_polys");
    const auto same_boundary = [&](const auto& elements) {
      for (const auto x : elements.all) expect(is_boundary(n, x) == is_boundary(m, elements.to(x)), "is_boundary");
    };
    same_boundary(pairs);
    same_boundary(both.verts);
    same_boundary(both.edges);
    same_boundary(both.polys);
    for (const auto e : both.edges.all) {
      const auto [a, b] = end_verts(n, e);
      const auto [c, d] = end_verts(m, both.edges.to(e));
      const auto i = both.verts.back(c), j = both.verts.back(d);
      expect((a == i && b == j) || (a == j && b == i), "end_verts");
    }
  }
  template<class Map, class P>
  static void check_map(Map&& map, const P& pairs) {
    for (const auto x : pairs.all) map[pairs.to(x)] = x.raw() + 1;
    for (const auto x : pairs.all) expect(map[pairs.to(x)] == x.raw() + 1, "a map keeps a value per element");
  }
};

}  // namespace concino::agreement
