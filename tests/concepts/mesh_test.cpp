// Embedded, AnyMesh, MutablePoints and the verb contains.
#include <concino/concepts/mesh.hpp>

#include <support/tiny.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {
struct movable : tiny::surface {};
}  // namespace
template<>
struct concino::mesh_traits<movable> : mesh_traits<tiny::surface> {
  template<class X> static void set_point(movable& m, vert v, const X& x) { m.points[static_cast<std::size_t>(v.i)] = {x[0], x[1], x[2]}; }
};
static_assert(cn::MutablePoints<movable> && cn::MutablePoints<const movable&> && !cn::MutablePoints<tiny::surface>);

TEST_CASE("explain says nothing about models") {
  cn::explain_embedded<tiny::volume>();
  cn::explain_any_mesh<const tiny::volume&>();
  cn::explain_any_mesh<tiny::surface>();
  cn::explain_mutable_points<movable>();
  cn::explain_embedded_mesh<tiny::volume>();
  cn::explain_embedded_graph<const tiny::surface&>();
}

TEST_CASE("set_point moves a vert") {
  movable m{tiny::surface_example()};
  cn::set_point(m, tiny::vertex{1}, std::array<double, 3>{3, 4, 5});
  CHECK(cn::point(m, tiny::vertex{1})[2] == 5);
}

TEST_CASE("contains is answered for meshes whose traits do not offer it") {
  const auto s = tiny::surface_example();
  CHECK(cn::contains(s, tiny::vertex{7}));
  CHECK_FALSE(cn::contains(s, tiny::vertex{8}));
  CHECK_FALSE(cn::contains(s, tiny::vertex{}));
  CHECK(cn::contains(s, tiny::segment{0}));
  CHECK(cn::contains(s, tiny::cell{3}));
  CHECK_FALSE(cn::contains(s, tiny::cell{4}));
  CHECK(cn::contains(tiny::volume_example(), tiny::facet{9}));
  CHECK_FALSE(cn::contains(tiny::volume_example(), tiny::facet{10}));
}
