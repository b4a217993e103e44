// Invariants of collapses and insertions of chords and sheets: those of the other edits, which refuse what they should and nothing else.
#include <concino/edit/invariants.hpp>
#include <concino/edit/keep_labels.hpp>
#include <concino/edit/min_stability.hpp>
#include <concino/edit/protect.hpp>
#include <concino/generate/grid.hpp>
#include <concino/layout/diagonal_collapse.hpp>
#include <concino/layout/insert_sheet.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/same_mesh.hpp>
#include <support/sheet_edits.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("collapses and insertions: invariants are asked as in other edits", M, quadmesh, hexmesh) {
  M m = make_grid<M>({.cells = {4, 4, 4}});
  const auto before = record_of(m);
  const auto all = std::vector<poly_id>(polys(m).begin(), polys(m).end());
  const auto layer = layer_through(m, edge_id{0});
  std::size_t num_new = 0, num_old = 0;
  const auto never = [&](const proposed_edit& e) {
    CHECK((e.dimension == dimension_v<M> && e.corners_per_poly == 0));
    num_new = e.num_new_polys(), num_old = e.num_old_polys();
    for (std::size_t k = 0; k < num_new; ++k) {
      CHECK(e.new_lists(k).size() == (dimension_v<M> == 2 ? 1 : 6));
      CHECK(e.origins[k].count == 1);
      CHECK(e.origins[k].first < num_old);
      for (const unsigned v : e.new_poly(k)) CHECK(v < e.points_after.size());
    }
    return permission{refusal::invariant, "never"};
  };
  CHECK(pillow(m, all, {.keep = {never}}).why == "never");
  CHECK(num_new == (dimension_v<M> == 2 ? 12 + 16 : 56 + 96));  // those at the boundary change
  CHECK(num_old == (dimension_v<M> == 2 ? 12 : 56));
  CHECK(collapse_layer(m, layer, {.keep = {no_inversion, never}}).why == "never");
  CHECK(num_old > num_new);
  CHECK(can_collapse_layer(m, layer, {.keep = {never}}).reason == refusal::invariant);
  CHECK(can_pillow(m, all, {.keep = {min_quality(0.9999, metric::scaled_jacobian)}}).reason == refusal::invariant);
  CHECK(can_pillow(m, all, {.keep = {min_quality(0.1, metric::scaled_jacobian), no_inversion, min_stability(0.01)}}));
  CHECK(can_pillow(m, all, {.keep = {min_stability(0.99)}}).reason == refusal::invariant);
  CHECK(can_pillow(m, all, {.thickness = 0, .keep = {no_inversion}}).reason == refusal::invariant);  // no size
  CHECK(record_of(m) == before);
  // marked edges and faces
  edge_id marked{0};
  const auto is_marked = [&](edge_id e) { return e == marked; };
  CHECK(can_collapse_layer(m, layer, {.keep = {protect_edges(m, is_marked)}}).reason == refusal::invariant);
  marked = edge_id{edge_index_bound(m)};
  CHECK(can_collapse_layer(m, layer, {.keep = {protect_edges(m, is_marked)}}));
  if constexpr (VolumeMesh<M>) {
    const auto is_inside = [&](face_id f) { return !is_boundary(m, f); };
    CHECK(can_collapse_layer(m, layer, {.keep = {protect_faces(m, is_inside)}}).reason == refusal::invariant);
    const auto is_first = [&](face_id f) { return point(m, *adj_f2v(m, f).begin()).x < -1; };
    CHECK(can_collapse_layer(m, layer, {.keep = {protect_faces(m, is_first)}}));
  }
  M other = m;
  CHECK_THROWS_AS(can_collapse_layer(m, layer, {.keep = {protect_edges(other, is_marked)}}), invalid_argument);
}

TEST_CASE_TEMPLATE("collapses and insertions keep the regions of labels", M, quadmesh, hexmesh) {
  // four layers across the axis x; regions are ranges of them
  M m = make_grid<M>({.cells = {4, 3, 3}});
  const auto column = [&](poly_id p) {
    double x = 0;
    for (const auto v : adj_p2v(m, p)) x += point(m, v).x / (dimension_v<M> == 2 ? 4 : 8);
    return static_cast<int>(4 * x);
  };
  const auto layer_at = [&](int wanted, std::size_t axis) {  // the layer of edges along an axis, between two planes
    for (auto s : layers_of(m)) {
      const auto ends = end_verts(m, edges_of(s)[0]);
      const vec3 a = point(m, ends.first), b = point(m, ends.second);
      const double where = (axis == 0 ? 2 : 1.5) * (a[axis] + b[axis]);  // in cells
      if (std::abs(a[axis] - b[axis]) > 1e-6 && static_cast<int>(where) == wanted) return s;
    }
    FAIL("no such layer");
    return layer_through(m, edge_id{0});
  };
  int first[2] = {1, 3};  // the columns where regions 1 and 2 begin
  const auto region = [&](poly_id p) { return (column(p) >= first[0]) + (column(p) >= first[1]); };
  const auto allowed = [&](const auto& s) { return can_collapse_layer(m, s, {.keep = {keep_labels(m, region)}}).reason; };
  CHECK(allowed(layer_at(1, 1)) == refusal::none);  // along which the boundary of a region moves
  for (int k = 1; k < 4; ++k) CHECK(allowed(layer_at(k, 0)) == refusal::invariant);  // the boundary of a region would move
  first[0] = 1, first[1] = 4;
  CHECK(allowed(layer_at(2, 0)) == refusal::none);
  CHECK(allowed(layer_at(3, 0)) == refusal::none);  // the verts at the boundary of the mesh stay
  CHECK(allowed(layer_at(0, 0)) == refusal::invariant);  // a region would vanish
  CHECK(can_collapse_layer(m, layer_at(0, 0)));
  std::vector<facet_t<M>> at_boundary, inside;
  for (const auto f : facets(m)) {
    bool is_at = true, is_in = true;
    for (const auto v : adj_facet2v(m, f)) is_at = is_at && point(m, v).x == 0.25, is_in = is_in && point(m, v).x == 0.75;
    if (is_at) at_boundary.push_back(f);
    if (is_in) inside.push_back(f);
  }
  const std::vector<invariant> keep{keep_labels(m, region)};
  const insert_sheet_options thick{.thickness = 0.3, .keep = keep}, thin{.thickness = 0, .keep = keep};
  if constexpr (SurfaceMesh<M>) {
    CHECK(can_insert_chord(m, inside, thick));
    CHECK(can_insert_chord(m, at_boundary, thick).reason == refusal::invariant);
    CHECK(can_insert_chord(m, at_boundary, thin));
  } else {
    CHECK(can_insert_sheet(m, inside, thick));
    CHECK(can_insert_sheet(m, at_boundary, thick).reason == refusal::invariant);
    CHECK(can_insert_sheet(m, at_boundary, thin));
  }
}

TEST_CASE("invariants of edits of chords and sheets on archetypes, and of a diagonal") {
  auto q = make_grid<quadmesh>({.cells = {4, 4, 1}});
  auto a = only_editable_mesh(q);
  const auto some = *polys(a).begin();
  const std::vector<invariant> keep{no_inversion, min_quality(0.1), protect_edges(a, [](const auto&) { return false; }), keep_labels(a, [](const auto&) { return 0; })};
  CHECK(can_pillow(a, std::vector{some}, {.keep = keep}));
  CHECK(can_collapse_chord(a, chord_of(a, a.edge(edge_id{0})), {.keep = keep}));
  CHECK(can_collapse_chord(a, chord_of(a, a.edge(edge_id{0})), {.keep = {protect_edges(a, [](const auto&) { return true; })}}).reason == refusal::invariant);
  auto h = make_grid<hexmesh>({.cells = {3, 3, 3}});
  auto b = only_editable_mesh(h);
  CHECK(can_collapse_sheet(b, sheet_of(b, b.edge(edge_id{0})), {.keep = {no_inversion, min_quality(0.1), keep_labels(b, [](const auto&) { return 0; })}}));
  CHECK(pillow(b, std::vector{*polys(b).begin()}, {.keep = {protect_faces(b, [](const auto&) { return true; })}}).reason == refusal::invariant);
  CHECK(num_polys(h) == 27);
  // the quads at both ends of a diagonal have different labels: neither end may move
  const auto half = [&](poly_id p) { return p.raw() % 4 < 2; };
  const auto p = poly_id{5};
  std::vector<vert_id> corners(adj_p2v(q, p).begin(), adj_p2v(q, p).end());
  CHECK(can_diagonal_collapse(q, p, corners[0]));
  CHECK(can_diagonal_collapse(q, p, corners[0], {.keep = {keep_labels(q, half)}}).reason == refusal::invariant);
  CHECK(diagonal_collapse(q, p, corners[0], {.keep = {min_quality(0.99, metric::scaled_jacobian)}}).reason == refusal::invariant);
  CHECK(diagonal_collapse(q, p, corners[0], {.keep = {no_inversion}}));
}
