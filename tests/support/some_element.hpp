// Random elements of meshes of every kind and library.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstddef>
#include <random>
#include <vector>

namespace concino::testing {

/// The type of the numbers from which descriptors are made: int in OpenMesh, unsigned in CGAL and in native meshes.
template<class X>
struct descriptor_number { using type = int; };
template<class X>
  requires requires { typename X::size_type; }
struct descriptor_number<X> { using type = typename X::size_type; };
template<class X>
  requires requires(const X& x) { x.raw(); }
struct descriptor_number<X> { using type = unsigned; };

/// A random element of a range that is not empty. `bound`: of the indices of its elements. Most elements are found without listing them all.
template<class M, class R>
auto some_element_of(const M& m, const R& range, std::size_t bound, std::mt19937& random) {
  using element = std::remove_cvref_t<decltype(*range.begin())>;
  for (unsigned i = 0; i < 64; ++i)
    if (const element x(static_cast<typename descriptor_number<element>::type>(random() % bound)); contains(m, x)) return x;
  std::vector<element> all;
  for (const auto x : range) all.push_back(x);
  return all[random() % all.size()];
}
template<class M>
vert_t<M> some_vert(const M& m, std::mt19937& random) { return some_element_of(m, verts(m), vert_index_bound(m), random); }
template<class M>
edge_t<M> some_edge(const M& m, std::mt19937& random) { return some_element_of(m, edges(m), edge_index_bound(m), random); }
template<class M>
poly_t<M> some_poly(const M& m, std::mt19937& random) { return some_element_of(m, polys(m), poly_index_bound(m), random); }

}  // namespace concino::testing
