#include <concino/io/load_any.hpp>

#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string cube =
    "MeshVersionFormatted 2 Dimension 3 Vertices 8 0 0 0 0  1 0 0 0  1 1 0 0  0 1 0 0 0 0 1 0  1 0 1 0  1 1 1 0  0 1 1 0\n";

}  // namespace

TEST_CASE("load_any: returns the most special kind that can hold the file") {
  const testing::temporary_folder dir;
  const auto kind = [&](const std::string& name, const std::string& text) {
    testing::write_file(dir / name, text);
    const any_mesh m = load_any(dir / name);
    CHECK(std::visit([](const auto& mesh) { return num_verts(mesh); }, m) == (name == "a.hedra" ? 0 : name == "a.mesh" ? 8 : 4));
    return m.index();
  };
  CHECK(kind("a.obj", square + "f 1 2 3\n") == 0);
  CHECK(kind("a.obj", square + "f 1 2 3 4\n") == 1);
  CHECK(kind("a.obj", square + "f 1 2 3 4\nf 1 2 3\n") == 2);
  CHECK(kind("a.obj", square) == 2);
  CHECK(kind("a.mesh", cube + "Triangles 1 1 2 3 0 End") == 0);
  CHECK(kind("a.mesh", cube + "Quadrilaterals 1 1 2 3 4 0 End") == 1);
  CHECK(kind("a.mesh", cube + "Quadrilaterals 1 1 2 3 4 0 Triangles 1 1 2 3 0 End") == 2);
  CHECK(kind("a.mesh", cube + "Quadrilaterals 1 1 2 3 4 0 Tetrahedra 1 1 2 3 6 0 End") == 3);
  CHECK(kind("a.mesh", cube + "Hexahedra 1 1 2 3 4 5 6 7 8 0 End") == 4);
  CHECK(kind("a.mesh", cube + "Hexahedra 1 1 2 3 4 5 6 7 8 0 Tetrahedra 1 1 2 3 6 0 End") == 5);
  CHECK(kind("a.mesh", cube + "Prisms 1 1 2 3 5 6 7 0 End") == 5);
  CHECK(kind("a.hedra", "0 0 0") == 5);
}

TEST_CASE("load_any: has the errors, labels and reports of load") {
  const testing::temporary_folder dir;
  CHECK_THROWS_AS(load_any(dir / "none.obj"), io_error);
  CHECK_THROWS_AS(load_any(dir / "none.xyz"), io_error);
  testing::write_file(dir / "some.xyz", "0 0 0\n");
  CHECK_THROWS_AS(load_any(dir / "some.xyz"), unsupported);
  testing::write_file(dir / "bad.obj", "v 0 0\n");
  CHECK_THROWS_AS(load_any(dir / "bad.obj"), parse_error);
  testing::write_file(dir / "a.mesh", cube + "Triangles 1 1 2 3 5 Tangents 1 1 2 0 End");
  load_report r;
  const any_mesh m = load_any(dir / "a.mesh", {.report = &r});
  CHECK(find_poly_property<int>(std::get<trimesh>(m), "label")[poly_id{0}] == 5);
  CHECK(r.skipped == std::vector<std::string>{"section Tangents, 1 rows"});
}
