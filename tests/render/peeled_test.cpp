#include <concino/render/peeled.hpp>

#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

template<class M>
std::size_t remaining(const M& m, int n) {
  const auto stays = peeled(n).prepare(m);
  std::size_t count = 0;
  for (const auto p : polys(m)) count += stays(p);
  return count;
}

}  // namespace

TEST_CASE("peeled: each layer of a cube is one cube of hexes less") {
  const hexmesh m(testing::hex_grid(7));
  CHECK(remaining(m, 0) == 343);
  CHECK(remaining(m, 1) == 125);
  CHECK(remaining(m, 2) == 27);
  CHECK(remaining(m, 3) == 1);
  CHECK(remaining(m, 4) == 0);
  CHECK(remaining(m, 1000000000) == 0);
}

TEST_CASE("peeled: layers of surfaces; a closed one has none") {
  const polygonmesh m(testing::polygon_grid(3));
  std::size_t boundary = 0;
  for (const auto p : polys(m)) boundary += is_boundary(m, p);
  CHECK(remaining(m, 1) == num_polys(m) - boundary);
  const trimesh closed(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, std::vector<std::array<unsigned, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(remaining(closed, 5) == 4);
  CHECK(remaining(trimesh{}, 1) == 0);
  CHECK_THROWS_WITH_AS(peeled(-1), "peeled: the number of layers must not be negative", invalid_argument);
}
