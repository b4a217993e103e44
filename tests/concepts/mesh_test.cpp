// The concepts Embedded, AnyMesh and MutablePoints, and the verb contains.
#include <concino/concepts/mesh.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {
struct movable : user_mesh::surface {};
}  // namespace
template<>
struct concino::mesh_traits<movable> : mesh_traits<user_mesh::surface> {
  template<class X> static void set_point(movable& m, vert v, const X& x) { m.points[static_cast<std::size_t>(v.i)] = {x[0], x[1], x[2]}; }
};
static_assert(cn::MutablePoints<movable> && cn::MutablePoints<const movable&> && !cn::MutablePoints<user_mesh::surface>);

TEST_CASE("explain_... compiles for models of each concept") {
  cn::explain_embedded<user_mesh::volume>();
  cn::explain_any_mesh<const user_mesh::volume&>();
  cn::explain_any_mesh<user_mesh::surface>();
  cn::explain_mutable_points<movable>();
  cn::explain_embedded_mesh<user_mesh::volume>();
  cn::explain_embedded_graph<const user_mesh::surface&>();
}

TEST_CASE("set_point moves a vert") {
  movable m{user_mesh::surface_example()};
  cn::set_point(m, user_mesh::vertex{1}, std::array<double, 3>{3, 4, 5});
  CHECK(cn::point(m, user_mesh::vertex{1})[2] == 5);
}

TEST_CASE("contains has a default for meshes without it in their traits") {
  const auto s = user_mesh::surface_example();
  CHECK(cn::contains(s, user_mesh::vertex{7}));
  CHECK_FALSE(cn::contains(s, user_mesh::vertex{8}));
  CHECK_FALSE(cn::contains(s, user_mesh::vertex{}));
  CHECK(cn::contains(s, user_mesh::segment{0}));
  CHECK(cn::contains(s, user_mesh::cell{3}));
  CHECK_FALSE(cn::contains(s, user_mesh::cell{4}));
  CHECK(cn::contains(user_mesh::volume_example(), user_mesh::facet{9}));
  CHECK_FALSE(cn::contains(user_mesh::volume_example(), user_mesh::facet{10}));
}
