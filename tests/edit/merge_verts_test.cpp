// merge_verts: polys have the remaining vert in place of the removed ones, in all kinds of mesh; what would become degenerate or repeated is refused.
#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/validate.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <set>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;
using cn::testing::whole;

namespace {

using list = std::vector<unsigned>;

/// The pairs of verts of the two halves of `m` that lie at the same place when the second is moved by -1 in the direction of x.
template<class M>
std::vector<std::pair<cn::vert_id, cn::vert_id>> pairs_to_glue(const M& m) {
  std::vector<std::pair<cn::vert_id, cn::vert_id>> pairs;
  for (const auto v : cn::verts(m))
    for (const auto w : cn::verts(m))
      if (cn::point(m, v).x == 1 && cn::point(m, w) == cn::point(m, v) + cn::vec3{1, 0, 0}) pairs.emplace_back(v, w);
  return pairs;
}

/// For each poly of p2v lists: the list with `removed` replaced by `kept`.
list relabelled(list corners, unsigned kept, const list& removed) {
  for (unsigned& i : corners)
    if (std::find(removed.begin(), removed.end(), i) != removed.end()) i = kept;
  return corners;
}

bool has_repeated(list corners) {
  std::sort(corners.begin(), corners.end());
  return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

list without_repeated_neighbours(list corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  return corners;
}

/// What merge_verts should do with a mesh of lists of corners: the remaining polys by their numbers, and whether there are degenerate and repeated ones.
struct expected_merge {
  std::map<unsigned, list> polys;
  bool has_degenerate = false, has_repeated = false;
};

template<class M>
expected_merge expect(const M& m, unsigned kept, const list& removed) {
  expected_merge all;
  std::multiset<std::set<unsigned>> sets, new_sets;
  for (const auto p : cn::polys(m)) {
    const list before = raw(cn::adj_p2v(m, p));
    list corners = relabelled(before, kept, removed);
    if (cn::SurfaceMesh<M> && cn::arity_v<M> == 0) corners = without_repeated_neighbours(corners);
    if (corners.size() < 3 || has_repeated(corners)) {
      all.has_degenerate = true;
      continue;
    }
    all.polys[p.raw()] = corners;
    sets.emplace(corners.begin(), corners.end());
    if (corners != before) new_sets.emplace(corners.begin(), corners.end());
  }
  for (const auto& s : new_sets) all.has_repeated = all.has_repeated || sets.count(s) > 1;
  return all;
}

cn::vert_id vert(unsigned i) { return cn::vert_id{i}; }

}  // namespace

TEST_CASE_TEMPLATE("merge_verts: two grids are glued together", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::two_grids<M>(2);  // the second is moved by 2
  const auto pairs = pairs_to_glue(m);
  const std::size_t verts = cn::num_verts(m), polys = cn::num_polys(m);
  REQUIRE(pairs.size() > 2);
  for (const auto& [v, w] : pairs) {
    CHECK(cn::can_merge_verts(m, v, {w}));
    const auto made = cn::merge_verts(m, v, {w});
    REQUIRE(made);
    CHECK(made.vert == v);
    CHECK_FALSE(cn::contains(m, w));
    CHECK(cn::point(m, v).x == 1);
  }
  CHECK(cn::num_verts(m) == verts - pairs.size());
  CHECK(cn::num_polys(m) == polys);
  const auto facts = cn::validate(m).facts;
  CHECK(facts.components == 1);
  CHECK(facts.euler_characteristic == 1);
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE_TEMPLATE("merge_verts: random verts of grids and soups", M, cn::trimesh, cn::quadmesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh) {
  std::mt19937 random(8);
  std::size_t done = 0, degenerate = 0, repeated = 0;
  for (unsigned round = 0; round < 12; ++round) {
    M m = round % 3 == 0 ? cn::testing::grid<M>(3) : cn::testing::random_soup<M>(random, 7 + 3 * (round % 3), 9).mesh();
    for (unsigned step = 0; step < 8; ++step) {
      const list all = raw(cn::verts(m));
      if (all.size() < 4) break;
      const list numbers = cn::testing::some_of(random, static_cast<unsigned>(all.size()), 2 + static_cast<unsigned>(random() % 2));
      std::vector<cn::vert_id> removed;
      for (std::size_t i = 1; i < numbers.size(); ++i) removed.push_back(vert(all[numbers[i]]));
      const unsigned kept = all[numbers[0]];
      const auto expected = expect(m, kept, raw(removed));
      degenerate += expected.has_degenerate, repeated += expected.has_repeated;
      const auto before = whole(m);
      for (const auto what : {cn::degenerate_polys::refuse, cn::degenerate_polys::remove}) {
        const bool is_refused = expected.has_degenerate && what == cn::degenerate_polys::refuse;
        const cn::permission may = cn::can_merge_verts(m, vert(kept), removed, {.degenerate = what});
        CHECK(may.reason == (is_refused ? cn::refusal::degenerate : expected.has_repeated ? cn::refusal::same_verts : cn::refusal::none));
        const auto made = cn::merge_verts(m, vert(kept), removed, {.degenerate = what});
        CHECK(made.reason == may.reason);
        if (!may) CHECK(whole(m) == before);
        if (!may) continue;
        ++done;
        CHECK(cn::num_polys(m) == expected.polys.size());
        for (const auto& [p, corners] : expected.polys) CHECK(raw(cn::adj_p2v(m, cn::poly_id{p})) == corners);
        keeps_all_laws(m);
        equals_rebuilt(m);
        break;
      }
    }
  }
  CHECK(done > 30);
  CHECK(degenerate > 5);
  CHECK(repeated > 0);
}

TEST_CASE("merge_verts: random polyhedra keep the laws") {
  std::mt19937 random(9);
  std::size_t done = 0, refused = 0;
  for (unsigned round = 0; round < 8; ++round) {
    auto m = round % 2 ? cn::testing::grid<cn::polyhedralmesh>(2) : cn::testing::random_soup<cn::polyhedralmesh>(random, 14, 7).mesh();
    cn::remove_unreferenced(m);
    for (unsigned step = 0; step < 8; ++step) {
      const list all = raw(cn::verts(m));
      const list numbers = cn::testing::some_of(random, static_cast<unsigned>(all.size()), 2);
      const auto before = whole(m);
      const auto made = cn::merge_verts(m, vert(all[numbers[0]]), {vert(all[numbers[1]])}, {.degenerate = step % 2 ? cn::degenerate_polys::remove : cn::degenerate_polys::refuse});
      ++(made ? done : refused);
      if (!made) CHECK(whole(m) == before);
      keeps_all_laws(m);
      equals_rebuilt(m);
    }
  }
  CHECK(done > 10);
  CHECK(refused > 5);
}

TEST_CASE("merge_verts: polygons and polyhedra lose corners where neighbours become one") {
  cn::polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {4, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  REQUIRE(cn::merge_verts(m, vert(1), {vert(2)}, {.degenerate = cn::degenerate_polys::remove, .at_mean = true}));
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{0})) == list{0, 1, 3});
  CHECK(cn::num_polys(m) == 1);
  CHECK(cn::num_edges(m) == 3);
  CHECK(cn::point(m, vert(1)) == cn::vec3{2, 0.5, 0});
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m);

  auto cube = cn::testing::grid<cn::polyhedralmesh>(1);  // an edge of a cell becomes a vert: two faces lose a corner
  for (const auto p : cn::polys(cube)) {
    auto n = cube;
    const auto e = *cn::adj_p2e(n, p).begin();
    const auto ends = cn::end_verts(n, e);
    const std::ptrdiff_t chi = cn::validate(n).facts.euler_characteristic;
    const auto made = cn::merge_verts(n, ends.first, {ends.second}, {.degenerate = cn::degenerate_polys::remove});
    CHECK(bool(made) == bool(cn::can_merge_verts(cube, ends.first, {ends.second}, {.degenerate = cn::degenerate_polys::remove})));
    if (!made) continue;
    CHECK(cn::validate(n).facts.euler_characteristic == chi);
    keeps_all_laws(n);
  }

  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const std::vector<list> faces{{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  const auto prism = cn::polyhedralmesh(x, faces, std::vector<std::vector<std::pair<unsigned, bool>>>{{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}}});
  auto wedge = prism;  // a vertical edge becomes a vert: a pyramid
  REQUIRE(cn::merge_verts(wedge, vert(0), {vert(3)}));
  CHECK(cn::num_faces(wedge) == 5);
  CHECK(cn::num_edges(wedge) == 8);
  CHECK(cn::total_measure(wedge) == doctest::Approx(1.0 / 3));
  keeps_all_laws(wedge);
  auto pinched = prism;  // verts that are no neighbours
  CHECK(cn::merge_verts(pinched, vert(0), {vert(4)}).reason == cn::refusal::degenerate);
  CHECK(whole(pinched) == whole(prism));
  CHECK(cn::merge_verts(pinched, vert(0), {vert(1), vert(2), vert(3)}, {.degenerate = cn::degenerate_polys::remove}));
  CHECK(cn::num_polys(pinched) + cn::num_faces(pinched) + cn::num_edges(pinched) == 0);
  CHECK(cn::num_verts(pinched) == 3);
}

TEST_CASE("merge_verts: values follow by their rules") {
  // two triangles that have no vert in common, which are glued at an edge
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const auto u = cn::vert_property<double>(m, "u"), mass = cn::vert_property<double>(m, "mass");
  const auto length = cn::edge_property<double>(m, "length"), mark = cn::edge_property<double>(m, "mark");
  cn::set_property_rule(m, cn::element_kind::vert, "mass", cn::property_rule::sum);
  cn::set_property_rule(m, cn::element_kind::edge, "length", cn::property_rule::sum);
  cn::set_property_rule(m, cn::element_kind::edge, "mark", cn::property_rule::copy);
  const auto area = cn::poly_property<double>(m, "area"), uv = cn::poly_property<double>(m, "other");
  cn::set_property_rule(m, cn::element_kind::poly, "area", cn::property_rule::sum);
  for (const auto v : cn::verts(m)) u[v] = v.raw(), mass[v] = 1;
  for (const auto e : cn::edges(m)) length[e] = 1, mark[e] = e.raw();
  for (const auto p : cn::polys(m)) area[p] = 0.5, uv[p] = 10 + p.raw();
  const auto corner = cn::corner_property<double>(m, "corner");
  for (const auto p : cn::polys(m))
    for (std::uint32_t k = 0; k < 3; ++k) corner[{p, k}] = 10 * p.raw() + k;
  const auto edge = [&](unsigned a, unsigned b) { return cn::testing::edge_between_verts(m, a, b); };
  const double mark_before = mark[edge(1, 2)];
  const auto before = whole(m);
  {
    cn::transaction t(m);
    REQUIRE(cn::merge_verts(m, vert(1), {vert(3), vert(6)}, {.at_mean = true}));
    CHECK(u[vert(1)] == doctest::Approx(10.0 / 3));
    CHECK(cn::point(m, vert(1)).x == doctest::Approx(7.0 / 3));
  }
  CHECK(whole(m) == before);
  CHECK(u[vert(1)] == 1);
  REQUIRE(cn::merge_verts(m, vert(1), {vert(3)}));
  CHECK(u[vert(1)] == 1);
  CHECK(mass[vert(1)] == 2);
  REQUIRE(cn::merge_verts(m, vert(2), {vert(5)}, {.at_mean = true}));
  CHECK(u[vert(2)] == 3.5);
  CHECK(cn::num_edges(m) == 5);
  CHECK(length[edge(1, 2)] == 2);
  CHECK(mark[edge(1, 2)] == mark_before);
  CHECK(mark[edge(1, 4)] == 3);
  for (const auto p : cn::polys(m)) {
    CHECK(uv[p] == 10 + p.raw());
    for (std::uint32_t k = 0; k < 3; ++k) CHECK(corner[{p, k}] == 10 * p.raw() + k);
  }
  REQUIRE(cn::merge_verts(m, vert(0), {vert(1)}, {.degenerate = cn::degenerate_polys::remove}));
  CHECK(cn::num_polys(m) == 1);
  CHECK(area[cn::poly_id{1}] == 1);
  CHECK(mass[vert(0)] == 3);
}

TEST_CASE_TEMPLATE("merge_verts: refusals, errors and transactions", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::two_grids<M>(1);
  cn::vert_property<double>(m, "a");
  cn::corner_property<int>(m, "g");
  cn::edge_property<int>(m, "h");
  const auto pairs = pairs_to_glue(m);
  const auto before = whole(m);
  const auto [v, w] = pairs[0];
  CHECK(cn::can_merge_verts(m, v, {v}).reason == cn::refusal::wrong_set);
  CHECK(cn::merge_verts(m, v, {w, w}).reason == cn::refusal::wrong_set);
  CHECK(cn::merge_verts(m, v, {}).vert == v);
  const list corners = raw(cn::adj_p2v(m, cn::poly_id{0}));
  if (cn::arity_v<M> > 0) CHECK(cn::can_merge_verts(m, vert(corners[0]), {vert(corners[1])}).reason == cn::refusal::degenerate);
  CHECK_THROWS_WITH_AS(cn::merge_verts(m, v, {w, vert(1000)}), doctest::Contains("merge_verts: vert 1000"), cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::can_merge_verts(m, vert(1000), {w}), doctest::Contains("can_merge_verts: vert 1000"), cn::invalid_mesh);
  CHECK(whole(m) == before);
  const auto glue = [&] {
    for (const auto& [x, y] : pairs) REQUIRE(cn::merge_verts(m, x, {y}, {.at_mean = true}));
  };
  {
    cn::transaction t(m);
    glue();
    keeps_all_laws(m);
    CHECK(whole(m) != before);
  }
  CHECK(whole(m) == before);
  cn::transaction t(m);
  glue();
  auto edits = t.commit();
  const auto after = whole(m);
  edits.undo();
  CHECK(whole(m) == before);
  edits.redo();
  CHECK(whole(m) == after);
}

TEST_CASE("merge_verts: a face without polys is named") {
  auto m = cn::testing::grid<cn::polyhedralmesh>(1);
  const auto v = cn::add_vert(m, {9, 9, 9}), w = cn::add_vert(m, {9, 9, 8});
  cn::add_face(m, {v, w, vert(0)});
  CHECK(cn::merge_verts(m, w, {v}).reason == cn::refusal::loose_face);
  CHECK(cn::remove_unreferenced(m).faces == 1);
}

TEST_CASE_TEMPLATE("merge_verts: keeps invariants, or changes nothing", M, cn::trimesh, cn::tetmesh) {
  M m = cn::testing::grid<M>(3);
  const auto before = whole(m);
  const auto refused_by = [&](auto kept, auto removed, const cn::merge_verts_options& options) {
    const cn::permission p = cn::merge_verts(m, kept, {removed}, options);
    CHECK(cn::can_merge_verts(m, kept, {removed}, options).reason == p.reason);
    CHECK(whole(m) == before);
    return p.reason;
  };
  unsigned folded = 0, done = 0;
  const cn::vert_id a = vert(5);
  for (const auto b : cn::verts(m)) {
    for (const bool at_mean : {false, true}) {
      M merged = m;
      if (!cn::can_merge_verts(m, a, {b}, {.degenerate = cn::degenerate_polys::remove, .at_mean = at_mean})) continue;
      const cn::merge_verts_options options{.degenerate = cn::degenerate_polys::remove, .at_mean = at_mean, .keep = {cn::no_inversion}};
      const auto r = cn::merge_verts(merged, a, {b}, options);
      (r ? done : folded) += 1;
      if (!r) CHECK(refused_by(a, b, options) == cn::refusal::invariant);
      else CHECK(cn::validate(merged).count(cn::defect_kind::zero_size) == 0);
    }
  }
  CHECK(folded > 0);
  CHECK(done > 0);
  const auto never = [](const auto&) { return true; };
  CHECK(refused_by(vert(0), vert(1), {.degenerate = cn::degenerate_polys::remove, .keep = {cn::protect_edges(m, never)}}) == cn::refusal::invariant);
}

TEST_CASE("merge_verts: invariants of each removed vert, and of polys that are no simplices") {
  cn::trimesh m = cn::testing::two_grids<cn::trimesh>(1);
  unsigned asked = 0;
  std::vector<std::size_t> removed;
  const auto count = [&](const cn::proposed_edit& e) {
    ++asked, removed.push_back(e.verts[e.removed_vert]);
    CHECK(e.verts[e.kept_vert] == 0);
    return cn::permission{};
  };
  CHECK(cn::merge_verts(m, vert(0), {vert(1), vert(2)}, {.degenerate = cn::degenerate_polys::remove, .keep = {count}}));
  CHECK(asked == 2);
  CHECK(removed == std::vector<std::size_t>{1, 2});
  cn::quadmesh quads = cn::testing::two_grids<cn::quadmesh>(1);
  const auto [v, w] = pairs_to_glue(quads)[0];
  CHECK(cn::can_merge_verts(quads, v, {w}));
  CHECK(cn::merge_verts(quads, v, {w}, {.keep = {cn::no_inversion}}).reason == cn::refusal::not_simplices);
}
