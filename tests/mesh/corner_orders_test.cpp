// Hexes and tets can be constructed from the corner orders of other libraries; validate names the order that a list seems to have.
#include <concino/adapters/span.hpp>
#include <concino/mesh/corner_orders.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/meshes.hpp>
#include <support/models.hpp>

#include <doctest/doctest.h>

#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// A box divided into boxes. Each hex lists the corners x + 2 y + 4 z of the unit cube in the order `places`.
struct boxes {
  std::vector<vec3> points;
  std::vector<std::array<int, 8>> hexes;

  boxes(int nx, int ny, int nz, const std::array<int, 8>& places, vec3 step = {1, 1, 1}) {
    for (int z = 0; z <= nz; ++z)
      for (int y = 0; y <= ny; ++y)
        for (int x = 0; x <= nx; ++x) points.push_back({step.x * x, step.y * y, step.z * z});
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
          hexes.emplace_back();
          for (std::size_t k = 0; k < 8; ++k) {
            const int c = places[k];
            hexes.back()[k] = x + c % 2 + (nx + 1) * (y + c / 2 % 2 + (ny + 1) * (z + c / 4));
          }
        }
  }
};

struct order_of_corners {
  hex_order order;
  std::array<int, 8> places;
};
const order_of_corners orders[] = {{hex_order::standard, {0, 1, 3, 2, 4, 5, 7, 6}},
                                   {hex_order::lexicographic, {0, 1, 2, 3, 4, 5, 6, 7}},
                                   {hex_order::mirrored, {0, 2, 3, 1, 4, 6, 7, 5}},
                                   {hex_order::mirrored_lexicographic, {0, 2, 1, 3, 4, 6, 5, 7}}};

template<class M>
std::vector<std::vector<vert_id>> corners(const M& m) {
  std::vector<std::vector<vert_id>> all;
  for (const auto p : polys(m)) {
    all.emplace_back();
    for (const auto v : adj_p2v(m, p)) all.back().push_back(v);
  }
  return all;
}

const std::vector<int> one_tet = {0, 1, 2, 3}, mirrored_tet = {0, 1, 3, 2};

}  // namespace

static_assert(hex_order::vtk == hex_order::standard && hex_order::abaqus == hex_order::standard && tet_order::gmsh == tet_order::standard);

TEST_CASE("corner orders: every order gives the same hexes") {
  const boxes standard(3, 2, 2, orders[0].places, {1, 2, 0.5});
  const hexmesh expected(standard.points, standard.hexes);
  for (const auto& o : orders) {
    const boxes b(3, 2, 2, o.places, {1, 2, 0.5});
    const hexmesh m(b.points, b.hexes, o.order);
    CHECK(corners(m).size() == 12);
    CHECK(total_measure(m) == doctest::Approx(12));
    CHECK(validate(m).is_clean());
    if (o.order == hex_order::standard || o.order == hex_order::lexicographic) CHECK(corners(m) == corners(expected));

    // A view of the user's arrays, and tables with a user's mesh.
    const auto view = view_hex(b.points, b.hexes, o.order);
    CHECK(corners(view) == corners(m));
    CHECK(check_laws(view).empty());
    CHECK(validate(view).is_clean());
    CHECK(view.points().size() == b.points.size());
    std::vector<vert_id> flat;
    for (const auto& hex : b.hexes)
      for (const int v : hex) flat.push_back(vert_id{v});
    const hex_tables tables(b.points.size(), flat, o.order);
    for (const poly_id p : polys(m)) CHECK(std::equal(tables.adj_p2v(p).begin(), tables.adj_p2v(p).end(), corners(m)[p.raw()].begin()));
    CHECK(tables.faces().size() == num_faces(m));
  }
}

TEST_CASE("corner orders: mirrored tets are the same meshes") {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto view = view_tet(points, mirrored_tet, tet_order::mirrored);
  CHECK(corners(view) == corners(view_tet(points, one_tet)));
  CHECK(total_measure(view) == doctest::Approx(1. / 6));
  CHECK(validate(view_tet(points, mirrored_tet)).count(defect_kind::inverted_cell) == 1);
  CHECK(corners(tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 3, 2}}, tet_order::mirrored)) == corners(view));
  CHECK(corners(tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, tet_order::vtk)) == corners(view));
}

TEST_CASE("corner orders: errors are the same in every order") {
  const std::vector<double> points(24), seven_numbers(7);
  const std::vector<int> twice = {0, 1, 2, 3, 4, 5, 6, 6}, beyond = {0, 1, 2, 3, 4, 5, 6, 8}, seven = {0, 1, 2, 3, 4, 5, 6};
  CHECK_THROWS_WITH_AS(view_hex(points, twice, hex_order::lexicographic), "cell_tables: poly 0 has vert 6 twice; its verts must differ", invalid_mesh);
  CHECK_THROWS_WITH_AS(view_hex(points, beyond, hex_order::lexicographic),
                       "view_hex: poly 0 names point 8, but there are 8 points, numbered from 0", invalid_mesh);
  CHECK_THROWS_WITH_AS(view_hex(points, seven, hex_order::lexicographic), "view_hex: the array of polys has 7 numbers; it needs 8 for each", invalid_mesh);
  CHECK_THROWS_WITH_AS(view_hex(seven_numbers, seven, hex_order::lexicographic), "view_hex: the array of points has 7 numbers; it needs 3 for each", invalid_mesh);
  CHECK_THROWS_WITH_AS(hex_tables(8, std::vector<vert_id>(9), hex_order::mirrored), "cell_tables: poly 1 has 1 verts; it needs 8", invalid_mesh);
}

TEST_CASE("corner orders: validate names the order that hexes seem to have") {
  for (const auto& o : orders)
    for (const double scale : {1., 1e-90, 1e90}) {
      const boxes b(3, 2, 2, o.places, {scale, 2 * scale, 0.5 * scale});
      const auto report = validate(hexmesh(b.points, b.hexes));
      const bool lexicographic = o.order == hex_order::lexicographic || o.order == hex_order::mirrored_lexicographic;
      CHECK(report.count(defect_kind::corner_order) == (lexicographic ? 12 : 0));
      CHECK(report.count(defect_kind::inverted_cell) == (o.order == hex_order::mirrored ? 12 : 0));
      for (const defect_kind k : {defect_kind::zero_size, defect_kind::self_touching, defect_kind::non_planar}) CHECK(report.count(k) == 0);
      if (lexicographic) CHECK(report[0].kind == defect_kind::corner_order);
      if (o.order == hex_order::lexicographic)
        CHECK(report[0].what == "the corners of hex 0 look like lexicographic order: read the lists with hex_order::lexicographic");
      if (o.order == hex_order::mirrored_lexicographic)
        CHECK(report[11].what == "the corners of hex 11 look like mirrored lexicographic order: read the lists with hex_order::mirrored_lexicographic");
    }
}

TEST_CASE("corner orders: check_laws names the order that all hexes seem to have") {
  for (const auto& o : orders) {
    const boxes b(3, 2, 2, o.places);
    const auto broken = check_laws(hexmesh(b.points, b.hexes));
    const bool lexicographic = o.order == hex_order::lexicographic || o.order == hex_order::mirrored_lexicographic;
    REQUIRE(broken.size() == (lexicographic ? 1 : 0));
    if (lexicographic) CHECK(broken[0].law == "EM2");
    if (o.order == hex_order::lexicographic)
      CHECK(broken[0].what == "the corners of all hexes look like lexicographic order: read the lists with hex_order::lexicographic");
  }
  boxes b(3, 2, 2, orders[1].places);
  b.hexes[7] = {b.hexes[7][0], b.hexes[7][1], b.hexes[7][3], b.hexes[7][2], b.hexes[7][4], b.hexes[7][5], b.hexes[7][7], b.hexes[7][6]};
  CHECK(check_laws(hexmesh(b.points, b.hexes)).empty());
  CHECK(check_laws(hexmesh()).empty());
}

TEST_CASE("corner orders: distorted hexes in the standard order are not reported") {
  boxes b(3, 2, 2, orders[0].places);
  std::swap(b.hexes[7][2], b.hexes[7][3]);
  std::swap(b.hexes[7][6], b.hexes[7][7]);
  const auto report = validate(hexmesh(b.points, b.hexes), {.kinds = {defect_kind::corner_order}});
  REQUIRE(report.count() == 1);
  CHECK(std::get<poly_id>(report[0].element) == poly_id{7});

  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.5, 0.5);
  for (int round = 0; round < 50; ++round) {
    boxes c(2, 2, 2, orders[0].places, {1, 1, round == 0 ? 0. : 1.});
    for (vec3& p : c.points) p += vec3{jitter(random), jitter(random), round ? jitter(random) : 0};
    CHECK(validate(hexmesh(c.points, c.hexes)).count(defect_kind::corner_order) == 0);
  }
}
