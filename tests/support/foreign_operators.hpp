// Random edits of a surface of another library by every operator, in transactions or not.
#pragma once

#include <support/foreign_edits.hpp>
#include <support/some_element.hpp>

#include <new>

namespace concino::testing {

inline constexpr unsigned num_foreign_edits = 11;

/// An edit that keeps the topology, or is refused.
template<class M>
permission topological_edit(unsigned what, M& m, std::mt19937& random) {
  switch (what) {
    case 0: return edge_split(m, some_edge(m, random), 0.25);
    case 1: return edge_collapse(m, some_edge(m, random), {.at = 0.5 * double(random() % 3)});
    case 2: return edge_flip(m, some_edge(m, random));
    case 3: return poly_split(m, some_poly(m, random));
    default: {
      const vert_t<M> v = *adj_p2v(m, some_poly(m, random)).begin();
      std::vector<poly_t<M>> moved;
      for (const auto p : adj_v2p(m, v))
        if (random() % 3 == 0) moved.push_back(p);
      return vert_split(m, v, moved, {0.1, 0.2, 0.3});
    }
  }
}

/// That, or an edit of elements; whether it was made.
template<class M>
bool foreign_edit(unsigned what, M& m, std::mt19937& random) {
  try {
    switch (what) {
      case 5: remove_poly(m, some_poly(m, random)); return true;
      case 6: remove_vert(m, some_vert(m, random)); return true;
      case 7: add_vert(m, {1, 2, 3}); return true;
      case 8: set_point(m, some_vert(m, random), vec3{4, 5, 6}); return true;
      case 9: flip_winding(m, some_poly(m, random)); return true;
      case 10: {
        std::vector<vert_t<M>> corners;
        for (unsigned i = 0; i < 3; ++i) corners.push_back(some_vert(m, random));
        add_poly(m, std::span<const vert_t<M>>(corners));
        return true;
      }
      default: return bool(topological_edit(what, m, random));
    }
  } catch (const unsupported&) {  // neighbours of different winding, or a poly that half-edges cannot represent
    return false;
  } catch (const invalid_mesh&) {  // add_poly
    return false;
  }
}

template<class M>
void edit_some_times(M& m, std::mt19937& random, unsigned times) {
  for (unsigned i = 0; i < times && num_polys(m) > 0; ++i) foreign_edit(static_cast<unsigned>(random() % num_foreign_edits), m, random);
}

/// Transactions of m that are rolled back, undone and done again, and nested ones. check(m) looks at the library's own structure.
template<class M, class Check>
void transactions_leave_no_trace(M& m, std::mt19937& random, const Check& check) {
  for (unsigned round = 0; round < 4; ++round) {
    edit_some_times(m, random, 4);
    const auto before = foreign_state(m);
    {
      transaction t(m);
      edit_some_times(m, random, 12);
      const auto middle = foreign_state(m);
      {
        transaction inner(m);
        edit_some_times(m, random, 6);
      }
      CHECK(foreign_state(m) == middle);
    }
    CHECK(foreign_state(m) == before);
    foreign_laws_hold(m), check(m);
  }
  std::vector<std::vector<double>> states{foreign_state(m)};
  std::vector<committed_edits<M>> done;
  for (unsigned k = 0; k < 4; ++k) {
    transaction t(m);
    edit_some_times(m, random, 5);
    done.push_back(t.commit());
    states.push_back(foreign_state(m));
  }
  for (unsigned times = 0; times < 3; ++times) {
    const std::size_t depth = 1 + random() % 4;
    for (std::size_t k = 4; k > 4 - depth; --k) {
      done[k - 1].undo();
      CHECK(foreign_state(m) == states[k - 1]);
    }
    foreign_laws_hold(m), check(m);
    for (std::size_t k = 4 - depth; k < 4; ++k) {
      done[k].redo();
      CHECK(foreign_state(m) == states[k + 1]);
    }
    foreign_laws_hold(m), check(m);
  }
  add_vert(m, {0, 0, 0});
  CHECK_THROWS_AS(done.back().undo(), invalid_argument);
  transaction t(m);
  CHECK_THROWS_AS(garbage_collect(m), unsupported);
}

/// Values of properties stay at their elements in edits, and come back with elements that a transaction brings back. vert_values, edge_values, poly_values: maps
/// of properties of m to numbers.
template<class M, class V, class E, class P>
void values_follow(M& m, std::mt19937& random, V vert_values, E edge_values, P poly_values) {
  for (const auto v : verts(m)) vert_values[v] = static_cast<int>(index_of(m, v));
  for (const auto e : edges(m)) edge_values[e] = static_cast<int>(index_of(m, e));
  for (const auto p : polys(m)) poly_values[p] = static_cast<int>(index_of(m, p));
  const auto check_all = [&] {
    for (const auto v : verts(m)) CHECK(vert_values[v] == static_cast<int>(index_of(m, v)));
    for (const auto e : edges(m)) CHECK(edge_values[e] == static_cast<int>(index_of(m, e)));
    for (const auto p : polys(m)) CHECK(poly_values[p] == static_cast<int>(index_of(m, p)));
  };
  const auto vert_count = num_verts(m);
  for (unsigned round = 0; round < 10; ++round) {
    transaction t(m);
    edit_some_times(m, random, 10);
    t.roll_back();
    check_all();
    CHECK(num_verts(m) == vert_count);
    transaction u(m);
    edit_some_times(m, random, 10);
    auto done = u.commit();
    done.undo();
    check_all();
  }
  edge_collapse(m, some_edge(m, random));
  check_all();
}

/// An edit, a rollback or an undo that runs out of memory changes nothing.
template<class M>
void edits_are_all_or_nothing(const M& start, unsigned seed, const auto& for_each_failing) {
  std::size_t failed = 0;
  for (unsigned what = 0; what < num_foreign_edits; ++what) {
    const auto result = for_each_failing([&](const auto& attempt) {
      M m = start;
      const auto before = foreign_state(m);
      std::mt19937 random(seed);
      foreign_edit(what, m, random);
      const auto expected = foreign_state(m);
      m = start;
      random.seed(seed);
      const auto edit = [&] { foreign_edit(what, m, random); };
      if (attempt(edit)) {
        CHECK(foreign_state(m) == before);
        random.seed(seed);
        edit();
      }
      CHECK(foreign_state(m) == expected);
    });
    failed += result.failed;
    CHECK(result.leaks == 0);
  }
  CHECK(failed > 20);
  const auto result = for_each_failing([&](const auto& attempt) {
    M m = start;
    { transaction first(m); }  // adds the property that knows of it. If memory runs out there, CGAL leaks it
    const auto before = foreign_state(m);
    if (attempt([&] {
          std::mt19937 random(seed);
          transaction t(m);
          edit_some_times(m, random, 8);
          throw std::bad_alloc();
        }))
      CHECK(foreign_state(m) == before);
  });
  CHECK(result.failed > 20);
  CHECK(result.leaks == 0);
}

}  // namespace concino::testing
