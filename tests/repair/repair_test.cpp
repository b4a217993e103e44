#include <concino/repair/repair.hpp>

#include <concino/generate/torus.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/property.hpp>
#include <concino/validate.hpp>

#include <support/kinds.hpp>
#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

/// Each poly with verts of its own.
template<class M>
M soup_of(const M& m) {
  surface_arrays a;
  a.arity = static_cast<std::uint32_t>(arity_v<M>);
  if (a.arity == 0) a.offsets.push_back(0);
  for (const auto p : polys(m)) {
    for (const auto v : adj_p2v(m, p)) {
      a.verts.push_back(vert_id{a.points.size()});
      a.points.push_back(to_vec3(point(m, v)));
    }
    if (a.arity == 0) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return M(std::move(a));
}

}  // namespace

TEST_CASE_TEMPLATE("repair: bad options are errors, and the mesh stays as it is", M, CONCINO_KINDS) {
  M m = grid<M>(2);
  const auto before = record_of(m);
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(repair(m, {.merge_within = bad}), invalid_argument);
    CHECK_THROWS_AS(repaired(m, {.merge_within = bad}), invalid_argument);
  }
  CHECK_THROWS_AS(repair(m, {.merge_within = 0.0, .orient = true, .progress = [](double, const char*) { return false; }}), cancelled);
  CHECK(record_of(m) == before);
}

TEST_CASE_TEMPLATE("repair: an undamaged mesh comes back equal", M, CONCINO_KINDS) {
  M m = grid<M>(3);
  const auto label = poly_property<int>(m, "label");
  for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw());
  const auto before = record_of(m);
  repair_options all{.merge_within = 1e-9, .degenerate = degenerate_elements::collapse, .split_non_manifold = true, .orient = true};
  all.intersecting = intersecting_triangles::remove;
  for (const repair_options& options : {repair_options{}, all}) {
    const repair_result fix = repair(m, options);
    CHECK(fix.done.empty());
    CHECK(fix.left.empty());
    CHECK(fix.records.empty());
    CHECK(record_of(m) == before);
    CHECK(record_of(repaired(m, options).mesh) == before);
    for (const auto p : polys(m)) CHECK(fix.from.polys.only(index_of(m, p)) == index_of(m, p));
  }
}

TEST_CASE_TEMPLATE("repair: a soup of polys becomes a closed surface", M, CONCINO_SURFACE_KINDS) {
  const auto whole = make_torus<M>({.cells = {12, 8}});
  M m = soup_of(whole);
  REQUIRE(num_verts(m) > num_verts(whole));
  const repair_result fix = repair(m, {.merge_within = 0.0, .orient = true});
  CHECK(num_verts(m) == num_verts(whole));
  CHECK(num_edges(m) == num_edges(whole));
  CHECK(validate(m, {.kinds = defect_kinds().without({defect_kind::non_planar})}).is_clean());
  CHECK(validate(m).facts.closed);
}

TEST_CASE("repair: what is switched off is left as it is") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}}, {{0, 1, 2}, {2, 1, 0}});
  auto before = record_of(m);
  CHECK(repair(m, {.remove_duplicates = false, .remove_unreferenced = false}).done.empty());
  CHECK(record_of(m) == before);
  CHECK(repair(m).done == std::vector<std::string>{"1 poly with the same verts as an earlier one was removed: poly 1", "1 vert without polys was removed: vert 3"});
  CHECK(num_verts(m) == 3);
  CHECK(num_polys(m) == 1);
  // two tets with a face each on the same three verts, and a face of no cell
  polyhedralmesh cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 2}, {0, 4, 1}, {0, 2, 4}, {1, 4, 2}, {0, 3, 4}},
                       {{{0, true}, {1, true}, {2, true}, {3, true}}, {{4, true}, {5, true}, {6, true}, {7, true}}});
  REQUIRE(validate(cells).count(defect_kind::duplicated_element) == 1);
  before = record_of(cells);
  CHECK(repair(cells, {.remove_unreferenced = false, .unite_faces = false}).done.empty());
  CHECK(record_of(cells) == before);
  const auto fix = repair(cells);
  CHECK(fix.count(repair_kind::united_faces) == 1);
  CHECK(fix.count(repair_kind::removed_faces) == 1);
  CHECK(validate(cells).is_clean());
  CHECK(num_faces(cells) == 7);
}
