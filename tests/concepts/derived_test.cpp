// adj_e2e and adj_f2f agree with a brute-force search, on users' meshes, on archetypes and where faces share several edges.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/derived.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cn = concino;

namespace {

template<class X, class R>
std::vector<int> numbers(const R& ring, const X& number) {
  std::vector<int> r;
  for (auto x : ring) r.push_back(number(x));
  std::sort(r.begin(), r.end());
  return r;
}

/// The elements x != a of `all` for which ring(x) and ring(a) have a common element.
template<class A, class All, class Ring>
std::vector<int> sharing(A a, const All& all, const Ring& ring) {
  std::vector<int> r;
  const auto& mine = ring(a);
  for (A x : all) {
    bool shares = false;
    for (auto y : ring(x))
      for (auto z : mine) shares = shares || y == z;
    if (shares && !(x == a)) r.push_back(x.i);
  }
  return r;
}

template<class M>
void check_edges(const M& m) {
  const auto plain = [](auto x) { return x.i; };
  const auto a = cn::only_mesh(m);
  const auto base = [&](auto x) { return a.base(x).i; };
  static_assert(cn::ElementRange<decltype(cn::adj_e2e(m, user_mesh::segment())), user_mesh::segment>);
  for (auto e : cn::edges(m)) {
    const auto expected = sharing(e, cn::edges(m), [&](auto x) { return cn::adj_e2v(m, x); });
    CHECK(numbers(cn::adj_e2e(m, e), plain) == expected);
    CHECK(numbers(cn::adj_e2e(a, a.edge(e)), base) == expected);
  }
}

void check_faces(const user_mesh::volume& m) {
  const auto plain = [](auto x) { return x.i; };
  const auto a = cn::only_mesh(m);
  const auto base = [&](auto x) { return a.base(x).i; };
  static_assert(cn::ElementRange<decltype(cn::adj_f2f(m, user_mesh::facet())), user_mesh::facet>);
  for (auto f : cn::faces(m)) {
    const auto expected = sharing(f, cn::faces(m), [&](auto x) { return cn::adj_f2e(m, x); });
    CHECK(numbers(cn::adj_f2f(m, f), plain) == expected);
    CHECK(numbers(cn::adj_f2f(a, a.face(f)), base) == expected);
  }
}

// A function of the traits with the name of a derived verb is not asked: it may be inherited, and not know which verbs were replaced.
struct knows_better : user_mesh::surface {};

template<class M> concept has_f2f = requires(const M& m) { cn::adj_f2f(m, cn::face_t<M>()); };
static_assert(has_f2f<user_mesh::volume> && !has_f2f<user_mesh::surface>);
template<class M> concept has_e2e = requires(const M& m) { cn::adj_e2e(m, cn::edge_t<M>()); };
static_assert(has_e2e<user_mesh::surface> && !has_e2e<int>);

}  // namespace
template<>
struct concino::mesh_traits<knows_better> : mesh_traits<user_mesh::surface> {
  static std::vector<edge> adj_e2e(const knows_better&, edge e) { return {e, e, e}; }
};

TEST_CASE("adj_e2e: neighbours are the edges that share a vert") {
  check_edges(user_mesh::surface_example());
  check_edges(user_mesh::volume_example());
  // Two edges have the same ends.
  user_mesh::surface twice({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  twice.es.push_back(twice.es[0]);
  check_edges(twice);
}

TEST_CASE("adj_f2f: neighbours are the faces that share one or more edges") {
  check_faces(user_mesh::volume_example());
  // Two faces with the same verts share three edges.
  check_faces(user_mesh::volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}}, {{{0, true}, {1, true}}}));
}

TEST_CASE("adj_e2e, adj_f2f: are right on random faces over few verts") {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<user_mesh::polygon> facets;
    std::vector<int> verts{0, 1, 2, 3, 4, 5};
    for (int f = 0; f < 6; ++f) {
      std::shuffle(verts.begin(), verts.end(), random);
      facets.emplace_back(verts.begin(), verts.begin() + 3 + f % 3);
    }
    const user_mesh::volume m(std::vector<std::array<double, 3>>(6), facets, {});
    check_edges(m);
    check_faces(m);
  }
}

TEST_CASE("adj_e2e, adj_f2f: functions of the traits do not answer for the verbs") {
  check_edges(knows_better{user_mesh::surface_example()});
}
