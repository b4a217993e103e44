// Values of edges and faces in edits: those whose verts survive keep their values and descriptors.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/mesh/property.hpp>

#include <support/some_element.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace concino::testing {

/// Gives each edge and each face a value of its own, more than 0, and remembers them.
template<class M>
class surviving_values {
  using verts_of = std::vector<std::size_t>;  // sorted indices

  std::map<std::size_t, vec3> points_;
  std::map<verts_of, std::size_t> edges_, faces_;  // their indices

  template<class R>
  static verts_of sorted(const M& m, const R& range) {
    verts_of all;
    for (const auto v : range) all.push_back(index_of(m, v));
    std::sort(all.begin(), all.end());
    return all;
  }
  /// Whether a vert was there before. A new one may have the descriptor of a removed one.
  bool is_old(const M& m, const vert_t<M>& v) const {
    const auto at = points_.find(index_of(m, v));
    return at != points_.end() && at->second == to_vec3(point(m, v));
  }
  template<class X, class R, class Map>
  std::size_t check(const M& m, const X& x, const R& its_verts, const std::map<verts_of, std::size_t>& before, const Map& value) const {
    for (const auto v : its_verts)
      if (!is_old(m, v)) return 0;
    const auto at = before.find(sorted(m, its_verts));
    if (at == before.end()) return 0;
    CHECK(index_of(m, x) == at->second);
    CHECK(value[x] == 1 + static_cast<int>(at->second));
    return 1;
  }

 public:
  explicit surviving_values(M& m) {
    for (const auto v : verts(m)) points_[index_of(m, v)] = to_vec3(point(m, v));
    const auto of_edges = edge_property<int>(m, "edge value");
    for (const auto e : edges(m)) edges_[sorted(m, adj_e2v(m, e))] = index_of(m, e), of_edges[e] = 1 + static_cast<int>(index_of(m, e));
    if constexpr (VolumeMesh<M>) {
      const auto of_faces = face_property<int>(m, "face value");
      for (const auto f : faces(m)) faces_[sorted(m, adj_f2v(m, f))] = index_of(m, f), of_faces[f] = 1 + static_cast<int>(index_of(m, f));
    }
  }
  /// After edits. Returns how many edges and faces survived.
  std::size_t check(const M& m) const {
    std::size_t count = 0;
    const auto of_edges = find_edge_property<int>(m, "edge value");
    for (const auto e : edges(m)) count += check(m, e, adj_e2v(m, e), edges_, of_edges);
    if constexpr (VolumeMesh<M>) {
      const auto of_faces = find_face_property<int>(m, "face value");
      for (const auto f : faces(m)) count += check(m, f, adj_f2v(m, f), faces_, of_faces);
    }
    return count;
  }
};

}  // namespace concino::testing
