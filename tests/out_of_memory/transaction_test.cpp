// Sequences of edits that run out of memory at any allocation, inside a transaction and outside: what had been done is undone, and undoing needs no memory.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <support/all_or_nothing.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

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
    switch (i % 5) {
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
