// Values of properties of another library's mesh in edits: elements keep them with their descriptors, and new ones have default values.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::testing {

/// For meshes of which no values are looked at.
struct no_values {
  template<class M> struct list {};

  template<class M> list<M> of(const M&) const { return {}; }
  template<class M> void append(M&, std::vector<double>&) const {}
  template<class M> void check_kept(M&, const list<M>&) const {}
  template<class M, class Map> void check_moved(M&, const list<M>&, const Map&) const {}
};

/// maps_of(m): a tuple of maps of a property of verts, of edges and of polys, all numbers, whose default is 0.
template<class Maps>
struct kept_values {
  Maps maps_of;

  /// The elements of a mesh with their values, and the ends of edges.
  template<class M>
  struct list {
    std::vector<std::pair<vert_t<M>, int>> verts;
    std::vector<std::pair<poly_t<M>, int>> polys;
    std::vector<std::pair<edge_t<M>, int>> edges;
    std::vector<std::array<std::size_t, 2>> ends;
  };

  /// Gives each element another value than 0.
  template<class M>
  void write(M& m) const {
    auto [of_verts, of_edges, of_polys] = maps_of(m);
    for (const auto v : verts(m)) of_verts[v] = 1 + static_cast<int>(index_of(m, v));
    for (const auto e : edges(m)) of_edges[e] = 1 + static_cast<int>(index_of(m, e));
    for (const auto p : polys(m)) of_polys[p] = 1 + static_cast<int>(index_of(m, p));
  }
  template<class M>
  list<M> of(M& m) const {
    const auto [of_verts, of_edges, of_polys] = maps_of(m);
    list<M> all;
    for (const auto v : verts(m)) all.verts.emplace_back(v, of_verts[v]);
    for (const auto p : polys(m)) all.polys.emplace_back(p, of_polys[p]);
    for (const auto e : edges(m)) all.edges.emplace_back(e, of_edges[e]), all.ends.push_back(ends_of(m, e));
    return all;
  }
  template<class M>
  void append(M& m, std::vector<double>& numbers) const {
    const list<M> all = of(m);
    for (const auto& [v, x] : all.verts) numbers.push_back(x);
    for (const auto& [p, x] : all.polys) numbers.push_back(x);
    for (const auto& [e, x] : all.edges) numbers.push_back(x);
  }
  /// After an edit. A new edge may have the descriptor of a removed one, with its value.
  template<class M>
  void check_kept(M& m, const list<M>& before) const {
    const auto [of_verts, of_edges, of_polys] = maps_of(m);
    check_all(m, verts(m), before.verts, of_verts);
    check_all(m, polys(m), before.polys, of_polys);
    bool all_kept = true;
    for (std::size_t i = 0; i < before.edges.size(); ++i)
      if (const auto e = before.edges[i].first; contains(m, e) && ends_of(m, e) == before.ends[i]) all_kept &= of_edges[e] == before.edges[i].second;
    CHECK(all_kept);
  }
  /// After a renumbering.
  template<class M, class Map>
  void check_moved(M& m, const list<M>& before, const Map& map) const {
    const auto [of_verts, of_edges, of_polys] = maps_of(m);
    bool all_kept = before.verts.size() == num_verts(m) && before.edges.size() == num_edges(m) && before.polys.size() == num_polys(m);
    for (const auto& [v, x] : before.verts) all_kept = all_kept && map[v] && of_verts[*map[v]] == x;
    for (const auto& [e, x] : before.edges) all_kept = all_kept && map[e] && of_edges[*map[e]] == x;
    for (const auto& [p, x] : before.polys) all_kept = all_kept && map[p] && of_polys[*map[p]] == x;
    CHECK(all_kept);
  }

 private:
  template<class M>
  static std::array<std::size_t, 2> ends_of(const M& m, const edge_t<M>& e) {
    std::array<std::size_t, 2> ends{};
    std::size_t i = 0;
    for (const auto v : adj_e2v(m, e)) ends[i++] = index_of(m, v);
    std::sort(ends.begin(), ends.end());
    return ends;
  }
  template<class M, class Range, class List, class Values>
  static void check_all(const M& m, const Range& elements, const List& before, const Values& values) {
    std::vector<int> expected;  // by index; of new ones 0
    for (const auto& [x, value] : before) {
      if (index_of(m, x) >= expected.size()) expected.resize(index_of(m, x) + 1);
      expected[index_of(m, x)] = value;
    }
    bool all_kept = true;
    for (const auto x : elements) all_kept &= values[x] == (index_of(m, x) < expected.size() ? expected[index_of(m, x)] : 0);
    CHECK(all_kept);
  }
};

}  // namespace concino::testing
