// Compares direction fields, their singularities, and stripes across them.
#pragma once

#include <agreement/algorithms/virtual_elements.hpp>

#include <concino/directions.hpp>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace concino::agreement {

struct directions_of {
  static constexpr const char* name = "direction fields";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  /// Where the smallest eigenvalue is not simple, stripes differ, but not how even they are.
  template<class B, class V>
  static void compare_stripes(const B& both, const V& first) {
    const double frequency = 2 / std::sqrt(total_measure(both.native));
    direction_field_options<std::remove_cvref_t<decltype(both.native)>> options{.symmetry = 2, .hard = {{first, {1, 0.3, 0.2}}}};
    direction_field_options<std::remove_cvref_t<decltype(both.other)>> same{.symmetry = 2, .hard = {{both.verts.to(first), {1, 0.3, 0.2}}}};
    const auto f = direction_field(both.native, options);
    const auto g = direction_field(both.other, same);
    const auto s = stripes(both.native, f, frequency);
    const auto t = stripes(both.other, g, frequency);
    const double square = 4 * std::numbers::pi * std::numbers::pi * frequency * frequency;
    if (std::max(s.residual, t.residual) < 1e-8) expect(std::abs(s.energy - t.energy) < 1e-6 * square, "the energy of stripes");
  }

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!in.manifold || both.polys.all.empty() || !all_polys_have_measure(both.native)) return false;
    using native_mesh = std::remove_cvref_t<decltype(both.native)>;
    using other_mesh = std::remove_cvref_t<decltype(both.other)>;
    const auto first = *adj_p2v(both.native, both.polys.all.front()).begin();
    direction_field_options<native_mesh> options{.hard = {{first, {1, 0.3, 0.2}}}};
    direction_field_options<other_mesh> same{.hard = {{both.verts.to(first), {1, 0.3, 0.2}}}};
    const auto f = direction_field(both.native, options);
    const auto g = direction_field(both.other, same);
    expect(f.energies().size() == g.energies().size(), "as many components");
    if (in.in_one_piece)
      for (const auto v : both.verts.all) {
        if (std::abs(f.value(v)) < 1e-6) continue;
        const auto w = both.verts.to(v);
        double turns = 4 * std::acos(std::min(1.0, std::max(-1.0, dot(f.direction(v), g.direction(w))))) / (2 * std::numbers::pi);
        turns -= std::round(turns);
        expect(std::abs(turns) < 1e-6, "the directions");
        expect_close(std::abs(f.value(v)), std::abs(g.value(w)), 1e4, "the values");
      }
    int sum = 0, other_sum = 0;
    for (const auto& s : singularities(f)) sum += s.index;
    for (const auto& b : boundary_turns(f)) sum += b.index;
    for (const auto& s : singularities(g)) other_sum += s.index;
    for (const auto& b : boundary_turns(g)) other_sum += b.index;
    expect(sum == other_sum, "the sum of the indices");
    if (in.in_one_piece) compare_stripes(both, first);
    if (in.in_one_piece) {
      const int chi = sum / 4, index = in.closed ? chi : 0;
      std::vector<std::pair<vert_t<native_mesh>, int>> indices;
      std::vector<std::pair<vert_t<other_mesh>, int>> same_indices;
      if (in.closed) indices = {{first, chi}}, same_indices = {{both.verts.to(first), chi}};
      const auto w = trivial_connection(both.native, indices);
      const auto u = trivial_connection(both.other, same_indices);
      for (const auto v : both.verts.all) {
        expect_close(w.index(v), v == first ? index : 0, 1e4, "the index");
        expect_close(u.index(both.verts.to(v)), v == first ? index : 0, 1e4, "the index");
      }
      int loops = 0, other_loops = 0;
      for (const auto& b : boundary_turns(w)) loops += b.index;
      for (const auto& b : boundary_turns(u)) other_loops += b.index;
      expect(loops == chi - index && other_loops == chi - index, "the sum of the indices of loops");
    }
    return true;
  }
};

}  // namespace concino::agreement
