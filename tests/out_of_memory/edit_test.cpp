// An edit that throws std::bad_alloc at any of its allocations changes neither the mesh, nor its adjacencies, nor its properties.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/all_or_nothing.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::all_or_nothing;
using cn::testing::for_each_failing_allocation;

namespace {

template<class R>
auto listed(const R& range) {
  return std::vector<std::remove_cvref_t<decltype(*range.begin())>>(range.begin(), range.end());
}

template<class M>
void add_random_poly(M& m, std::mt19937 random) {
  const auto all = listed(cn::verts(m));
  std::vector<cn::vert_id> corners;
  const unsigned n = std::same_as<M, cn::polyhedralmesh> ? 4 : cn::arity_v<M> ? cn::arity_v<M> : 3 + random() % 4;
  for (const unsigned i : cn::testing::some_of(random, static_cast<unsigned>(all.size()), n)) corners.push_back(all[i]);
  if constexpr (!std::same_as<M, cn::polyhedralmesh>) {
    cn::add_poly(m, std::span<const cn::vert_id>(corners));
  } else {
    const auto faces = listed(cn::faces(m));
    std::vector<std::pair<cn::face_id, bool>> some;
    for (const unsigned i : cn::testing::some_of(random, static_cast<unsigned>(faces.size()), 3)) some.emplace_back(faces[i], i % 2 == 0);
    cn::add_poly(m, {some[0], some[1], some[2]});
  }
}

}  // namespace

TEST_CASE_TEMPLATE("an edit that runs out of memory changes nothing", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(7);
  for (const bool grid : {true, false}) {
    M m = grid ? cn::testing::grid<M>(1) : cn::testing::random_soup<M>(random, 9, 9).mesh();
    cn::testing::give_properties(m);
    std::size_t failed = 0;
    for (unsigned step = 0; step < 8; ++step) {
      INFO("step ", step);
      const std::mt19937 now = random;
      const auto polys = listed(cn::polys(m));
      const auto verts = listed(cn::verts(m));
      const auto apply = [&](const auto& edit) {
        failed += all_or_nothing(m, edit);
        edit(m);
      };
      if (step == 5) {
        const cn::vert_id v = verts[random() % verts.size()];
        apply([v](M& x) { cn::remove_vert(x, v); });
      } else if (step % 4 == 1) {
        apply([](M& x) { cn::add_vert(x, cn::point(x, *cn::verts(x).begin())); });
      } else if (step % 4 == 2 && !polys.empty()) {
        const cn::poly_id p = polys[random() % polys.size()];
        apply([p](M& x) { cn::remove_poly(x, p); });
      } else if (!polys.empty()) {
        if constexpr (std::same_as<M, cn::polyhedralmesh>) {
          apply([&](M& x) { cn::add_face(x, {verts[0], verts[3], verts[1], verts[2]}); });
        }
        apply([now](M& x) { add_random_poly(x, now); });
      }
      random.discard(1);
    }
    CHECK(failed > 20);
    CHECK(cn::check_laws(m).empty());
  }
}

TEST_CASE("edits of triangles without properties that run out of memory change nothing") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(4);
  std::size_t failed = 0;
  for (unsigned i = 0; i < 24; ++i) {
    const cn::edge_id e{7 * i};
    if (!cn::contains(m, e)) continue;
    const auto edit = [i, e](cn::trimesh& x) { return i % 3 == 0 ? bool(cn::edge_split(x, e)) : i % 3 == 1 ? bool(cn::edge_flip(x, e)) : bool(cn::edge_collapse(x, e)); };
    failed += all_or_nothing(m, edit);
    edit(m);
  }
  CHECK(failed > 20);
}

TEST_CASE_TEMPLATE("cleaning up that runs out of memory changes nothing", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::grid<M>(1);
  cn::testing::give_properties(m);
  CHECK(all_or_nothing(m, [](M& x) { cn::flip_winding(x); }) > 5);
  const auto polys = listed(cn::polys(m));
  for (std::size_t i = 0; i < polys.size(); i += 2) cn::remove_poly(m, polys[i]);
  cn::add_vert(m, {1, 2, 3});
  CHECK(all_or_nothing(m, [](M& x) { cn::remove_unreferenced(x); }) > 0);
  CHECK(all_or_nothing(m, [](M& x) { cn::garbage_collect(x); }) > 20);
}

TEST_CASE_TEMPLATE("merging and splitting verts that runs out of memory changes nothing", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::two_grids<M>(1);
  cn::testing::give_properties(m);
  cn::vert_id at_one, at_two;
  for (const auto v : cn::verts(m)) {
    if (cn::point(m, v) == cn::vec3{1, 0, 0}) at_one = v;
    if (cn::point(m, v) == cn::vec3{2, 0, 0}) at_two = v;
  }
  const auto merge = [&](M& x) { return bool(cn::merge_verts(x, at_one, {at_two}, {.at_mean = true})); };
  CHECK(all_or_nothing(m, merge) > 20);
  REQUIRE(merge(m));
  CHECK(all_or_nothing(m, [](M& x) { cn::split_vert_fans(x); }) > 20);
  const cn::vert_id first = *cn::adj_v2v(m, at_one).begin();
  CHECK(all_or_nothing(m, [&](M& x) { cn::merge_verts(x, at_one, {first}, {.degenerate = cn::degenerate_polys::remove}); }) > 20);
}

TEST_CASE("an edit of long polygons that runs out of memory changes nothing") {
  // two polygons of 40 verts that share every third edge, and a third polygon at one of these edges
  std::vector<cn::vec3> points(80);
  std::vector<std::vector<unsigned>> lists(2);
  for (unsigned i = 0; i < 40; ++i) lists[0].push_back(i), lists[1].push_back(i % 3 == 2 ? 40 + i : i);
  cn::polygonmesh m(points, std::vector<std::vector<unsigned>>{lists[0]});
  cn::testing::give_properties(m);
  for (const auto& list : {lists[1], std::vector<unsigned>{0, 1, 79}, lists[1]}) {
    const auto edit = [&list](cn::polygonmesh& x) {
      std::vector<cn::vert_id> corners;
      for (const unsigned i : list) corners.push_back(cn::vert_id{i});
      cn::add_poly(x, std::span<const cn::vert_id>(corners));
    };
    all_or_nothing(m, edit);
    edit(m);
    CHECK(cn::check_laws(m).empty());
  }
  for (const unsigned p : {1u, 0u, 3u}) {
    const auto edit = [p](cn::polygonmesh& x) { cn::remove_poly(x, cn::poly_id{p}); };
    all_or_nothing(m, edit);
    edit(m);
    CHECK(cn::check_laws(m).empty());
  }
}

TEST_CASE_TEMPLATE("a mesh built by edits is valid after running out of memory at any of them", M, cn::trimesh, cn::tetmesh) {
  const M from = cn::testing::grid<M>(1);
  const auto build = [&](M& m) {
    for (const auto v : cn::verts(from)) cn::add_vert(m, cn::point(from, v));
    for (const auto p : cn::polys(from)) {
      const auto corners = listed(cn::adj_p2v(from, p));
      cn::add_poly(m, std::span<const cn::vert_id>(corners));
    }
  };
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M m;
    if (attempt([&] { build(m); })) CHECK(cn::check_laws(m).empty());
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
}

TEST_CASE_TEMPLATE("an edit of polygons or polyhedra that runs out of memory changes nothing", M, cn::polygonmesh, cn::polyhedralmesh) {
  M m = cn::testing::grid<M>(cn::VolumeMesh<M> ? 1 : 2);
  cn::testing::give_properties(m);
  std::size_t failed = 0;
  const auto check = [&](const M& start, const auto& edit) {
    M after = start;
    CHECK(edit(after));
    failed += all_or_nothing(start, edit);
  };
  const auto first_allowed = [](const M& x, const auto& range, const auto& is_allowed) {
    for (const auto e : range)
      if (is_allowed(x, e)) return e;
    FAIL("none is allowed");
    return *range.begin();
  };
  const auto edge = first_allowed(m, cn::edges(m), [](const M& x, cn::edge_id e) { return bool(cn::can_edge_collapse(x, e)); });
  check(m, [=](M& x) { return bool(cn::edge_collapse(x, edge, {.keep = {cn::no_inversion}})); });
  check(m, [=](M& x) { return bool(cn::edge_split(x, edge)); });
  M with_vert = m;
  const cn::vert_id v = cn::edge_split(with_vert, edge).vert;
  check(with_vert, [=](M& x) { return bool(cn::edge_merge(x, v)); });
  const auto between = first_allowed(m, cn::facets(m), [](const M& x, const auto& f) { return bool(cn::can_merge_polys(x, f)); });
  check(m, [=](M& x) { return bool(cn::merge_polys(x, between, {.keep = {cn::min_quality(-1, cn::metric::star_shapedness)}})); });
  const auto all = cn::make_poly_map<int>(m, 0);
  check(m, [&](M& x) { return bool(cn::merge_polys(x, all)); });
  if constexpr (cn::VolumeMesh<M>) {
    const auto f = *cn::faces(m).begin();
    const auto corners = listed(cn::adj_f2v(m, f));
    check(m, [=](M& x) { return bool(cn::face_cut(x, f, corners[0], corners[2])); });
    M cut = m;
    const auto made = cn::face_cut(cut, f, corners[0], corners[2]);
    check(cut, [=](M& x) { return bool(cn::face_merge(x, made.faces[0], made.faces[1])); });
    M boxes(cn::testing::extrude(cn::testing::quad_grid(1), 2));
    std::vector<cn::edge_id> loop;
    for (const auto e : cn::edges(boxes)) {
      const auto ends = cn::end_verts(boxes, e);
      if (cn::point(boxes, ends.first).z == 0.5 && cn::point(boxes, ends.second).z == 0.5) loop.push_back(e);
    }
    CHECK(cn::merge_polys(boxes, first_allowed(boxes, cn::faces(boxes), [](const M& x, cn::face_id g) { return bool(cn::can_merge_polys(x, g)); })));
    cn::testing::give_properties(boxes);
    check(boxes, [=](M& x) { return bool(cn::poly_cut(x, cn::poly_id{0}, loop)); });
  } else {
    const auto corners = listed(cn::adj_p2v(m, cn::poly_id{0}));
    check(m, [=](M& x) { return bool(cn::poly_cut(x, cn::poly_id{0}, corners[0], corners[3])); });
  }
  M numbers = cn::testing::grid<M>(cn::VolumeMesh<M> ? 1 : 2);  // a transaction needs values that can be copied byte by byte
  cn::vert_property<double>(numbers, "a");
  cn::poly_property<int>(numbers, "d");
  check(numbers, [=](M& x) {
    cn::transaction t(x);
    const auto made = cn::edge_split(x, edge);
    const bool done = made && cn::edge_merge(x, made.vert) && cn::merge_polys(x, between);
    t.commit();
    return done;
  });
  CHECK(failed > 100);
}

TEST_CASE_TEMPLATE("agglomerate_while that runs out of memory keeps the merges that were made", M, cn::polygonmesh, cn::polyhedralmesh) {
  M start = cn::testing::grid<M>(cn::VolumeMesh<M> ? 1 : 2);
  cn::vert_property<double>(start, "a");
  cn::poly_property<int>(start, "d");
  M merged = start;
  const auto merge = [](M& m) { return cn::agglomerate_while(m, cn::min_quality(-1, cn::metric::star_shapedness), {.target = cn::num_polys(m) / 2}); };
  REQUIRE(merge(merged).num_merges > 0);
  const auto expected = cn::num_polys(merged);
  const auto old = cn::testing::whole(start);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M m = start;
    if (!attempt([&] { merge(m); })) return;
    CHECK(cn::num_polys(m) >= expected);
    CHECK(cn::check_laws(m).empty());
  });
  CHECK(result.failed > 20);
  CHECK(result.leaks == 0);
  const auto undone = for_each_failing_allocation([&](const auto& attempt) {
    M m = start;
    const bool is_undone = attempt([&] {
      cn::transaction t(m);
      merge(m);
      t.commit();
    });
    CHECK((cn::testing::whole(m) == old) == is_undone);
  });
  CHECK(undone.failed > 20);
}
