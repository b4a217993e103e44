#include <concino/io/detail/formats/boundary_flat_mesh.hpp>

#include <concino/edit/elements.hpp>
#include <concino/generate/boundary_surface.hpp>
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

std::string text_of(const auto& m, format_id f, save_report* r = nullptr) {
  return save_text(m, f, {.report = r, .as_triangles = true, .as_boundary = true});
}

}  // namespace

TEST_CASE_TEMPLATE("as_boundary: each format of surfaces holds what it holds of boundary_surface", M, tetmesh, hexmesh, polyhedralmesh) {
  M m = grid<M>(2);
  auto color = face_property<rgba>(m, "color");
  for (const auto f : faces(m)) color[f] = {static_cast<float>(f.raw() % 2), 0, 1};
  auto height = vert_property<double>(m, "height");
  for (const auto v : verts(m)) height[v] = point(m, v).z;
  *mesh_property<int>(m, "total") = 7;
  const auto surface = boundary_surface(m);
  for (const format_id f : {format_id(file_format::obj), format_id(file_format::off), format_id(file_format::ply), format_id(file_format::stl), format_id(file_format::vtp),
                            format_id(file_format::vtk), format_id(file_format::vtu), format_id(file_format::gltf)}) {
    CAPTURE(f.name());
    save_report r, of_surface;
    const std::string text = text_of(m, f, &r);
    CHECK(text == save_text(surface, f, {.report = &of_surface, .as_triangles = true}));
    CHECK(r.lost.size() == of_surface.lost.size() + (num_verts(m) > num_verts(surface) ? 2 : 1));
  }
  for (const format_id f : {format_id(file_format::hedra), format_id(file_format::hybrid), format_id(file_format::tet), format_id(file_format::ovm)})
    CHECK_THROWS_WITH_AS(text_of(m, f), doctest::Contains("cannot hold surfaces, such as the boundary of a volume; save it as .obj or .ply"), unsupported);
  CHECK_THROWS_WITH_AS(text_of(m, file_format::iv), doctest::Contains("can be read, but not written"), unsupported);
}

TEST_CASE("as_boundary: what is inside is reported as lost") {
  hexmesh m = grid<hexmesh>(3);
  poly_property<int>(m, "label");
  face_property<int>(m, "label");
  save_report r;
  text_of(m, file_format::ply, &r);
  CHECK(r.lost == list{"27 polys: the boundary surface of 54 polys was saved instead", "8 verts that are not on the boundary", "poly property \"label\": the polys of the boundary are faces"});
  text_of(m, file_format::stl, &r);
  CHECK(r.lost.size() == 5);
  CHECK_THROWS_AS(save_text(m, file_format::ply, {.as_boundary = true, .strict = true}), unsupported);
  const trimesh s = grid<trimesh>(2);
  CHECK(text_of(s, file_format::obj, &r) == save_text(s, file_format::obj));
  CHECK(r.lost.empty());
  CHECK(text_of(tetmesh(), file_format::off, &r) == save_text(trimesh(), file_format::off));
}

TEST_CASE("as_boundary: values of edges follow, and faces between two polys do not") {
  tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 3, 2, 4}});
  auto length = edge_property<double>(m, "length");
  for (const auto e : edges(m)) length[e] = 1 + static_cast<double>(e.raw());
  const std::string text = save_text(m, file_format::ply, {.as_boundary = true});
  const auto back = load_text<trimesh>(text, file_format::ply);
  CHECK(num_polys(back) == 6);
  const auto of_back = find_edge_property<double>(back, "length");
  REQUIRE(static_cast<bool>(of_back));
  for (const auto e : edges(back)) {
    const auto a = adj_e2v(back, e);
    for (const auto x : edges(m)) {
      const auto b = adj_e2v(m, x);
      if ((a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[0])) CHECK(of_back[e] == length[x]);
    }
  }
}

TEST_CASE("as_boundary: a mesh from which polys were removed") {
  polyhedralmesh m = grid<polyhedralmesh>(2);
  remove_poly(m, poly_id{0});
  CHECK(text_of(m, file_format::off) == save_text(boundary_surface(m), file_format::off));
}

TEST_CASE("as_boundary: the messages name the elements of the volume") {
  tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  m.points()[3].x = 1e300;
  CHECK_THROWS_AS(text_of(m, file_format::gltf), unsupported);
  const hexmesh h = grid<hexmesh>(1);
  CHECK_THROWS_WITH_AS(save_text(h, file_format::stl, {.as_boundary = true}), "text: .stl cannot hold poly 0 of 4 corners, unless options.as_triangles is set; save it as .ply or .obj", unsupported);
}
