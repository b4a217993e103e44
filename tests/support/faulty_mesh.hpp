// A mesh that forwards to another one, except where a test replaces a result by a wrong one.
#pragma once

#include "user_mesh.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace user_mesh {

template<class B>
struct faulty_mesh : B {
  explicit faulty_mesh(const B& b) : B(b) {}
  /// May change the result of verb(a). For the ranges of all elements, `verts` and so on, a = -1.
  std::function<void(std::string_view verb, int a, std::vector<int>& ring)> ring = [](auto, auto, auto&) {};
  /// May change a number: "num_verts", "vert_index_bound", "index_of v" (a = the element), "face_is_outward" (a = poly, b = face).
  std::function<std::size_t(std::string_view verb, int a, int b, std::size_t n)> number = [](auto, auto, auto, std::size_t n) { return n; };

  template<class R>
  auto falsify(std::string_view verb, int a, const R& honest) const {
    using H = std::remove_cvref_t<decltype(*honest.begin())>;
    std::vector<int> xs;
    for (H x : honest) xs.push_back(x.i);
    ring(verb, a, xs);
    std::vector<H> out;
    for (int x : xs) out.push_back(H{x});
    return out;
  }
};

}  // namespace user_mesh

namespace concino {

template<class B>
struct mesh_traits<user_mesh::faulty_mesh<B>> {
  using L = user_mesh::faulty_mesh<B>;
  using T = mesh_traits<B>;
  using vert = user_mesh::vertex;
  using edge = user_mesh::segment;
  using face = user_mesh::facet;
  using poly = user_mesh::cell;
  static constexpr int dimension = T::dimension;
  static constexpr bool edges_in_order = T::edges_in_order;

#define TINY_ALL(kind)                                                                   \
  static auto kind##s(const L& m) requires requires { T::kind##s(m); }                   \
  { return m.falsify(#kind "s", -1, T::kind##s(m)); }                                       \
  static std::size_t num_##kind##s(const L& m) requires requires { T::kind##s(m); }      \
  { return m.number("num_" #kind "s", -1, -1, T::num_##kind##s(m)); }                    \
  static std::size_t kind##_index_bound(const L& m) requires requires { T::kind##s(m); } \
  { return m.number(#kind "_index_bound", -1, -1, T::kind##_index_bound(m)); }
  TINY_ALL(vert)
  TINY_ALL(edge) TINY_ALL(face) TINY_ALL(poly)
#undef TINY_ALL
#define TINY_RING(verb, kind) \
  static auto verb(const L& m, kind x) requires requires { T::verb(m, x); } { return m.falsify(#verb, x.i, T::verb(m, x)); }
      TINY_RING(adj_v2v, vert) TINY_RING(adj_v2e, vert) TINY_RING(adj_v2f, vert) TINY_RING(adj_v2p, vert) TINY_RING(adj_e2v, edge)
          TINY_RING(adj_e2f, edge) TINY_RING(adj_e2p, edge) TINY_RING(adj_f2v, face) TINY_RING(adj_f2e, face) TINY_RING(adj_f2p, face)
              TINY_RING(adj_p2v, poly) TINY_RING(adj_p2e, poly) TINY_RING(adj_p2f, poly) TINY_RING(adj_p2p, poly)
#undef TINY_RING
                  template<char C>
                  static std::size_t index_of(const L& m, user_mesh::handle<C> x) {
    return m.number(std::string("index_of ") + C, x.i, -1, T::index_of(m, x));
  }
  static bool face_is_outward(const L& m, poly p, face f) requires(dimension == 3) {
    return m.number("face_is_outward", p.i, f.i, T::face_is_outward(m, p, f)) != 0;
  }
  static auto point(const L& m, vert v) { return T::point(m, v); }
};

}  // namespace concino
