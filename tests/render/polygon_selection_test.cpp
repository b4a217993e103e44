#include <concino/render/polygon_selection.hpp>

#include <concino/mesh/facet_map.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/render/make_drawable.hpp>
#include <concino/render/slicing.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace concino;

namespace {

template<class M>
std::size_t count(const M& m, const polygon_selection<M>& some) {
  std::vector<unsigned char> all{1};
  some.fill(m, all);
  return static_cast<std::size_t>(std::count(all.begin(), all.end(), 1));
}

static_assert(!std::is_convertible_v<std::vector<vert_id>, polygon_selection<hexmesh>> && !std::is_convertible_v<int, polygon_selection<hexmesh>>);
static_assert(std::is_convertible_v<std::vector<poly_id>, polygon_selection<quadmesh>> && !std::is_convertible_v<std::vector<poly_id>, polygon_selection<hexmesh>>);

}  // namespace

TEST_CASE("polygon_selection: containers and maps of polys of a surface or faces of a volume") {
  const quadmesh m(testing::quad_grid(3));
  const hexmesh cube(testing::hex_grid(2));
  CHECK(!polygon_selection<quadmesh>());
  CHECK(count<quadmesh>(m, std::vector<poly_id>{poly_id{1}, poly_id{4}, poly_id{1}}) == 2);
  CHECK(count<quadmesh>(m, polys(m)) == 9);
  auto mark = make_poly_map<bool>(m);
  const polygon_selection<quadmesh> later = mark, copy = later;
  mark[poly_id{2}] = true;
  CHECK(count(m, copy) == 1);
  CHECK(count<hexmesh>(cube, make_facet_map<bool>(cube, true)) == num_faces(cube));
  CHECK(count<hexmesh>(cube, exposed_facets(cube, below('x', 0.5))) == 4);
}

TEST_CASE("polygon_selection: make_drawable marks selected polygons and those that a criterion exposes") {
  const hexmesh cube(testing::hex_grid(4));
  const auto exposed = [](const drawable& d) { return std::count(d.exposed.begin(), d.exposed.end(), 1); };
  const auto cut = exposed_facets(cube, below('x', 0.5));
  CHECK(exposed(make_drawable(cube)) == 0);
  CHECK(exposed(make_drawable(cube, {.exposed = cut})) == 0);  // they are inside
  CHECK(exposed(make_drawable(cube, {.visible = below('x', 0.5)})) == 16);
  std::vector<face_id> side;
  for (const auto f : faces(cube))
    if (centroid(cube, f).x == 0) side.push_back(f);
  const drawable d = make_drawable(cube, {.visible = below('x', 0.5), .exposed = side});
  CHECK(exposed(d) == 32);
  CHECK(d.exposed.size() == d.polygons().size());
}

TEST_CASE("polygon_selection: polygons of other meshes are refused") {
  const quadmesh m(testing::quad_grid(2)), other(testing::quad_grid(3));
  CHECK_THROWS_WITH_AS(count<quadmesh>(m, std::vector<poly_id>{poly_id{4}}), "polygon_selection: there is no polygon with index 4; the selection was made for another mesh",
                       invalid_argument);
  CHECK_THROWS_AS(count<quadmesh>(m, make_poly_map<bool>(other)), invalid_argument);
}
