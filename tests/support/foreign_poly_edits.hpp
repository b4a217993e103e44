// Edits of polygons of another library's mesh, and of its chords, that run out of memory: they change nothing.
#pragma once

#include <concino/layout/diagonal_collapse.hpp>
#include <concino/layout/insert_sheet.hpp>

#include <support/foreign_edits.hpp>
#include <support/some_element.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace concino::testing {

/// start: a mesh of quads whose library allows other polygons.
template<class M>
void poly_edits_are_all_or_nothing(const M& start, const auto& for_each_failing) {
  using edit = std::function<bool(M&, std::mt19937&)>;
  const auto corner = [](const M& m, const poly_t<M>& p, unsigned i) {
    auto v = adj_p2v(m, p).begin();
    for (; i > 0; --i) ++v;
    return *v;
  };
  const std::vector<edit> edits{
      [](M& m, std::mt19937& random) { return bool(edge_split(m, some_edge(m, random), 0.25)); },
      [](M& m, std::mt19937& random) {
        transaction t(m);
        const auto made = edge_split(m, some_edge(m, random), 0.25);
        const bool done = made && edge_merge(m, made.vert) && merge_polys(m, some_edge(m, random));
        t.commit();
        return done;
      },
      [&](M& m, std::mt19937& random) {
        const auto p = some_poly(m, random);
        return bool(poly_cut(m, p, corner(m, p, 0), corner(m, p, 2)));
      },
      [](M& m, std::mt19937& random) { return bool(merge_polys(m, some_edge(m, random))); },
      [](M& m, std::mt19937& random) { return bool(edge_collapse(m, some_edge(m, random))); },
      [](M& m, std::mt19937& random) { return bool(collapse_chord(m, chord_of(m, some_edge(m, random)), {.keep = {no_inversion}})); },
      [](M& m, std::mt19937& random) { return bool(pillow(m, std::vector{some_poly(m, random)})); },
      [&](M& m, std::mt19937& random) {
        const auto p = some_poly(m, random);
        return bool(diagonal_collapse(m, p, corner(m, p, 0)));
      },
  };
  for (std::size_t what = 0; what < edits.size(); ++what) {
    INFO("edit " << what);
    M expected = start;
    unsigned seed = 1;
    for (std::mt19937 random(seed); !edits[what](expected, random); random.seed(seed)) {
      REQUIRE(++seed < 100);
      expected = start;
    }
    const auto after = foreign_state(expected);
    const auto result = for_each_failing([&](const auto& attempt) {
      M m = start;
      { transaction first(m); }  // adds the property that knows of it. If memory runs out there, CGAL leaks it
      const auto before = foreign_state(m);
      std::mt19937 random(seed);
      if (attempt([&] { edits[what](m, random); })) {
        CHECK(foreign_state(m) == before);
        random.seed(seed);
        edits[what](m, random);
      }
      CHECK(foreign_state(m) == after);
    });
    CHECK(result.failed > 5);
    CHECK(result.leaks == 0);
  }
}

}  // namespace concino::testing
