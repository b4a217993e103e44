// oriented_edges lists the edges of polys and faces in the order of their verts, on users' meshes and archetypes.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {

template<class M, class X> concept is_walked = requires(const M& m, X x) { cn::oriented_edges(m, x); };
static_assert(is_walked<user_mesh::surface, user_mesh::cell> && !is_walked<user_mesh::surface, user_mesh::facet> && !is_walked<int, int>);
static_assert(is_walked<user_mesh::volume, user_mesh::facet> && !is_walked<user_mesh::volume, user_mesh::cell>);
static_assert(cn::ElementRange<decltype(cn::oriented_edges(std::declval<const user_mesh::surface&>(), user_mesh::cell())), cn::oriented_edge<user_mesh::surface>>);

template<class M, class Loop, class Walk>
void follows(const M& m, const Loop& loop, const Walk& walk) {
  for (int again = 0; again < 2; ++again) {
    std::vector<cn::vert_t<M>> ring;
    for (const cn::vert_t<M> v : loop) ring.push_back(v);
    std::size_t k = 0;
    for (const auto& [e, from, to] : walk) {
      CHECK(from == ring[k]);
      CHECK(to == ring[(k + 1) % ring.size()]);
      const auto ends = cn::end_verts(m, e);
      CHECK(((ends.first == from && ends.second == to) || (ends.first == to && ends.second == from)));
      ++k;
    }
    CHECK(k == ring.size());
  }
}

template<class M>
void all_polys(const M& m) {
  for (const cn::poly_t<M> p : cn::polys(m)) follows(m, cn::adj_p2v(m, p), cn::oriented_edges(m, p));
}
template<class M>
void all_faces(const M& m) {
  for (const cn::face_t<M> f : cn::faces(m)) follows(m, cn::adj_f2v(m, f), cn::oriented_edges(m, f));
}

}  // namespace

TEST_CASE("oriented_edges: are right for polys of a surface and faces of a volume") {
  const auto s = user_mesh::surface_example();
  const auto w = user_mesh::volume_example();
  all_polys(s);
  all_polys(cn::only_mesh(s));
  all_faces(w);
  all_faces(cn::only_mesh(w));
}

TEST_CASE("oriented_edges: never exceed the number of edges, even if a law is broken") {
  user_mesh::surface s = user_mesh::surface_example();
  s.polygons.push_back({});
  for (const auto& [e, from, to] : cn::oriented_edges(s, user_mesh::cell{4})) CHECK(e == user_mesh::segment{});
}
