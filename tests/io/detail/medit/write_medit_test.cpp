#include <concino/io/detail/medit/write_medit.hpp>

#include <concino/io/load.hpp>
#include <concino/io/medit.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// A mesh with values of every kind that MEDIT files hold.
template<class M>
M marked_mesh() {
  M m = grid<M>(2);
  int i = 0;
  for (const auto v : verts(m)) {
    vert_property<int>(m, "label")[v] = ++i;
    vert_property<int>(m, "corner")[v] = i % 3 == 0;
    vert_property<int>(m, "required")[v] = i % 4 == 0;
    if (i % 2) vert_property<vec3>(m, "normal")[v] = {1.0 / i, 0, 1};
  }
  for (const auto e : edges(m)) {
    ++i;
    edge_property<int>(m, "label")[e] = i % 2;
    edge_property<int>(m, "ridge")[e] = i % 3 == 0;
    edge_property<int>(m, "required")[e] = i % 5 == 0;
    edge_property<int>(m, "entity")[e] = i % 7 == 0 || i % 2 || i % 3 == 0 || i % 5 == 0;
  }
  for (const auto p : polys(m)) poly_property<int>(m, "label")[p] = --i;
  if constexpr (dimension_v<M> == 2) {
    for (const auto p : polys(m)) poly_property<int>(m, "required")[p] = --i % 2 != 0;
  } else {
    for (const auto f : faces(m)) {
      ++i;
      face_property<int>(m, "label")[f] = i % 4;
      face_property<int>(m, "required")[f] = i % 3 == 0;
    }
  }
  return m;
}

}  // namespace

TEST_CASE_TEMPLATE("write_medit: values of all elements are read back, and written as the same bytes", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const M m = marked_mesh<M>();
  for (const bool binary : {false, true}) {
    save_report lost;
    const std::string text = save_text(m, file_format::medit, {.report = &lost, .binary = binary});
    CHECK(lost.lost.empty());
    CHECK(lost.notes.empty());
    load_report r;
    const M again = load_text<M>(text, file_format::medit, {.report = &r});
    CHECK(r.skipped.empty());
    CHECK(r.notes.empty());
    for (const char* name : {"label", "corner", "required"})
      for (const auto v : verts(m)) CHECK(find_vert_property<int>(m, name)[v] == find_vert_property<int>(again, name)[v]);
    for (const auto v : verts(m)) CHECK(find_vert_property<vec3>(m, "normal")[v] == find_vert_property<vec3>(again, "normal")[v]);
    for (const char* name : {"label", "ridge", "required", "entity"})
      for (const auto e : edges(m)) CHECK(find_edge_property<int>(m, name)[e] == find_edge_property<int>(again, name)[e]);
    for (const auto p : polys(m)) CHECK(find_poly_property<int>(m, "label")[p] == find_poly_property<int>(again, "label")[p]);
    if constexpr (dimension_v<M> == 2) {
      for (const auto p : polys(m)) CHECK(find_poly_property<int>(m, "required")[p] == find_poly_property<int>(again, "required")[p]);
    } else {
      for (const char* name : {"label", "required"})
        for (const auto f : faces(m)) CHECK(find_face_property<int>(m, name)[f] == find_face_property<int>(again, name)[f]);
    }
    CHECK(save_text(again, file_format::medit, {.binary = binary}) == text);
    CHECK(save_text(again, file_format::medit, {.binary = binary, .strict = true}) == text);
  }
}

TEST_CASE("write_medit: writes the sections of the format") {
  tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  vert_property<int>(m, "corner")[vert_id{3}] = 1;
  for (const auto e : edges(m)) edge_property<int>(m, "ridge")[e] = e == edge_id{0};
  face_property<int>(m, "label")[face_id{1}] = 5;
  face_property<int>(m, "required")[face_id{0}] = 1;
  vert_property<vec3>(m, "normal")[vert_id{1}] = {0, 0.5, 0};
  CHECK(save_text(m, file_format::medit) ==
        "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTriangles\n2\n1 3 2 0\n1 2 4 5\nTetrahedra\n1\n1 2 3 4 0\n"
        "Edges\n1\n1 2 0\nCorners\n1\n4\nRidges\n1\n1\nRequiredTriangles\n1\n1\nNormals\n1\n0 0.5 0\nNormalAtVertices\n1\n2 1\nEnd\n");
}

TEST_CASE("write_medit: reports what is lost") {
  trimesh m = grid<trimesh>(1);
  vert_property<int>(m, "corner")[vert_id{0}] = 2;
  vert_property<double>(m, "ridge");
  save_report r;
  const auto again = load_text<trimesh>(save_text(m, file_format::medit, {.report = &r}), file_format::medit);
  CHECK(find_vert_property<int>(again, "corner")[vert_id{0}] == 1);
  CHECK(r.lost == std::vector<std::string>{"1 marks of elements (\"corner\", \"required\", \"ridge\", \"entity\") that are neither 0 nor 1: written as 1",
                                           "vert property \"ridge\": .mesh cannot store it"});
  CHECK_THROWS_AS(save_text(m, file_format::medit, {.strict = true}), unsupported);

  // a face of five verts that belongs to no cell
  polyhedra_arrays a;
  a.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  a.face_offsets = {0, 5};
  for (unsigned v = 0; v < 5; ++v) a.face_verts.push_back(vert_id{v});
  a.poly_offsets = {0};
  polyhedralmesh loose(std::move(a));
  face_property<int>(loose, "label")[face_id{0}] = 3;
  save_text(loose, file_format::medit, {.report = &r});
  CHECK(r.lost == std::vector<std::string>{"values of 1 faces that are neither triangles nor quads",
                                           "1 faces of no poly: .mesh lists no faces; .hedra holds them"});
}

TEST_CASE("write_medit: a normal without finite components is lost, and the second save is the first") {
  trimesh m = grid<trimesh>(2);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto normal = vert_property<vec3>(m, "normal");
  normal[vert_id{0}] = {0, infinity, 0};
  normal[vert_id{1}] = {0, infinity, 2};
  save_report report;
  const std::string text = save_text(m, file_format::medit, {.report = &report});
  CHECK(report.lost == std::vector<std::string>{"2 numbers of colours and other properties that are not finite: written as 0"});
  CHECK(text.find("Normals\n1\n0 0 2\n") != std::string::npos);
  CHECK(save_text(load_text<trimesh>(text, file_format::medit), file_format::medit) == text);
}
