#include <concino/level_sets/detail/cell_surface.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

using facet = std::vector<std::uint32_t>;

/// The same answer from few_facets, for less than eight of them, and from cell_surface; some facets are turned over, and said to be.
bool is_sphere(const std::vector<facet>& facets, std::size_t num_verts, std::size_t num_edges, int is_wrong = -1) {
  std::vector<bool> answers;
  for (const int turned : {-1, 0, 2}) {
    cn::detail::few_facets few;
    cn::detail::cell_surface all;
    for (int i = 0; i < static_cast<int>(facets.size()); ++i) {
      facet f = facets[static_cast<std::size_t>(i)];
      if (i == turned) f.assign(facets[static_cast<std::size_t>(i)].rbegin(), facets[static_cast<std::size_t>(i)].rend());
      const bool is_outward = (i != turned) != (i == is_wrong);
      few.add_facet(f, is_outward), all.add_facet(f, is_outward);
    }
    answers.push_back(all.is_sphere(num_verts, num_edges));
    if (facets.size() <= cn::detail::few_facets::max_size) answers.push_back(few.is_sphere(num_verts, num_edges));
  }
  for (const bool x : answers) CHECK(x == answers.front());
  return answers.front();
}

}  // namespace

TEST_CASE("cell_surface: a closed surface of few facets, or of many, is a sphere if each edge is used in both directions") {
  const std::vector<facet> cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  CHECK(is_sphere(cube, 8, 12));
  CHECK_FALSE(is_sphere(cube, 8, 12, 3));   // seen from the wrong side
  CHECK_FALSE(is_sphere(cube, 8, 11));
  CHECK_FALSE(is_sphere(cube, 9, 12));
  std::vector<facet> open = cube, twisted = cube, cut = cube;
  open.pop_back();
  CHECK_FALSE(is_sphere(open, 8, 12));
  std::swap(twisted[5][1], twisted[5][2]);
  CHECK_FALSE(is_sphere(twisted, 8, 12));
  cut[0] = {0, 3, 2}, cut.push_back({0, 2, 1});
  CHECK(is_sphere(cut, 8, 13));
  cut[1] = {4, 5, 6}, cut.push_back({4, 6, 7});  // eight
  CHECK(is_sphere(cut, 8, 14));
  CHECK_FALSE(is_sphere(cut, 8, 14, 7));
}
