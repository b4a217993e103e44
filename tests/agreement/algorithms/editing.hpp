// Compares add_vert, add_poly, remove_poly and remove_vert on copies of meshes that have them.
#pragma once

#include <agreement/copies.hpp>
#include <agreement/matched.hpp>

#include <concino/edit/elements.hpp>
#include <concino/validate/check_laws.hpp>

#include <span>
#include <type_traits>
#include <vector>

namespace concino::agreement {

struct edits {
  static constexpr const char* name = "edits";
  template<class M> static constexpr bool runs_on =
      EmbeddedMesh<M> && std::is_copy_constructible_v<M> && requirement::has_add_vert<M> && requirement::has_add_poly<M> &&
      requirement::has_remove_poly<M> && requirement::has_remove_vert<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    using N = typename B::native_mesh;
    if (!both.polys.empty()) {
      N here = both.native;
      M there = both.other;
      for (const auto p : {both.polys.first(), both.polys.last()})
        if (contains(here, p)) {
          remove_poly(here, p);
          remove_poly(there, both.polys.to(p));
        }
      expect_same(here, there, "after polys were removed");
      const auto v = both.verts.all[both.verts.all.size() / 2];
      remove_vert(here, v);
      remove_vert(there, both.verts.to(v));
      expect_same(here, there, "after a vert was removed");
    }
    M there = both.other;
    std::vector<vert_t<M>> corners;
    constexpr int n = arity_v<M> ? arity_v<M> : dimension_v<M> == 2 ? 3 : 4;
    static constexpr double corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int i = 0; i < n; ++i) {
      const double* const x = corner[n == 4 && dimension_v<M> == 3 && i == 3 ? 4 : i];
      corners.push_back(add_vert(there, vec3{50 + x[0], x[1], x[2]}));
    }
    const poly_t<M> p = add_poly(there, std::span<const vert_t<M>>(corners));
    expect(num_polys(there) == num_polys(both.native) + 1 && num_verts(there) == num_verts(both.native) + corners.size(), "one poly more, on verts of its own");
    std::size_t found = 0;
    for (const auto v : adj_p2v(there, p)) found += v == corners[found % corners.size()];
    expect(found == corners.size(), "the corners of the new poly");
    for (const auto q : both.polys.all) {
      numbers expected, now;
      for (const auto v : adj_p2v(both.native, q)) expected.push_back(v.raw());
      for (const auto v : adj_p2v(there, both.polys.to(q))) now.push_back(both.verts.back(v).raw());
      expect(sorted(expected) == sorted(now), "the others have the corners that they had");
    }
    expect(check_laws(there).empty(), "the laws hold after an addition");
    return true;
  }

  template<class N, class M>
  static void expect_same(const N& here, const M& there, const char* when) {
    INFO(std::string(when));
    const auto native = general_copy(here);
    const matched<std::remove_cvref_t<decltype(native)>, M> both(native, there);  // throws if they differ
    for (const auto p : both.polys.all) {
      numbers expected, found;
      for (const auto v : adj_p2v(native, p)) expected.push_back(v.raw());
      for (const auto v : adj_p2v(there, both.polys.to(p))) found.push_back(both.verts.back(v).raw());
      expect(sorted(expected) == sorted(found), "polys of the same verts");
    }
    expect(check_laws(there).empty(), "the laws hold");
  }
};

}  // namespace concino::agreement
