// What all subdivisions share: repeated steps, the origins of the elements of the result, and checks.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/message.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/common/num_poly_corners.hpp>
#include <concino/generate/detail/subdivide/composed_origins.hpp>
#include <concino/generate/detail/subdivide/refined_verts.hpp>
#include <concino/generate/subdivide_options.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/property.hpp>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// A mesh subdivided once, the origins of its elements if they are wanted, and whether it has a crease at an edge, by
/// the number of the edge.
template<class To>
struct subdivided {
  To mesh;
  correspondence from = {};
  std::vector<unsigned char> has_crease = {};
};

/// The creases of a mesh that has none, and those of a subdivided mesh.
struct no_creases {
  template<class E> constexpr bool operator[](const E&) const { return false; }
};
struct inherited_creases {
  const std::vector<unsigned char>& flags;
  bool operator[](edge_id e) const { return flags[e.raw()] != 0; }
};

/// Whether the origins of the elements of a subdivided mesh are needed.
template<class M>
bool wants_origins(const M& m, const subdivide_options& o) {
  if (o.correspondence) return true;
  if constexpr (ShowsProperties<M>) return o.properties && traits<M>::properties(m).size() > 0;
  else return false;
}

/// Sets the origins of the elements of a subdivided mesh, given those of its polys, and transfers the properties of m.
/// `linear` are the origins of verts without smoothing, which edges, faces and corners have too; `smooth` are those
/// with the weights of their points, empty if they are the same. Without a caller who wants them, those of edges, faces
/// and corners are found only if there are properties of such.
template<class M, class To>
void set_origins(const M& m, element_origins linear, element_origins smooth, const subdivide_options& o,
                 subdivided<To>& result) {
  correspondence& c = result.from;
  c.verts = std::move(linear);
  if (o.correspondence || smooth.size() > 0) {
    match_edges_and_faces(m, result.mesh, c);
    if constexpr (NumbersCorners<M>) c.corners = match_corners(m, result.mesh, c.verts, c.polys);
  }
  if (smooth.size() > 0) c.verts = std::move(smooth);
  if constexpr (ShowsProperties<M>)
    if (o.properties && traits<M>::properties(m).size() > 0) transfer_properties(m, result.mesh, c);
}

/// A mesh whose verts are `refined`, at points that follow by the rule, with the origins of its elements if they are
/// wanted. poly_origins() is called then.
template<class To, class M, refined_kinds kinds, class Rule, class PolyOrigins>
subdivided<To> with_origins(To mesh, const refined_verts<M, kinds>& refined, const Rule& rule,
                            const subdivide_options& o, const PolyOrigins& poly_origins) {
  const M& m = refined.mesh();
  subdivided<To> result{std::move(mesh)};
  if (!wants_origins(m, o)) return result;
  result.from.polys = poly_origins();
  element_origins smooth;
  if constexpr (!std::is_same_v<Rule, mean_rule<M>>) smooth = refined_origins(refined, rule);
  set_origins(m, refined_origins(refined, mean_rule<M>{m}), std::move(smooth), o, result);
  return result;
}

/// The origins of polys of which each n in turn were made of one poly of m.
template<class M>
element_origins repeated_polys(const M& m, std::size_t n) {
  std::vector<std::uint32_t> index;
  index.reserve(n * num_polys(m));
  for (const poly_t<M> p : polys(m)) index.insert(index.end(), n, static_cast<std::uint32_t>(index_of(m, p)));
  return element_origins(std::move(index));
}
/// The same if a poly of n verts was split into times * n.
template<class M>
element_origins polys_of_corners(const M& m, std::size_t times) {
  std::vector<std::uint32_t> index;
  for (const poly_t<M> p : polys(m))
    index.insert(index.end(), times * num_elements(adj_p2v(m, p)), static_cast<std::uint32_t>(index_of(m, p)));
  return element_origins(std::move(index));
}

/// The origins of verts that are all copies, in the order of m.
template<class M>
element_origins copied_verts(const M& m) {
  std::vector<std::uint32_t> index;
  index.reserve(num_verts(m));
  for (const vert_t<M> v : verts(m)) index.push_back(static_cast<std::uint32_t>(index_of(m, v)));
  return element_origins(std::move(index));
}

/// Errors: invalid_argument if a To with so many verts and polys has more elements than 32-bit descriptors.
template<class To>
void check_subdivided_counts(const char* caller, double vert_count, double poly_count) {
  // check_element_counts counts cells that it splits
  constexpr double per_cell = arity_v<To> == 3 ? 2 : arity_v<To> == 4 && dimension_v<To> == 3 ? 6 : 1;
  check_element_counts<To>(caller, "times", vert_count, poly_count / per_cell);
}

/// Repeats a step: step(m, creases, round) returns a subdivided mesh. After the first one, each multiplies the number
/// of polys by `growth`.
template<class M, class Creases, class Step>
auto subdivide_repeatedly(const char* caller, unsigned growth, const M& m, const Creases& creases,
                          const subdivide_options& o, const Step& step) {
  check_at_least(caller, "times", o.times, 1);
  auto done = step(m, creases, 0u);
  const double factor = std::pow(static_cast<double>(growth), o.times - 1);
  check_subdivided_counts<decltype(done.mesh)>(caller, factor * static_cast<double>(num_verts(done.mesh)),
                                               factor * static_cast<double>(num_polys(done.mesh)));
  for (unsigned round = 1; round < o.times; ++round) {
    auto next = [&] {
      if constexpr (std::is_same_v<Creases, no_creases>) return step(done.mesh, creases, round);
      else return step(done.mesh, inherited_creases{done.has_crease}, round);
    }();
    if (o.correspondence) next.from = composed_origins(done.from, next.from);
    done = std::move(next);
  }
  if (o.correspondence) *o.correspondence = std::move(done.from);
  return std::move(done.mesh);
}

/// The edges of a subdivided mesh that are halves of creases.
template<class M, refined_kinds kinds, class Creases, class To>
std::vector<unsigned char> halved_creases(const refined_verts<M, kinds>& refined, const Creases& creases,
                                          const To& result) {
  if constexpr (std::is_same_v<Creases, no_creases>) return {};
  else {
    std::vector<unsigned char> by_position, flags(edge_index_bound(result));
    by_position.reserve(num_edges(refined.mesh()));
    for (const auto e : edges(refined.mesh())) by_position.push_back(creases[e] ? 1 : 0);
    for (const auto e : edges(result)) {
      auto [a, b] = end_verts(result, e);
      if (refined.is_of_edge(a)) std::swap(a, b);
      if (refined.is_of_vert(a) && refined.is_of_edge(b))
        flags[index_of(result, e)] = by_position[refined.edge_position(b)];
    }
    return flags;
  }
}

/// The three verts of a poly, and its edges, of which edge k joins verts k and k + 1.
template<class M>
struct triangle_elements {
  vert_t<M> verts[3];
  edge_t<M> edges[3];

  /// Errors: unsupported that names the poly if it is no triangle.
  triangle_elements(const char* caller, const M& m, const poly_t<M>& p) {
    std::size_t n = 0;
    for (const auto& [e, from, to] : oriented_edges(m, p)) {
      if (n < 3) verts[n] = from, edges[n] = e;
      ++n;
    }
    if (n != 3) throw_no_triangle(caller, index_of(m, p), n);
  }

 private:
  [[noreturn]] static void throw_no_triangle(const char* caller, std::size_t poly, std::size_t n) {
    core::throw_joined<unsupported>({caller, ": poly ", poly, " has ", n,
                                     " verts, but must have 3; to_triangles() cuts all polygons into triangles"});
  }
};

}  // namespace concino::detail
