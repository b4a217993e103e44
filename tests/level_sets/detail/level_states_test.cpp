#include <concino/level_sets/detail/level_states.hpp>

#include <concino/mesh/polygonmesh.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace cn = concino;

TEST_CASE("level_states: the joint states of lists of any length, wherever a state is in the list") {
  constexpr unsigned char below = cn::detail::below_level, on = cn::detail::on_level, above = cn::detail::above_level;
  for (unsigned n = 3; n < 26; ++n) {
    std::vector<unsigned> list;
    for (unsigned k = 0; k < n; ++k) list.push_back(k);
    const cn::polygonmesh m(std::vector<cn::vec3>(n), std::vector<std::vector<unsigned>>{list});
    std::vector<unsigned char> states(n, below);
    const auto joint = [&] { return cn::detail::joint_states(m, states.data(), cn::poly_id{0}); };
    CHECK(joint() == below);
    for (unsigned k = 0; k < n; ++k) {
      states[k] = above;
      CHECK(joint() == (below | above));
      states[(k + 1) % n] = on;
      CHECK(joint() == (below | on | above));
      states[k] = states[(k + 1) % n] = below;
    }
  }
}
