// The verts of a subdivided mesh: one for each vert of the mesh before, and one for each of its edges, faces or polys,
// as the subdivision needs. Their points are weighted means of verts of the mesh before.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/element_origins.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// The kinds of elements for which, besides verts, a subdivided mesh has new verts.
struct refined_kinds {
  bool edges = false, faces = false, polys = false;
};

/// Numbers the new verts: those of verts first, then those of edges, of faces and of polys, each in the order of the
/// mesh.
template<AnyMesh M, refined_kinds kinds>
class refined_verts {
  const M* m_;
  core::flat_array<std::uint32_t> verts_, edges_, faces_, polys_;  // by index
  std::uint32_t count_ = 0, first_edge_ = 0, end_of_edges_ = 0;

  template<class R>
  core::flat_array<std::uint32_t> numbered(const R& elements, std::size_t bound) {
    core::flat_array<std::uint32_t> number(bound);
    for (const auto x : elements) number[index_of(*m_, x)] = count_++;
    return number;
  }

 public:
  explicit refined_verts(const M& m) : m_(&m) {
    verts_ = numbered(verts(m), vert_index_bound(m));
    first_edge_ = count_;
    if constexpr (kinds.edges) edges_ = numbered(edges(m), edge_index_bound(m));
    end_of_edges_ = count_;
    if constexpr (kinds.faces) faces_ = numbered(faces(m), face_index_bound(m));
    if constexpr (kinds.polys) polys_ = numbered(polys(m), poly_index_bound(m));
  }

  /// The number of new verts, as a double: it may be more than 32 bits hold.
  static double expected_size(const M& m) {
    double n = static_cast<double>(num_verts(m));
    if constexpr (kinds.edges) n += static_cast<double>(num_edges(m));
    if constexpr (kinds.faces) n += static_cast<double>(num_faces(m));
    if constexpr (kinds.polys) n += static_cast<double>(num_polys(m));
    return n;
  }

  const M& mesh() const { return *m_; }
  std::size_t size() const { return count_; }

  /// The new vert of an element.
  template<class X>
  vert_id operator[](const X& x) const {
    const std::size_t i = index_of(*m_, x);
    if constexpr (std::is_same_v<X, vert_t<M>>) return vert_id{verts_[i]};
    else if constexpr (std::is_same_v<X, edge_t<M>>) return vert_id{edges_[i]};
    else if constexpr (std::is_same_v<X, poly_t<M>>) return vert_id{polys_[i]};
    else return vert_id{faces_[i]};
  }
  /// Whether a new vert is that of a vert or of an edge, and the position in edges(m) of that edge.
  bool is_of_vert(vert_id v) const { return v.raw() < first_edge_; }
  bool is_of_edge(vert_id v) const { return v.raw() >= first_edge_ && v.raw() < end_of_edges_; }
  std::size_t edge_position(vert_id v) const { return v.raw() - first_edge_; }

  /// Calls f(x) for each element that has a new vert, in the order of these, or in parallel.
  template<class F>
  void for_each(const F& f) const {
    for (const auto x : verts(*m_)) f(x);
    if constexpr (kinds.edges)
      for (const auto x : edges(*m_)) f(x);
    if constexpr (kinds.faces)
      for (const auto x : faces(*m_)) f(x);
    if constexpr (kinds.polys)
      for (const auto x : polys(*m_)) f(x);
  }
  template<class F>
  void for_each_in_parallel(const F& f) const {
    parallel_for_each(verts(*m_), f);
    if constexpr (kinds.edges) parallel_for_each(edges(*m_), f);
    if constexpr (kinds.faces) parallel_for_each(faces(*m_), f);
    if constexpr (kinds.polys) parallel_for_each(polys(*m_), f);
  }
};

/// The rule of linear subdivisions: the new vert of an element is at the mean of its verts.
template<EmbeddedMesh M>
struct mean_rule {
  const M& m;

  template<class Take>
  void operator()(const vert_t<M>& v, const Take& take) const {
    take(v, 1.0);
  }
  template<class X, class Take>
  void operator()(const X& x, const Take& take) const {
    if constexpr (std::is_same_v<X, edge_t<M>>) take_mean(adj_e2v(m, x), take);
    else if constexpr (std::is_same_v<X, poly_t<M>>) take_mean(adj_p2v(m, x), take);
    else take_mean(adj_f2v(m, x), take);
  }

 private:
  template<class R, class Take>
  static void take_mean(const R& all, const Take& take) {
    const double weight = 1 / static_cast<double>(num_elements(all));
    for (const vert_t<M> v : all) take(v, weight);
  }
};

/// The point of the new vert of x: rule(x, take) calls take(v, weight) for the verts v of which it is the weighted
/// mean; the sum of weights is 1.
template<class M, class Rule, class X>
vec3 refined_point(const M& m, const Rule& rule, const X& x) {
  vec3 sum;
  rule(x, [&](const vert_t<M>& v, double weight) { sum += weight * to_vec3(point(m, v)); });
  return sum;
}

/// The points of the new verts.
template<class M, refined_kinds kinds, class Rule>
std::vector<vec3> refined_points(const refined_verts<M, kinds>& refined, const Rule& rule) {
  std::vector<vec3> points(refined.size());
  refined.for_each_in_parallel(
      [&](const auto& x) { points[refined[x].raw()] = refined_point(refined.mesh(), rule, x); });
  return points;
}

/// The verts of which the new verts are weighted means.
template<class M, refined_kinds kinds, class Rule>
element_origins refined_origins(const refined_verts<M, kinds>& refined, const Rule& rule) {
  element_origins origins;
  std::vector<origin> list;
  refined.for_each([&](const auto& x) {
    list.clear();
    core::local_numbers visited;
    rule(x, [&](const vert_t<M>& v, double weight) {
      const auto index = static_cast<std::uint32_t>(index_of(refined.mesh(), v));
      const unsigned k = visited.add(index);
      if (k == list.size()) list.push_back({index, weight});
      else list[k].weight += weight;
    });
    if (list.size() == 1) origins.add(list[0].index);
    else origins.add(list);
  });
  return origins;
}

}  // namespace concino::detail
