#include <concino/repair/repair.hpp>

#include <concino/convert/convert.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/flip_winding.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/property.hpp>
#include <concino/validate.hpp>

#include <support/kinds.hpp>
#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The arrays of m, each cell with faces and verts of its own.
polyhedra_arrays separate_cells(const polyhedralmesh& m, double gap) {
  polyhedra_arrays a;
  a.face_offsets = a.poly_offsets = {0};
  for (const auto p : polys(m)) {
    std::vector<std::uint32_t> number(vert_index_bound(m));
    for (const auto v : adj_p2v(m, p)) {
      number[v.raw()] = static_cast<std::uint32_t>(a.points.size());
      a.points.push_back(point(m, v) + vec3{gap * (p.raw() % 3), gap * (p.raw() % 2), 0});
    }
    for (const auto f : adj_p2f(m, p)) {
      a.poly_faces.push_back(face_id{a.face_offsets.size() - 1});
      a.outward.push_back(face_is_outward(m, p, f));
      for (const auto v : adj_f2v(m, f)) a.face_verts.push_back(vert_id{number[v.raw()]});
      a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  return a;
}

}  // namespace

TEST_CASE_TEMPLATE("repair: inverted cells are turned, also if all are", M, CONCINO_ALL_VOLUME_KINDS) {
  const M whole = grid<M>(3);
  M m = whole;
  for (const unsigned p : {0u, 5u, 11u}) flip_winding(m, poly_id{p});
  REQUIRE(!validate(m).is_clean());
  const auto fix = repair(m);
  CHECK(fix.count(repair_kind::turned_polys) == 3);
  CHECK(fix.records.at(0).elements == std::vector<std::uint32_t>{0, 5, 11});
  CHECK(validate(m).is_clean());
  CHECK(total_measure(m) == doctest::Approx(total_measure(whole)));
  flip_winding(m);
  CHECK(repair(m, {.turn_inverted = false}).done.empty());
  CHECK(repair(m).count(repair_kind::turned_polys) == num_polys(m));
  CHECK(validate(m).is_clean());
}

TEST_CASE("repair: a cell that is inverted because a vert has moved is left, and the result says why") {
  tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 2, 5, 3}});
  REQUIRE(validate(m).is_clean());
  set_point(m, vert_id{5}, vec3{0.25, 0.25, 0.25});
  REQUIRE(validate(m).count(defect_kind::inverted_cell) == 1);
  const auto before = record_of(m);
  const auto fix = repair(m);
  CHECK(fix.done.empty());
  CHECK(fix.count(repair_kind::inverted_cell) == 1);
  CHECK(fix.left.size() == 1);
  CHECK(record_of(m) == before);
}

TEST_CASE_TEMPLATE("repair: duplicate cells and degenerate tets are removed", M, CONCINO_ALL_VOLUME_KINDS) {
  const M whole = grid<M>(2);
  auto a = grid_arrays<M>(2);
  if constexpr (requires { a.outward; }) {
    for (std::size_t i = a.poly_offsets[1]; i < a.poly_offsets[2]; ++i) a.poly_faces.push_back(face_id{a.poly_faces[i].raw()}), a.outward.push_back(static_cast<std::uint8_t>(a.outward[i]));
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  } else {
    for (std::size_t i = 0; i < a.arity; ++i) a.verts.push_back(vert_id{a.verts[a.arity + i].raw()});
  }
  M m(a);
  REQUIRE(validate(m).count(defect_kind::duplicated_element) == 1);
  const auto fix = repair(m);
  CHECK(fix.count(repair_kind::removed_duplicates) == 1);
  CHECK(record_of(m) == record_of(whole));
  if constexpr (arity_v<M> == 4) {
    a = grid_arrays<M>(2);
    a.points.push_back(a.points[a.verts[0].raw()]);
    for (const std::size_t i : {0u, 1u, 2u}) a.verts.push_back(vert_id{a.verts[i].raw()});
    a.verts.push_back(vert_id{a.points.size() - 1});
    m = M(a);
    CHECK(repair(m, {.merge_within = 0.0}).count(repair_kind::removed_degenerate) == 1);
    CHECK(record_of(m) == record_of(whole));
  }
}

TEST_CASE("repair: cells with faces of their own are joined within the tolerance") {
  for (const polyhedralmesh& whole : {grid<polyhedralmesh>(2), convert<polyhedralmesh>(grid<hexmesh>(3))}) {
    polyhedralmesh m(separate_cells(whole, 1e-9));
    const auto label = poly_property<int>(m, "label");
    for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw());
    REQUIRE(validate(m).facts.components == num_polys(whole));
    const auto fix = repair(m, {.merge_within = 1e-7});
    CHECK(validate(m).is_clean());
    CHECK(num_verts(m) == num_verts(whole));
    CHECK(num_faces(m) == num_faces(whole));
    CHECK(num_polys(m) == num_polys(whole));
    CHECK(validate(m).facts.components == 1);
    CHECK(fix.count(repair_kind::united_faces) > 0);
    const auto kept = find_poly_property<int>(m, "label");
    for (const auto p : polys(m)) CHECK(kept[p] == static_cast<int>(p.raw()));
  }
}

TEST_CASE("repair: doubled faces are united, turned faces of a cell turned, unused ones removed") {
  const polyhedralmesh whole = grid<polyhedralmesh>(2);
  auto a = grid_arrays<polyhedralmesh>(2);
  // the last use of the first face that has two gets a face of its own, the other way round
  const auto shared = [&] {
    for (const auto f : faces(whole))
      if (num_elements(adj_f2p(whole, f)) == 2) return f;
    return face_id{};
  }();
  const auto copy = face_id{a.num_faces()};
  for (std::size_t n = a.face_offsets[shared.raw() + 1], i = n; i > a.face_offsets[shared.raw()]; --i) a.face_verts.push_back(vert_id{a.face_verts[i - 1].raw()});
  a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  for (std::size_t i = a.poly_faces.size(); i-- > 0;)
    if (a.poly_faces[i] == shared) {
      a.poly_faces[i] = copy;
      a.outward[i] ^= 1;
      break;
    }
  a.outward[2] ^= 1;
  // a face that no cell has
  for (const unsigned v : {0u, 1u, 2u}) a.face_verts.push_back(vert_id{v});
  a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  polyhedralmesh m(a);
  REQUIRE(validate(m).count(defect_kind::duplicated_element) >= 1);
  REQUIRE(validate(m).count(defect_kind::inconsistent_winding) >= 1);
  const auto fix = repair(m);
  CHECK(validate(m).is_clean());
  CHECK(fix.count(repair_kind::united_faces) >= 1);
  CHECK(fix.count(repair_kind::turned_polys) == 1);
  CHECK(num_faces(m) == num_faces(whole));
  CHECK(total_measure(m) == doctest::Approx(total_measure(whole)));
}

TEST_CASE("repair: an open cell is left, and the result names the loop that is missing") {
  polyhedralmesh m = convert<polyhedralmesh>(grid<hexmesh>(1));
  // the same cube without its first face
  polyhedra_arrays a;
  a.face_offsets = a.poly_offsets = {0};
  for (const auto v : verts(m)) a.points.push_back(point(m, v));
  std::vector<std::uint32_t> missing;
  for (const auto f : adj_p2f(m, poly_id{0})) {
    if (missing.empty()) {
      for (const auto v : adj_f2v(m, f)) missing.push_back(v.raw());
      continue;
    }
    a.poly_faces.push_back(face_id{a.face_offsets.size() - 1});
    a.outward.push_back(face_is_outward(m, poly_id{0}, f));
    for (const auto v : adj_f2v(m, f)) a.face_verts.push_back(v);
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  }
  a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  polyhedralmesh open(a);
  const auto fix = repair(open);
  CHECK(fix.done.empty());
  REQUIRE(fix.count(repair_kind::open_cell) == 1);
  const std::string& what = fix.records[0].what;
  CHECK(fix.left == std::vector<std::string>{what});
  REQUIRE(what.starts_with("poly 0 is open: no face has the loop of verts"));
  for (const auto v : missing) CHECK((what + " ").find(" " + std::to_string(v) + " ") != std::string::npos);
  CHECK(what.size() == std::string("poly 0 is open: no face has the loop of verts").size() + 8);
}
