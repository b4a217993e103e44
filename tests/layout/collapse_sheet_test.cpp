// Collapses and insertions of chords and sheets, pillows and collapses along diagonals: inverses of each other, laws, values, refusals, bad input.
#include <concino/layout/collapse_sheet.hpp>
#include <concino/layout/diagonal_collapse.hpp>
#include <concino/layout/insert_sheet.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/property.hpp>
#include <concino/quality/worst.hpp>
#include <concino/validate.hpp>

#include <support/corpus.hpp>
#include <support/layouts.hpp>
#include <support/same_mesh.hpp>
#include <support/sheet_edits.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("collapse and insert restore counts, chords and blocks", M, quadmesh, hexmesh) {
  std::size_t restored = 0, refused = 0;
  for (const auto& one : meshes_with_layouts<M>(false)) {
    INFO(one.name);
    const M& before = one.mesh;
    const auto old_counts = counts_of(before);
    const std::size_t blocks = coarse_layout(before).num_blocks;
    std::size_t k = 0;
    for (const auto& s : layers_of(before)) {
      if (++k % (num_polys(before) > 500 ? 7 : 1)) continue;
      M m = before;
      const auto allowed = can_collapse_layer(m, s);
      const auto back = collapse_layer(m, s);
      REQUIRE(back.reason == allowed.reason);
      if (!back) {
        ++refused;
        CHECK(record_of(m) == record_of(before));
        continue;
      }
      CHECK(check_laws(m).empty());
      CHECK(chi_of(m) == chi_of(before));
      CHECK(num_polys(m) < num_polys(before));
      CHECK(validate(m).facts.components == validate(before).facts.components);
      if (s.crosses_itself || facets_of(back).empty()) continue;
      const auto r = insert_layer(m, facets_of(back));
      REQUIRE(r);
      CHECK(check_laws(m).empty());
      CHECK(counts_of(m) == old_counts);
      CHECK(r.polys.size() == polys_of(s).size());
      CHECK(coarse_layout(m).num_blocks == blocks);
      CHECK(summary_of_layers(m) == summary_of_layers(before));
      CHECK(layer_through(m, r.edge).polys.size() == r.polys.size());
      ++restored;
    }
  }
  const bool has_real_meshes = !corpus("hex/hollow_sphere.mesh").empty();
  CHECK(restored > (has_real_meshes ? 40 : 20));
  if (has_real_meshes) CHECK(refused > 5);
}

TEST_CASE_TEMPLATE("insertions push back what is beside them, and keep the boundary", M, quadmesh, hexmesh) {
  // a boundary layer of a grid, and one in its middle
  M m = make_grid<M>({.cells = {4, 4, 4}});
  const double size = total_measure(m);
  const double quality = worst(m, metric::scaled_jacobian).value;
  CHECK(quality == doctest::Approx(1));
  const auto r = pillow(m, std::vector<poly_id>(polys(m).begin(), polys(m).end()));
  REQUIRE(r);
  CHECK(total_measure(m) == doctest::Approx(size));
  CHECK(worst(m, metric::scaled_jacobian).value > 0.5);
  CHECK(num_polys(m) == (dimension_v<M> == 2 ? 32 : 160));
  std::vector<facet_t<M>> middle;
  M grid = make_grid<M>({.cells = {4, 4, 4}});
  for (const auto f : facets(grid)) {
    bool is_middle = true;
    for (const auto v : adj_facet2v(grid, f)) is_middle = is_middle && point(grid, v).x == 0.5;
    if (is_middle) middle.push_back(f);
  }
  for (const double t : {0.0, 0.25, 0.5}) {
    M n = grid;
    REQUIRE(insert_layer(n, middle, {.thickness = t}));
    CHECK(total_measure(n) == doctest::Approx(size));
    CHECK(coarse_layout(n).num_blocks == 1);
    double added = 0;
    for (const auto p : polys(n))
      if (p.raw() >= num_polys(grid)) added += measure(n, p);
    CHECK(added == doctest::Approx(0.5 * t));
    if (t > 0) CHECK(worst(n, metric::scaled_jacobian).value == doctest::Approx(1));
    for (const auto v : verts(n))
      for (std::size_t k = 0; k < 3; ++k) CHECK((point(n, v)[k] >= 0 && point(n, v)[k] <= 1));
  }
  // a single poly within
  const auto one = pillow(m, std::vector<poly_id>{poly_id{5}});
  REQUIRE(one);
  CHECK(one.polys.size() == 2 * dimension_v<M>);
  CHECK(worst(m, metric::scaled_jacobian).value > 0.2);
  CHECK(total_measure(m) == doctest::Approx(size));
  CHECK(check_laws(m).empty());
}

TEST_CASE_TEMPLATE("collapses and insertions: refusals leave the mesh equal", M, quadmesh, hexmesh) {
  M m = make_grid<M>({.cells = {1, 3, 3}});
  const auto before = record_of(m);
  std::size_t refused = 0;
  for (const auto& s : layers_of(m)) {
    M other = m;
    if (!collapse_layer(other, s)) {
      ++refused;
      CHECK(record_of(other) == before);
      CHECK(can_collapse_layer(m, s).reason == refusal::link_condition);
    }
  }
  CHECK(refused == 1);  // the one between two boundaries
  auto s = layer_through(m, edge_id{0});
  cut_short(s);
  CHECK(can_collapse_layer(m, s).reason == refusal::wrong_set);
  CHECK(collapse_layer(m, decltype(s){}).reason == refusal::wrong_set);
  // facets that end within, that are listed twice, none
  M grid = make_grid<M>({.cells = {3, 3, 3}});
  const auto old = record_of(grid);
  facet_t<M> within{};
  for (const auto f : facets(grid))
    if (!is_boundary(grid, f)) within = f;
  const auto all = [&] { return std::vector<poly_id>(polys(grid).begin(), polys(grid).end()); };
  CHECK(insert_layer(grid, std::vector<facet_t<M>>{within, within}).reason == refusal::wrong_set);
  CHECK(insert_layer(grid, std::vector<facet_t<M>>{}).reason == refusal::wrong_set);
  CHECK(pillow(grid, all(), {.at_boundary = false}).reason == refusal::wrong_set);
  CHECK(pillow(grid, {}).reason == refusal::wrong_set);
  CHECK(can_pillow(grid, all()).reason == refusal::none);
  // two polys that touch at a vert or an edge
  const auto pair = dimension_v<M> == 2 ? std::vector<poly_id>{poly_id{0}, poly_id{4}} : std::vector<poly_id>{poly_id{0}, poly_id{13}};
  CHECK_FALSE(pillow(grid, pair));
  CHECK(record_of(grid) == old);
  for (const double bad : {-0.1, 1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(insert_layer(grid, std::vector<facet_t<M>>{within}, {.thickness = bad}), invalid_argument);
    CHECK_THROWS_AS(pillow(grid, all(), {.thickness = bad}), invalid_argument);
  }
  CHECK_THROWS_AS(insert_layer(grid, std::vector<facet_t<M>>{facet_t<M>{999u}}), invalid_mesh);
  CHECK_THROWS_AS(pillow(grid, std::vector<poly_id>{poly_id{999}}), invalid_mesh);
  auto stranger = layer_through(grid, edge_id{0});
  edges_of(stranger)[0] = edge_id{999};
  CHECK_THROWS_AS(collapse_layer(grid, stranger), invalid_mesh);
  CHECK(record_of(grid) == old);
}

TEST_CASE_TEMPLATE("collapses and insertions are undone, and carry values over", M, quadmesh, hexmesh) {
  M m = make_grid<M>({.cells = {4, 3, 3}});
  const auto x = vert_property<double>(m, "x");
  const auto label = poly_property<int>(m, "label");
  for (const auto v : verts(m)) x[v] = point(m, v).x;
  for (const auto p : polys(m)) label[p] = 1 + static_cast<int>(p.raw());
  const auto before = record_of(m);
  {
    transaction t(m);
    REQUIRE(collapse_layer(m, layer_through(m, edge_id{0})));
    REQUIRE(pillow(m, std::vector<poly_id>(polys(m).begin(), polys(m).end())));
  }
  CHECK(record_of(m) == before);
  for (const auto v : verts(m)) CHECK(x[v] == point(m, v).x);
  const auto back = collapse_layer(m, layer_through(m, edge_id{0}));
  REQUIRE(back);
  for (const auto v : verts(m)) CHECK(x[v] == doctest::Approx(point(m, v).x));
  for (const auto p : polys(m)) CHECK(label[p] == 1 + static_cast<int>(p.raw()));
  const auto r = insert_layer(m, facets_of(back), {.thickness = 0});
  REQUIRE(r);
  for (const auto v : verts(m)) CHECK(x[v] == doctest::Approx(point(m, v).x));
  for (const auto p : r.polys) CHECK(label[p] > 0);
}

TEST_CASE("diagonal_collapse") {
  auto m = make_grid<quadmesh>({.cells = {4, 4, 1}});
  const auto before = record_of(m);
  const std::ptrdiff_t chi = chi_of(m);
  // at a corner of the boundary: both ends of one diagonal are on it
  CHECK(can_diagonal_collapse(m, poly_id{0}, vert_id{1}).reason == refusal::link_condition);
  CHECK(can_diagonal_collapse(m, poly_id{0}, vert_id{0}));  // the corner stays
  CHECK(diagonal_collapse(m, poly_id{0}, vert_id{1}).reason == refusal::link_condition);
  CHECK(record_of(m) == before);
  const auto corners = std::vector<vert_id>(adj_p2v(m, poly_id{5}).begin(), adj_p2v(m, poly_id{5}).end());
  const vec3 middle = (point(m, corners[0]) + point(m, corners[2])) / 2.0;
  const auto r = diagonal_collapse(m, poly_id{5}, corners[0]);
  REQUIRE(r);
  CHECK(contains(m, r.vert));
  CHECK(norm(point(m, r.vert) - middle) < 1e-12);
  CHECK(num_polys(m) == 15);
  CHECK(chi_of(m) == chi);
  CHECK(check_laws(m).empty());
  CHECK(num_elements(adj_v2p(m, r.vert)) == 6);
  // an end on the boundary stays
  auto n = make_grid<quadmesh>({.cells = {4, 4, 1}});
  for (const auto v : adj_p2v(n, poly_id{1}))
    if (is_boundary(n, v)) {
      const vec3 at = point(n, v);
      const auto s = diagonal_collapse(n, poly_id{1}, v);
      REQUIRE(s);
      CHECK(s.vert == v);
      CHECK(point(n, s.vert) == at);
      break;
    }
  CHECK_THROWS_WITH_AS(diagonal_collapse(n, poly_id{0}, vert_id{24}), "diagonal_collapse: vert 24 is not a corner of poly 0", invalid_argument);
  CHECK_THROWS_AS(diagonal_collapse(n, poly_id{99}, vert_id{0}), invalid_mesh);
  polygonmesh mixed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  CHECK_THROWS_AS(diagonal_collapse(mixed, poly_id{0}, vert_id{0}), invalid_mesh);
  // the quads of a cube: both diagonals lead to quads on the same verts, or do not
  auto cube = make_sphere<quadmesh>({.cells = 1});
  const auto c = diagonal_collapse(cube, poly_id{0}, *adj_p2v(cube, poly_id{0}).begin());
  CHECK(check_laws(cube).empty());
  if (c) CHECK(chi_of(cube) == 2);
}

TEST_CASE("collapses and insertions on archetypes") {
  auto q = make_sphere<quadmesh>({.cells = 2});
  auto expected = q;
  auto a = only_editable_mesh(q);
  const auto chord = chord_of(a, a.edge(edge_id{0}));
  CHECK(can_collapse_chord(a, chord));
  const auto back = collapse_chord(a, chord);
  REQUIRE(back);
  REQUIRE(collapse_chord(expected, chord_of(expected, edge_id{0})));
  CHECK(counts_of(q) == counts_of(expected));
  CHECK(can_insert_chord(a, back.edges));
  REQUIRE(insert_chord(a, back.edges));
  CHECK(num_polys(q) == 24);
  const auto some = *polys(a).begin();
  REQUIRE(pillow(a, std::vector{some}));
  CHECK(can_diagonal_collapse(a, some, *adj_p2v(a, some).begin()));
  auto h = make_grid<hexmesh>({.cells = {2, 2, 2}});
  auto b = only_editable_mesh(h);
  const auto s = collapse_sheet(b, sheet_of(b, b.edge(edge_id{0})));
  REQUIRE(s);
  REQUIRE(insert_sheet(b, s.faces));
  CHECK(num_polys(h) == 8);
  REQUIRE(pillow(b, std::vector{*polys(b).begin()}));
  CHECK(check_laws(h).empty());
}
