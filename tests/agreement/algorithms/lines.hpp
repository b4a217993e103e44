// Compares integral lines.
#pragma once

#include <agreement/algorithms/level_sets.hpp>

#include <concino/lines/integral_line.hpp>

#include <vector>

namespace concino::agreement {

struct integral_lines_of {
  static constexpr const char* name = "integral_line";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    auto g = make_poly_map<vec3>(both.native);
    auto h = make_poly_map<vec3>(both.other);
    for (const auto p : both.polys.all) {
      const unsigned n = p.raw() * 2654435761u >> 16;  // some equal, some along axes
      g[p] = h[both.polys.to(p)] = vec3(static_cast<int>(n % 5) - 2, static_cast<int>(n / 5 % 5) - 2, static_cast<int>(n / 25 % 5) - 2);
    }
    std::vector<vert_t<typename B::native_mesh>> starts;
    std::vector<vert_t<typename B::other_mesh>> same_starts;
    for (const auto v : both.verts.all) {
      if (starts.size() == 200) break;
      starts.push_back(v);
      same_starts.push_back(both.verts.to(v));
    }
    const auto expected = integral_lines(both.native, g, starts, {.max_steps = 500});
    const auto found = integral_lines(both.other, h, same_starts, {.max_steps = 500});
    for (std::size_t i = 0; i < expected.size(); ++i) {
      expect(expected[i].stopped_by == found[i].stopped_by, "lines stop for the same reason");
      expect(expected[i].length == found[i].length, "equal lengths");
      expect(expected[i].points.size() == found[i].points.size(), "as many points");
      for (std::size_t k = 0; k < expected[i].points.size(); ++k)
        expect(native_point(both, expected[i].points[k]) == other_point(both, found[i].points[k]), "the same points");
    }
    return true;
  }
};

}  // namespace concino::agreement
