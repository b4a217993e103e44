#include <concino/render/any_colors.hpp>
#include <concino/render/make_drawable.hpp>

#include <concino/core/rgba.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/facet_map.hpp>

#include <doctest/doctest.h>
#include <support/kinds.hpp>

using namespace concino;

namespace {

/// Texture coordinates that tell all corners apart: the index of the poly, and that of the vert.
template<class M>
auto corner_names(const M& m) {
  auto names = make_corner_map<std::array<double, 2>>(m);
  for (const poly_t<M> p : polys(m)) {
    std::uint32_t k = 0;
    for (const vert_t<M> v : adj_p2v(m, p))
      names[corner<M>{p, k++}] = {static_cast<double>(index_of(m, p)), static_cast<double>(index_of(m, v))};
  }
  return names;
}

static_assert(!std::is_convertible_v<int, any_colors<trimesh>> && !std::is_convertible_v<vert_map<trimesh, double>, any_colors<trimesh>>);
static_assert(!std::is_convertible_v<poly_map<trimesh, std::array<double, 2>>, any_texture_coordinates<trimesh>>);
static_assert(std::is_convertible_v<vert_map<trimesh, vec3>, any_texture_coordinates<trimesh>>);
static_assert(std::is_convertible_v<face_map<tetmesh, rgb>, any_colors<tetmesh>> && !std::is_convertible_v<face_map<tetmesh, rgb>, any_colors<trimesh>>);

}  // namespace

TEST_CASE_TEMPLATE("any_texture_coordinates: corners of a drawable have those of their vert or of their corner", M, CONCINO_KINDS) {
  const M m = testing::grid<M>(2);
  const auto names = corner_names(m);
  auto at_verts = make_vert_map<std::array<float, 2>>(m);
  for (const vert_t<M> v : verts(m)) at_verts[v] = {static_cast<float>(index_of(m, v)), 7};
  const drawable d = make_drawable(m, {.texture_coordinates = names}), e = make_drawable(m, {.texture_coordinates = at_verts});
  REQUIRE(d.texture_coordinates.size() == d.corners.size());
  REQUIRE(e.texture_coordinates.size() == e.corners.size());
  for (std::size_t p = 0; p < d.polygons().size(); ++p)
    for (std::uint32_t c = d.offsets[p]; c < d.offsets[p + 1]; ++c) {
      const float vert = static_cast<float>(d.verts[d.corners[c]]);
      CHECK(d.texture_coordinates[c] == std::array{static_cast<float>(d.polys[p]), vert});
      CHECK(e.texture_coordinates[c] == std::array{vert, 7.0f});
    }
}

TEST_CASE_TEMPLATE("any_colors: colours at verts, polys and corners become those of the drawable", M, CONCINO_KINDS) {
  const M m = testing::grid<M>(2);
  const auto color_of = [](std::size_t i) { return rgb{static_cast<float>(i), 0.5f, 0}; };
  auto at_verts = make_vert_map<rgb>(m);
  for (const vert_t<M> v : verts(m)) at_verts[v] = color_of(index_of(m, v));
  auto at_polys = make_poly_map<rgb>(m);
  for (const poly_t<M> p : polys(m)) at_polys[p] = color_of(index_of(m, p));
  const drawable v = make_drawable(m, {.colors = at_verts}), p = make_drawable(m, {.colors = at_polys});
  CHECK(v.colors_at == value_place::points);
  REQUIRE(v.colors.size() == v.points.size());
  for (std::size_t i = 0; i < v.points.size(); ++i) CHECK(v.colors[i] == color_of(v.verts[i]));
  CHECK(p.colors_at == value_place::polygons);
  REQUIRE(p.colors.size() == p.polygons().size());
  for (std::size_t i = 0; i < p.colors.size(); ++i) CHECK(p.colors[i] == color_of(p.polys[i]));
  const drawable c = make_drawable(m, {.colors = make_corner_map<rgb>(m, rgb{0, 1, 0})});
  CHECK(c.colors_at == value_place::corners);
  CHECK(c.colors == std::vector<rgb>(c.corners.size(), rgb{0, 1, 0}));
  if constexpr (VolumeMesh<M>) {
    auto at_faces = make_face_map<rgb>(m);
    for (const face_t<M> f : faces(m)) at_faces[f] = color_of(index_of(m, f));
    const drawable f = make_drawable(m, {.colors = at_faces});
    for (std::size_t i = 0; i < f.colors.size(); ++i) CHECK(f.colors[i] == color_of(f.mesh_polygons[i]));
  }
}

TEST_CASE("any_colors: properties of files are read; those that a mesh lacks and maps of other meshes throw") {
  trimesh m(testing::triangle_grid(1)), other(testing::triangle_grid(1));
  for (const auto v : verts(m)) vert_property<rgba>(m, "color")[v] = rgba{1, 0.5f, 0, 0.3f};
  const drawable d = make_drawable(m, {.colors = find_vert_property<rgba>(m, "color")});
  CHECK(d.colors == std::vector<rgb>(4, srgb(1, 0.5f, 0)));
  corner_property<std::array<double, 2>>(m, "texture")[corner<trimesh>{*polys(m).begin(), 1}] = {0.25, 0.75};
  const drawable t = make_drawable(m, {.texture = texture::checkerboard(), .texture_coordinates = find_corner_property<std::array<double, 2>>(m, "texture")});
  CHECK(t.texture_coordinates[1] == std::array{0.25f, 0.75f});
  CHECK(static_cast<bool>(t.look.texture));
  CHECK_THROWS_WITH_AS(make_drawable(m, {.colors = find_vert_property<rgba>(m, "none")}), doctest::Contains("no such property"), invalid_argument);
  CHECK_THROWS_AS(make_drawable(m, {.texture_coordinates = find_corner_property<std::array<double, 2>>(m, "none")}), invalid_argument);
  CHECK_THROWS_AS(make_drawable(m, {.colors = make_poly_map<rgb>(other)}), invalid_argument);
  CHECK_THROWS_AS(make_drawable(m, {.texture_coordinates = corner_names(other)}), invalid_argument);
  CHECK_THROWS_WITH_AS(make_drawable(m, {.texture = texture::checkerboard()}), "make_drawable: a texture needs texture_coordinates", invalid_argument);
}
