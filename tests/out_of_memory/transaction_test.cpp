// Sequences of edits that run out of memory at any allocation, inside a transaction and outside: what had been done is undone, and undoing needs no memory.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <support/all_or_nothing.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <random>

namespace cn = concino;
using cn::testing::for_each_failing_allocation;
using cn::testing::whole;

namespace {

/// Properties whose bytes can be copied.
template<class M>
M with_numbers(unsigned n) {
  M m = cn::testing::grid<M>(n);
  const auto a = cn::vert_property<double>(m, "a");
  for (const auto v : cn::verts(m)) a[v] = v.raw();
  const auto d = cn::poly_property<int>(m, "d");
  for (const auto p : cn::polys(m)) d[p] = static_cast<int>(p.raw());
  return m;
}

/// 20 edits of all kinds.
template<class M>
void edit_often(M& m) {
  std::mt19937 random(41);
  for (unsigned i = 0; i < 20; ++i) {
    const cn::edge_id e{random() % cn::edge_index_bound(m)};
    const cn::poly_id p{random() % cn::poly_index_bound(m)};
    switch (i % 7) {
      case 0:
        if (cn::contains(m, e)) cn::edge_split(m, e, 0.25);
        break;
      case 1:
        if (cn::contains(m, e)) cn::edge_collapse(m, e);
        break;
      case 2:
        if (cn::contains(m, e)) cn::edge_flip(m, e);
        break;
      case 3:
        if (cn::contains(m, p)) cn::poly_split(m, p);
        break;
      case 4: {
        const cn::vert_id v = *cn::verts(m).begin(), w{random() % cn::vert_index_bound(m)};
        if (cn::contains(m, w)) cn::merge_verts(m, v, {w}, {.degenerate = cn::degenerate_polys::remove, .at_mean = true});
        break;
      }
      case 5: cn::split_vert_fans(m); break;
      default:
        cn::add_vert(m, {1, 2, 3});
        if (cn::contains(m, p)) cn::remove_poly(m, p);
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("a transaction that runs out of memory is undone", M, cn::trimesh, cn::tetmesh) {
  const M before = with_numbers<M>(2);
  const std::vector<double> old = whole(before);
  M edited = before;
  edit_often(edited);
  REQUIRE(whole(edited) != old);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M m = before;
    const bool failed = attempt([&] {
      cn::transaction t(m);
      edit_often(m);
      t.commit();
    });
    CHECK((whole(m) == old) == failed);
  });
  CHECK(result.failed > 50);
  CHECK(result.leaks == 0);
}

TEST_CASE_TEMPLATE("undoing a transaction needs no memory", M, cn::trimesh, cn::tetmesh) {
  M m = with_numbers<M>(2);
  const std::vector<double> old = whole(m);
  cn::transaction t(m);
  edit_often(m);
  std::size_t times = 0;
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    if (times++ == 0) CHECK_FALSE(attempt([&] { t.roll_back(); }));
    else attempt([] {});
  });
  CHECK(result.allocations == 0);
  CHECK(whole(m) == old);
}

TEST_CASE_TEMPLATE("an operator that runs out of memory changes nothing, also inside a transaction", M, cn::trimesh, cn::tetmesh) {
  const M before = with_numbers<M>(2);
  for (const bool recorded : {false, true}) {
    const auto result = for_each_failing_allocation([&](const auto& attempt) {
      M m = before;
      std::optional<cn::transaction<M>> t;
      if (recorded) t.emplace(m);
      for (unsigned i = 0; i < 6; ++i) {
        std::mt19937 random(i);
        const cn::edge_id e{random() % cn::edge_index_bound(m)};
        if (!cn::contains(m, e)) continue;
        const auto old = whole(m);
        const bool failed = attempt([&] {
          if (i % 2) cn::edge_collapse(m, e, {.at = 0.3});
          else cn::edge_split(m, e, 0.25);
        });
        if (failed) CHECK(whole(m) == old);
      }
    });
    CHECK(result.failed > 10);
  }
}

TEST_CASE_TEMPLATE("an edit of elements that runs out of memory inside a transaction changes nothing", M, CONCINO_ALL_KINDS) {
  M before = cn::testing::two_grids<M>(1);
  const auto a = cn::vert_property<double>(before, "a");
  for (const auto v : cn::verts(before)) a[v] = v.raw();
  cn::edge_property<int>(before, "e");
  cn::corner_property<int>(before, "c");
  const cn::vert_id loose = cn::add_vert(before, {1, 2, 3});
  cn::vert_id at_one, at_two;
  for (const auto v : cn::verts(before)) {
    if (cn::point(before, v) == cn::vec3{1, 0, 0}) at_one = v;
    if (cn::point(before, v) == cn::vec3{2, 0, 0}) at_two = v;
  }
  std::vector<std::function<void(M&)>> edits{
      [&](M& m) { cn::add_vert(m, {0, 0, 0}); },
      [&](M& m) { cn::set_point(m, loose, cn::vec3{0, 0, 0}); },
      [&](M& m) { cn::remove_poly(m, cn::poly_id{0}); },
      [&](M& m) { cn::remove_vert(m, at_one); },
      [&](M& m) { cn::remove_unreferenced(m); },
      [&](M& m) { cn::flip_winding(m); },
      [&](M& m) { cn::merge_verts(m, at_one, {at_two, loose}, {.at_mean = true}); },
      [&](M& m) { cn::split_vert_fans(m); },
  };
  if constexpr (cn::VolumeMesh<M>) edits.push_back([](M& m) { cn::remove_face(m, *cn::faces(m).begin()); });
  if constexpr (std::same_as<M, cn::polyhedralmesh>) {
    cn::add_face(before, {loose, at_one, cn::add_vert(before, {1, 2, 3})});
    edits.push_back([&](M& m) { cn::add_face(m, {at_two, at_one, loose}); });
    edits.push_back([](M& m) { cn::add_poly(m, {{cn::face_id{0}, true}, {cn::face_id{7}, true}, {cn::face_id{1}, true}}); });
  } else {
    REQUIRE(cn::merge_verts(before, at_one, {at_two}));  // for split_vert_fans
    edits[6] = [&](M& m) { cn::merge_verts(m, at_one, {*cn::adj_v2v(m, at_one).begin()}, {.degenerate = cn::degenerate_polys::remove}); };
  }
  const std::vector<double> old = whole(before);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    INFO("edit ", i);
    const auto result = for_each_failing_allocation([&](const auto& attempt) {
      M m = before;
      cn::transaction t(m);
      const bool failed = attempt([&] { edits[i](m); });
      if (failed) CHECK(whole(m) == old);
      t.roll_back();
      CHECK(whole(m) == old);
    });
    CHECK(result.failed > 0);
    CHECK(result.leaks == 0);
  }
}
