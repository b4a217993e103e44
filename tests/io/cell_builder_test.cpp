#include <concino/io/cell_builder.hpp>

#include <support/poly_volume.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

/// The unit cube, and an apex above it.
const std::vector<vec3> cube_and_apex = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}};

struct built_cells {
  load_report report;
  wanted_mesh wanted;
  std::vector<vec3> points = cube_and_apex;
  read_context in{"", "t", wanted, &report, nullptr, false};
  cell_builder cells{in, points, 1};

  explicit built_cells(wanted_mesh w = {}) : wanted(w) { in.wanted = w; }

  bool add(cell_shape s, std::vector<unsigned> v) {
    std::vector<vert_id> ids;
    for (const unsigned i : v) ids.push_back(vert_id{i});
    return cells.add_cell(s, ids.data());
  }
  bool polyhedron(std::vector<std::vector<unsigned>> faces) {
    for (const auto& f : faces) {
      std::vector<vert_id> ids;
      for (const unsigned i : f) ids.push_back(vert_id{i});
      cells.add_face(ids.data(), ids.size());
    }
    return cells.end_polyhedron();
  }
  volume_contents finish() {
    volume_contents out;
    cells.finish(out);
    return out;
  }
  std::string reason() const { return cells.expected + " | " + cells.found; }
};

const std::vector<std::vector<unsigned>> hex_faces = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
const std::vector<std::vector<unsigned>> tet_faces = {{0, 1, 2}, {0, 1, 4}, {1, 2, 4}, {0, 2, 4}};

double volume_of(const polyhedra_arrays& m) {
  double sum = 0;
  for (std::size_t p = 0; p < m.num_polys(); ++p) sum += testing::six_times_poly_volume(m, p) / 6;
  return sum;
}

}  // namespace

TEST_CASE("cell_builder: cells of one shape stay cells, unless they are prisms or pyramids") {
  built_cells tets;
  CHECK(tets.add(cell_shape::tet, {0, 1, 2, 4}));
  CHECK(tets.add(cell_shape::tet, {0, 2, 1, 4}));  // inside out
  CHECK(tets.cells.size() == 2);
  const volume_contents t = tets.finish();
  CHECK(t.filled == arrays_kind::cells);
  CHECK(t.cells.verts == std::vector<vert_id>{vert_id{0}, vert_id{1}, vert_id{2}, vert_id{4}, vert_id{0}, vert_id{2}, vert_id{4}, vert_id{1}});
  CHECK(t.cells.points.size() == 9);
  CHECK(tets.report.reoriented_polys == 1);
  built_cells pyramid;
  CHECK(pyramid.add(cell_shape::pyramid, {4, 5, 6, 7, 8}));
  const volume_contents p = pyramid.finish();
  CHECK(p.filled == arrays_kind::polyhedra);
  CHECK(volume_of(p.polyhedra) == doctest::Approx(1.0 / 3));
  CHECK(built_cells().finish().filled == arrays_kind::cells);
}

TEST_CASE("cell_builder: mixed cells share their faces, and are turned outward") {
  built_cells mixed;
  CHECK(mixed.add(cell_shape::pyramid, {5, 4, 7, 6, 8}));
  CHECK(mixed.polyhedron(hex_faces));
  const volume_contents m = mixed.finish();
  REQUIRE(m.filled == arrays_kind::polyhedra);
  CHECK(m.polyhedra.num_polys() == 2);
  CHECK(m.polyhedra.num_faces() == 10);
  CHECK(volume_of(m.polyhedra) == doctest::Approx(1 + 1.0 / 3));
  CHECK(mixed.report.reoriented_polys == 2);
  CHECK(mixed.report.notes == std::vector<std::string>{"1 of 2 cells had a negative volume: their verts were put into the standard order",
                                                       "1 of 2 polyhedra were wound inconsistently or inside out: their faces were turned outward"});
}

TEST_CASE("cell_builder: polyhedra that are tets or hexes fit meshes of tets or hexes") {
  built_cells hexes({false, true, false, 8});
  CHECK(hexes.polyhedron(hex_faces));
  CHECK(!hexes.polyhedron(tet_faces));
  CHECK(hexes.reason() == "a hex (polyhedralmesh and load_any take any cell) | a tet of 4 faces");
  CHECK(!hexes.add(cell_shape::prism, {0, 1, 2, 4, 5, 6}));
  CHECK(hexes.reason() == "a hex (polyhedralmesh and load_any take any cell) | a prism of 5 faces");
  const volume_contents h = hexes.finish();
  REQUIRE(h.filled == arrays_kind::cells);
  CHECK(h.cells.num_polys() == 1);
  CHECK(six_times_volume(cell_shape::hex, h.cells.verts.data(), h.cells.points) == doctest::Approx(6));
  built_cells either({false, true, false, 0});
  CHECK(either.polyhedron(tet_faces));
  CHECK(!either.add(cell_shape::hex, {0, 1, 2, 3, 4, 5, 6, 7}));
  CHECK(!either.polyhedron({{4, 5, 6, 7}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}}));
  CHECK(either.finish().cells.arity == 4);
}

TEST_CASE("cell_builder: rejects cells that are no cells, and names the vert") {
  built_cells bad;
  CHECK(!bad.add(cell_shape::tet, {0, 1, 1, 3}));
  CHECK(bad.reason() == "different verts in a cell (or set options.repeated_verts) | vert 2 twice");
  CHECK(!bad.cells.end_polyhedron());
  CHECK(bad.reason() == "a polyhedron of at least one face | one without faces");
  CHECK(!bad.polyhedron({{0, 1, 2}, {0, 1}, {2, 2, 3}}));
  CHECK(bad.reason() == "a face of at least three verts | one of 2");
  CHECK(!bad.polyhedron({{0, 1, 2, 0}, {0, 1, 3}}));
  CHECK(bad.reason() == "different verts in a face (or set options.repeated_verts) | vert 1 twice");
  CHECK(!bad.polyhedron({{0, 1, 2}, {0, 1, 4}, {2, 1, 0}}));
  CHECK(bad.reason() == "different faces in a polyhedron | two with the same verts");
  CHECK(bad.cells.size() == 0);
}

TEST_CASE("cell_builder: faces with equal sums of verts are different, and many faces are compared too") {
  built_cells some;
  CHECK(some.polyhedron({{0, 5, 4}, {1, 2, 6}, {1, 3, 5}}));
  std::vector<std::vector<unsigned>> many;
  for (unsigned i = 0; i < 9; ++i)
    for (unsigned j = 0; j < i; ++j)
      for (unsigned k = 0; k < j; ++k) many.push_back({i, j, k});
  CHECK(some.polyhedron(many));
  many.push_back({5, 3, 1});
  CHECK(!some.polyhedron(many));
  CHECK(some.reason() == "different faces in a polyhedron | two with the same verts");
  CHECK(some.cells.size() == 2);
}
