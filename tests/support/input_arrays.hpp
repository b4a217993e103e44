// Converts the arrays of a native mesh to the forms that users have, and compares views of such arrays with the native mesh.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <ranges>
#include <vector>

namespace concino::testing {

/// The raw numbers of ids.
template<class I, class Ids>
std::vector<I> raws(const Ids& ids) {
  std::vector<I> r;
  for (const auto x : ids) r.push_back(static_cast<I>(x.raw()));
  return r;
}
template<class I>
std::vector<I> numbers(const std::vector<std::uint32_t>& given) { return {given.begin(), given.end()}; }
template<class T>
std::vector<T> coordinates(const std::vector<vec3>& points) {
  std::vector<T> r;
  for (const vec3& p : points) r.insert(r.end(), {static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)});
  return r;
}

template<class A, class B>
bool same_range(const A& a, const B& b) {
  static_assert(std::ranges::forward_range<A>);
  auto j = b.begin();
  for (const auto x : a) {
    if (!(j != b.end()) || x != *j) return false;
    ++j;
  }
  return !(j != b.end());
}

/// Checks that two meshes with the library's ids give the same results for all verbs, points up to rounding to floats, and that all laws hold.
template<class A, class B>
void check_same_mesh(const A& a, const B& b) {
  static_assert(dimension_v<A> == dimension_v<B> && arity_v<A> == arity_v<B>);
  CHECK(check_laws(a).empty());
  REQUIRE(num_verts(a) == num_verts(b));
  REQUIRE(num_edges(a) == num_edges(b));
  REQUIRE(num_polys(a) == num_polys(b));
  REQUIRE(same_range(verts(a), verts(b)));
  for (const vert_id v : verts(a)) {
    CHECK(norm(to_vec3(point(a, v)) - point(b, v)) <= 1e-7 * norm(point(b, v)));
    CHECK(same_range(adj_v2v(a, v), adj_v2v(b, v)));
    CHECK(same_range(adj_v2e(a, v), adj_v2e(b, v)));
    CHECK(same_range(adj_v2p(a, v), adj_v2p(b, v)));
  }
  for (const edge_id e : edges(a)) {
    CHECK(same_range(adj_e2v(a, e), adj_e2v(b, e)));
    CHECK(same_range(adj_e2p(a, e), adj_e2p(b, e)));
  }
  for (const poly_id p : polys(a)) {
    CHECK(same_range(adj_p2v(a, p), adj_p2v(b, p)));
    CHECK(same_range(adj_p2e(a, p), adj_p2e(b, p)));
    CHECK(same_range(adj_p2p(a, p), adj_p2p(b, p)));
  }
  if constexpr (dimension_v<A> == 3) {
    REQUIRE(num_faces(a) == num_faces(b));
    for (const face_id f : faces(a)) {
      CHECK(same_range(adj_f2v(a, f), adj_f2v(b, f)));
      CHECK(same_range(adj_f2e(a, f), adj_f2e(b, f)));
      CHECK(same_range(adj_f2p(a, f), adj_f2p(b, f)));
    }
    for (const vert_id v : verts(a)) CHECK(same_range(adj_v2f(a, v), adj_v2f(b, v)));
    for (const edge_id e : edges(a)) CHECK(same_range(adj_e2f(a, e), adj_e2f(b, e)));
    for (const poly_id p : polys(a)) {
      CHECK(same_range(adj_p2f(a, p), adj_p2f(b, p)));
      for (const face_id f : adj_p2f(a, p)) CHECK(face_is_outward(a, p, f) == face_is_outward(b, p, f));
    }
  }
}

}  // namespace concino::testing
