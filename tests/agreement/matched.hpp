// The correspondence between the elements of two models of the same mesh, to compare results. Verts and polys are paired in the order of their
// ranges, edges by their ends, faces by their verts and polys. algorithms/walk.hpp checks whether that is right.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace concino::agreement {

inline void expect(bool ok, const char* what) { REQUIRE_MESSAGE(ok, std::string(what)); }

/// Whether two numbers are equal up to 1e-12 of the largest magnitude of the whole result. Infinities and NaN equal only themselves.
inline bool close(double a, double b, double largest) {
  if (!std::isfinite(a) || !std::isfinite(b)) return a == b || (std::isnan(a) && std::isnan(b));
  return std::abs(a - b) <= 1e-12 * largest;
}
inline void expect_close(double a, double b, double largest, const char* what) {
  INFO(a << " and " << b << ", apart by " << std::abs(a - b) << ", the largest " << largest);
  REQUIRE_MESSAGE(close(a, b, largest), std::string(what));
}
/// The largest finite magnitude of value(x) over some elements.
template<class R, class F>
double largest_of(const R& elements, const F& value) {
  double largest = 0;
  for (const auto& x : elements)
    if (const double size = std::abs(value(x)); size <= std::numeric_limits<double>::max()) largest = std::max(largest, size);
  return largest;
}

using numbers = std::vector<unsigned>;

/// The cyclic list rotated so that it begins with its smallest number.
inline numbers rotated(numbers a) {
  std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
  return a;
}
inline numbers reversed(numbers a) {
  std::reverse(a.begin(), a.end());
  return a;
}
inline numbers sorted(numbers a) {
  std::sort(a.begin(), a.end());
  return a;
}

/// The pairs of elements of one kind: of a mesh with descriptors Id, which are numbers, and of another mesh M with descriptors X.
template<class Id, class M, class X>
class pairing {
  const M* m_ = nullptr;
  std::vector<X> to_;           // by number of the first
  std::vector<Id> back_;        // by index_of of the second

 public:
  using id = Id;
  using descriptor = X;
  std::vector<Id> all;          // of the first mesh, in the order of its range

  void reserve(const M& m, std::size_t first_bound, std::size_t second_bound) {
    m_ = &m;
    to_.resize(first_bound);
    back_.resize(second_bound);
  }
  void add(const Id& a, const X& b) {
    const std::size_t i = index_of(*m_, b);
    expect(i < back_.size() && back_[i].is_none(), "indices are below the bound and differ");
    to_[a.raw()] = b;
    back_[i] = a;
    all.push_back(a);
  }
  const X& to(Id a) const { return to_[a.raw()]; }
  Id back(const X& b) const { return back_[index_of(*m_, b)]; }
  Id first() const { return all.front(); }
  Id last() const { return all.back(); }
  bool empty() const { return all.empty(); }
};

template<class A, class B, class P>
void pair_in_order(const A& first, const B& second, P& pairs) {
  auto it = second.begin();
  for (const auto a : first) {
    expect(it != second.end(), "there are as many elements");
    pairs.add(a, *it);
    ++it;
  }
  expect(!(it != second.end()), "there are as many elements");
}

template<class P, class R>
numbers native_numbers(const P& pairs, const R& elements) {
  numbers r;
  for (const auto& x : elements) r.push_back(pairs.back(x).raw());
  return r;
}
template<class R>
numbers raw_numbers(const R& elements) {
  numbers r;
  for (const auto x : elements) r.push_back(x.raw());
  return r;
}

template<class N, class M, bool> struct matched_verts {};
template<class N, class M> struct matched_verts<N, M, true> { pairing<vert_t<N>, M, vert_t<M>> verts; };
template<class N, class M, bool> struct matched_polys {};
template<class N, class M> struct matched_polys<N, M, true> { pairing<poly_t<N>, M, poly_t<M>> polys; };
template<class N, class M, bool> struct matched_edges {};
template<class N, class M> struct matched_edges<N, M, true> { pairing<edge_t<N>, M, edge_t<M>> edges; };
template<class N, class M, bool> struct matched_faces {};
template<class N, class M> struct matched_faces<N, M, true> { pairing<face_t<N>, M, face_t<M>> faces; };

/// A native mesh, or a view of one, paired with another model M of the same mesh.
template<class N, class M>
struct matched : matched_verts<N, M, PrimalGraph<M>>,
                 matched_polys<N, M, DualGraph<M>>,
                 matched_edges<N, M, AnyMesh<M>>,
                 matched_faces<N, M, VolumeMesh<M>> {
  using native_mesh = N;
  using other_mesh = M;
  const N& native;
  const M& other;

  matched(const N& n, const M& m) : native(n), other(m) {
    if constexpr (PrimalGraph<M>) {
      this->verts.reserve(m, vert_index_bound(n), vert_index_bound(m));
      pair_in_order(concino::verts(n), concino::verts(m), this->verts);
    }
    if constexpr (DualGraph<M>) {
      this->polys.reserve(m, poly_index_bound(n), poly_index_bound(m));
      pair_in_order(concino::polys(n), concino::polys(m), this->polys);
    }
    if constexpr (AnyMesh<M>) {
      this->edges.reserve(m, edge_index_bound(n), edge_index_bound(m));
      pair_by_key(concino::edges(n), concino::edges(m), this->edges, [&](const auto& e) { return sorted(raw_numbers(adj_e2v(n, e))); },
                  [&](const auto& e) { return sorted(native_numbers(this->verts, adj_e2v(m, e))); });
    }
    if constexpr (VolumeMesh<M>) {
      this->faces.reserve(m, face_index_bound(n), face_index_bound(m));
      const auto key = [](numbers ring, const numbers& sides) {
        ring = std::min(rotated(ring), rotated(reversed(ring)));
        for (const unsigned p : sorted(sides)) ring.push_back(p);
        return ring;
      };
      pair_by_key(concino::faces(n), concino::faces(m), this->faces,
                  [&](const auto& f) { return key(raw_numbers(adj_f2v(n, f)), raw_numbers(adj_f2p(n, f))); },
                  [&](const auto& f) { return key(native_numbers(this->verts, adj_f2v(m, f)), native_numbers(this->polys, adj_f2p(m, f))); });
    }
  }
  matched(const matched&) = delete;

 private:
  template<class A, class B, class P, class KeyA, class KeyB>
  static void pair_by_key(const A& first, const B& second, P& pairs, const KeyA& key_a, const KeyB& key_b) {
    std::map<numbers, typename P::id> known;
    std::size_t n = 0;
    for (const auto a : first) known[key_a(a)] = a, ++n;
    expect(known.size() == n, "no two edges or faces of the input are alike");
    for (const auto& b : second) {
      const auto it = known.find(key_b(b));
      expect(it != known.end(), "edges and faces have the same verts and polys");
      pairs.add(it->second, b);
      --n;
    }
    expect(n == 0, "there are as many edges and faces");
    std::sort(pairs.all.begin(), pairs.all.end());
  }
};

/// Calls f with the pairs of verts, and with those of polys, if M has them: for checks that are the same for both graphs.
template<class B, class F>
void each_graph(const B& both, F&& f) {
  if constexpr (requires { both.verts; }) f(both.verts);
  if constexpr (requires { both.polys; }) f(both.polys);
}

/// A length in [1, 2) that is different for every pair of elements and symmetric, so that no two distances are equal.
inline double scrambled(unsigned a, unsigned b) {
  std::uint64_t x = (std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)) + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return 1 + static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}
inline constexpr auto scrambled_length = [](auto a, auto b) { return scrambled(a.raw(), b.raw()); };
/// The same length for elements of the other mesh.
template<class P>
auto scrambled_in(const P& pairs) {
  return [&pairs](const auto& a, const auto& b) { return scrambled(pairs.back(a).raw(), pairs.back(b).raw()); };
}

/// What make() returns; nothing if it throws an E, because it refuses the mesh or the element.
template<class E = unsupported, class F>
auto unless_refused(const F& make) -> std::optional<decltype(make())> {
  try {
    return make();
  } catch (const E&) {
    return std::nullopt;
  }
}

}  // namespace concino::agreement
