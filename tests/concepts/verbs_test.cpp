// Verbs forward to the traits, and cannot be called if the traits lack the member.
#include <concino/concepts/verbs.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {

template<class M> concept walks = requires(const M& m) { cn::verts(m); };
template<class M> concept has_points = requires(const M& m) { cn::point(m, cn::vert_t<M>()); };
template<class M> concept has_faces = requires(const M& m) { cn::faces(m); };
static_assert(walks<user_mesh::surface> && has_points<user_mesh::surface> && !has_faces<user_mesh::surface> && has_faces<user_mesh::volume>);
static_assert(!walks<int> && !has_points<int>);

// A function of the same name in the namespace of the mesh is never called.
struct greedy : user_mesh::surface {};
[[maybe_unused]] int verts(const greedy&) { return -1; }
[[maybe_unused]] int num_verts(const greedy&) { return -1; }

}  // namespace
template<>
struct concino::mesh_traits<greedy> : mesh_traits<user_mesh::surface> {};

TEST_CASE("counts and indices are std::size_t, whatever type the traits return") {
  const auto s = user_mesh::surface_example();
  static_assert(std::same_as<decltype(cn::num_verts(s)), std::size_t> &&
                std::same_as<decltype(cn::index_of(s, user_mesh::vertex{2})), std::size_t>);
  CHECK(cn::num_verts(s) == 8);
  CHECK(cn::num_edges(s) == 10);
  CHECK(cn::num_polys(s) == 4);
  CHECK(cn::index_of(s, user_mesh::vertex{2}) == 2);
}

TEST_CASE("a function of another namespace is never called instead of a verb") {
  using namespace concino;
  greedy g;
  static_cast<user_mesh::surface&>(g) = user_mesh::surface_example();
  CHECK(cn::num_verts(g) == 8);
}
