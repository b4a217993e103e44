// Values of named properties in collapses and insertions of chords and sheets: elements that stay keep them, others have those of what they were made of.
#include <concino/generate/grid.hpp>
#include <concino/layout/diagonal_collapse.hpp>
#include <concino/layout/insert_sheet.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <support/layouts.hpp>
#include <support/sheet_edits.hpp>
#include <support/surviving_values.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("edges and faces whose verts stay keep their values and descriptors", M, quadmesh, hexmesh) {
  for (const auto& one : meshes_with_layouts<M>(false)) {
    if (num_polys(one.mesh) > 1000) continue;
    INFO(one.name);
    std::size_t count = 0;
    M m = one.mesh;
    for (unsigned k = 0; k < 6; ++k) {
      const auto check = [&](const auto& edit) {
        const surviving_values<M> before(m);
        const bool is_done = bool(edit());
        count += before.check(m) * is_done;
      };
      const auto e = *edges(m).begin();
      std::vector<facet_t<M>> back;
      check([&] {
        const auto r = collapse_layer(m, layer_through(m, e));
        back = facets_of(r);
        return r;
      });
      if (!back.empty()) check([&] { return insert_layer(m, back); });
      const std::vector<poly_t<M>> some{*polys(m).begin()};
      check([&] { return pillow(m, some, {.at_boundary = k % 2 == 0}); });
      if constexpr (SurfaceMesh<M>) {
        auto p = polys(m).begin();
        for (unsigned i = 0; i < k; ++i) ++p;
        const auto x = *p;
        check([&] { return diagonal_collapse(m, x, *adj_p2v(m, x).begin()); });
      }
    }
    CHECK(count > 0);
  }
}

namespace {

/// A mesh with numbers at edges and at facets that say where they lie: 1 + x of the middle, in cells; at other edges and facets 0.
template<class M>
struct numbered_grid {
  M m = make_grid<M>({.cells = {4, 3, 3}});
  property_map<facet_t<M>, double> value;

  static constexpr double layers = 4;
  bool is_across(const facet_t<M>& f) const {  // whether it lies in a plane of constant x
    std::vector<double> x;
    for (const auto v : adj_facet2v(m, f)) x.push_back(point(m, v).x);
    return *std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end()) < 1e-6;
  }
  double x_of(const facet_t<M>& f) const { return layers * point(m, *adj_facet2v(m, f).begin()).x; }
  numbered_grid()
      : value([&] {
          if constexpr (SurfaceMesh<M>) return edge_property<double>(m, "value");
          else return face_property<double>(m, "value");
        }()) {
    for (const auto f : facets(m))
      if (is_across(f)) value[f] = 1 + x_of(f);
  }
  auto layer(int at) const {
    for (auto s : layers_of(m)) {
      const auto ends = end_verts(m, edges_of(s)[0]);
      const double a = layers * point(m, ends.first).x, b = layers * point(m, ends.second).x;
      if (std::abs(std::min(a, b) - at) < 1e-6 && std::abs(a - b) > 0.5) return s;
    }
    FAIL("no such layer");
    return layer_through(m, edge_id{0});
  }
};

}  // namespace

TEST_CASE_TEMPLATE("a collapse gives facets the values of those that become one, an insertion those of its own to both sides", M, quadmesh, hexmesh) {
  numbered_grid<M> g;
  const auto r = collapse_layer(g.m, g.layer(1));
  REQUIRE(r);
  CHECK(facets_of(r).size() == (dimension_v<M> == 2 ? 3 : 9));
  for (const auto f : facets_of(r)) CHECK(g.value[f] == doctest::Approx(2.5));  // those at 1 and 2 become one
  for (const auto f : facets(g.m)) CHECK((g.is_across(f) ? g.value[f] == doctest::Approx(1 + g.x_of(f)) : g.value[f] == 0));
  const auto all = facets_of(r);
  const auto back = insert_layer(g.m, all);
  REQUIRE(back);
  std::size_t sides = 0;
  for (const auto p : back.polys)
    for (const auto f : adj_p2facet(g.m, p)) {
      CHECK(g.value[f] == doctest::Approx(g.is_across(f) ? 2.5 : 0.0));
      sides += g.is_across(f);
    }
  CHECK(sides == 2 * all.size());
  // at the boundary the facet there stays
  numbered_grid<M> h;
  const auto at_end = collapse_layer(h.m, h.layer(0));
  REQUIRE(at_end);
  for (const auto f : facets_of(at_end)) CHECK(h.value[f] == 1);
}

TEST_CASE_TEMPLATE("an insertion gives no value to edges and faces between its two sides", M, quadmesh, hexmesh) {
  M m = make_grid<M>({.cells = {3, 3, 3}});
  const auto mark = edge_property<int>(m, "mark");
  for (const auto e : edges(m)) mark[e] = 1;
  const auto middle = poly_id{dimension_v<M> == 2 ? 4u : 13u};
  if constexpr (VolumeMesh<M>) {
    const auto face_mark = face_property<int>(m, "mark");
    for (const auto f : faces(m)) face_mark[f] = 1;
  }
  const std::size_t num_before = num_edges(m), facets_before = num_facets(m);
  REQUIRE(pillow(m, std::vector{middle}));
  std::size_t marked = 0, marked_facets = 0;
  for (const auto e : edges(m)) marked += mark[e] == 1;
  // the edges around the poly in the middle are there twice; those between are new
  CHECK(marked == num_before + (dimension_v<M> == 2 ? 4 : 12));
  CHECK(num_edges(m) - marked == (dimension_v<M> == 2 ? 4 : 8));
  if constexpr (VolumeMesh<M>) {
    const auto face_mark = face_property<int>(m, "mark");
    for (const auto f : faces(m)) marked_facets += face_mark[f] == 1;
    CHECK(marked_facets == facets_before + 6);
    CHECK(num_faces(m) - marked_facets == 12);
  }
}

TEST_CASE_TEMPLATE("corners of polys beside an insertion without thickness", M, quadmesh, hexmesh) {
  M m = make_grid<M>({.cells = {4, 3, 3}});
  const auto x = corner_property<double>(m, "x");
  for (const auto p : polys(m)) {
    std::uint32_t k = 0;
    for (const auto v : adj_p2v(m, p)) x[{p, k++}] = point(m, v).x;
  }
  std::vector<facet_t<M>> middle;
  for (const auto f : facets(m)) {
    bool is_middle = true;
    for (const auto v : adj_facet2v(m, f)) is_middle = is_middle && point(m, v).x == 0.5;
    if (is_middle) middle.push_back(f);
  }
  for (const double thickness : {0.0, 0.25}) {
    M n = m;
    REQUIRE(insert_layer(n, middle, {.thickness = thickness}));
    const auto y = find_corner_property<double>(n, "x");
    for (const auto p : polys(n)) {
      std::uint32_t k = 0;
      for (const auto v : adj_p2v(n, p)) {
        const double at = point(n, v).x;
        CHECK(y[{p, k++}] == doctest::Approx(std::abs(at - 0.5) < 0.1 ? 0.5 : at));  // those of the verts that were split
      }
    }
  }
}
