#include <concino/level_sets/detail/cut/cell_surface.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

using facet = std::vector<std::uint32_t>;

/// Some facets are turned over, and said to be, which changes no answer.
bool is_sphere(const std::vector<facet>& facets, std::size_t num_verts, int is_wrong = -1) {
  std::vector<bool> answers;
  for (const int turned : {-1, 0, 2}) {
    cn::detail::cell_surface all;
    for (int i = 0; i < static_cast<int>(facets.size()); ++i) {
      facet f = facets[static_cast<std::size_t>(i)];
      if (i == turned) f.assign(facets[static_cast<std::size_t>(i)].rbegin(), facets[static_cast<std::size_t>(i)].rend());
      for (const std::uint32_t v : f) all.add_corner(v);
      all.end_facet((i != turned) != (i == is_wrong));
    }
    answers.push_back(all.find_mates() && all.is_sphere(num_verts));
  }
  for (const bool x : answers) CHECK(x == answers.front());
  return answers.front();
}

}  // namespace

TEST_CASE("cell_surface: a closed surface of few facets, or of many, is a sphere if each edge is used in both directions") {
  const std::vector<facet> cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  CHECK(is_sphere(cube, 8));
  CHECK_FALSE(is_sphere(cube, 8, 3));   // seen from the wrong side
  CHECK_FALSE(is_sphere(cube, 9));
  std::vector<facet> open = cube, twisted = cube, cut = cube;
  open.pop_back();
  CHECK_FALSE(is_sphere(open, 8));
  std::swap(twisted[5][1], twisted[5][2]);
  CHECK_FALSE(is_sphere(twisted, 8));
  cut[0] = {0, 3, 2}, cut.push_back({0, 2, 1});
  CHECK(is_sphere(cut, 8));
  cut[1] = {4, 5, 6}, cut.push_back({4, 6, 7});  // eight
  CHECK(is_sphere(cut, 8));
  CHECK_FALSE(is_sphere(cut, 8, 7));
}
