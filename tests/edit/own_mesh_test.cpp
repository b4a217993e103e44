// A mesh of a user's own that becomes editable by one function: the example of docs/adapt-advanced.md.
#include <concino/validate/check_laws.hpp>

#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <algorithm>

//! [own mesh]
#include <concino/concepts/editable.hpp>
#include <concino/edit.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <vector>

struct terrain {
  std::vector<concino::vec3> points;
  concino::surface_tables<3> tables;
};
template<> struct concino::mesh_traits<terrain> : concino::indexed_surface<terrain> {
  static constexpr int arity = 3;
  static const auto& tables(const terrain& m) { return m.tables; }
  static const vec3& point(const terrain& m, vert_id v) { return m.points[v.raw()]; }
  static void set_point(terrain& m, vert_id v, const auto& x) { m.points[v.raw()] = {x[0], x[1], x[2]}; }
  static void rewire(terrain& m, const cavity_of<vert_id, poly_id>& c, const cavity_result_of<vert_id, poly_id>& made) {
    m.points.reserve(m.points.size() + c.points.size());  // what can fail comes first
    m.tables.rewire(c, made);                             // checks the cavity, and changes everything or nothing
    m.points.insert(m.points.end(), c.points.begin(), c.points.end());
  }
};
static_assert(concino::EditableSurfaceMesh<terrain>);
//! [own mesh]

namespace cn = concino;

TEST_CASE("own mesh: operators edit it as they edit a mesh of this library") {
  auto native = cn::testing::grid<cn::trimesh>(3);
  terrain m{native.points(), native.tables()};
  const auto in_both = [&](const auto& edit) {
    CHECK(bool(edit(m)) == bool(edit(native)));
    CHECK(m.points == native.points());
    CHECK(cn::check_laws(m).empty());
    CHECK(cn::num_polys(m) == cn::num_polys(native));
    for (const auto p : cn::polys(native)) CHECK(std::ranges::equal(cn::adj_p2v(m, p), cn::adj_p2v(native, p)));
  };
  for (unsigned e = 0; e < 12; ++e) {
    in_both([&](auto& x) -> cn::permission { return cn::edge_split(x, cn::edge_id{e}); });
    in_both([&](auto& x) -> cn::permission { return cn::edge_flip(x, cn::edge_id{e}, {.keep = {cn::no_inversion}}); });
    in_both([&](auto& x) -> cn::permission { return cn::poly_split(x, cn::poly_id{e}); });
  }
  in_both([](auto& x) {
    cn::flip_winding(x);
    return cn::permission{};
  });
  terrain before = m;
  CHECK_THROWS_AS(cn::edge_split(m, cn::edge_id{9999}), cn::invalid_mesh);
  CHECK(m.points == before.points);
}

namespace {
/// A mesh of this library that replaces `rewire`.
struct counting : cn::trimesh {
  int num_edits = 0;
};
}  // namespace
template<>
struct concino::mesh_traits<counting> : concino::mesh_traits<trimesh> {
  static void rewire(counting& m, const cavity_of<vert_id, poly_id>& c, const cavity_result_of<vert_id, poly_id>& made) {
    ++m.num_edits;
    mesh_traits<trimesh>::rewire(m, c, made);
  }
};

TEST_CASE("own mesh: traits that replace rewire are asked for every edit") {
  counting m{cn::testing::grid<cn::trimesh>(3)};
  CHECK(cn::edge_split(m, cn::edge_id{0}));
  CHECK(m.num_edits == 1);
  cn::edge_id e{0};
  while (!cn::can_edge_flip(m, e)) e = cn::edge_id(e.raw() + 1);
  CHECK(cn::edge_flip(m, e));
  CHECK(m.num_edits == 2);
  e = cn::edge_id{0};
  while (!cn::can_edge_collapse(m, e)) e = cn::edge_id(e.raw() + 1);
  CHECK(cn::edge_collapse(m, e));
  CHECK(m.num_edits == 3);
}
