#include <concino/render/slicing.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <set>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("visible_polys: those that meet the criterion; visible_facets: those with exactly one of them", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.05, VolumeMesh<M>));
  auto label = make_poly_map<int>(m);
  for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw() % 5);
  const auto criterion = (below('x', 0.6) || !above(plane_through({0, 0.3, 0}, {0, 2, 0}))) && !labeled(label, {2, 4});
  const auto visible = visible_polys(m, criterion);
  std::size_t count = 0;
  for (const auto p : polys(m)) {
    const vec3 c = centroid(m, p);
    const bool expected = (c.x < 0.6 || c.y < 0.3) && label[p] != 2 && label[p] != 4;
    CHECK(visible[p] == expected);
    count += expected;
  }
  CHECK(count > 0);
  CHECK(count < num_polys(m));
  std::vector<facet_t<M>> expected, exposed;
  for (const auto x : facets(m)) {
    std::size_t shown = 0, hidden = 0;
    for (const auto p : adj_facet2p(m, x)) ++(visible[p] ? shown : hidden);
    if (shown == 1) expected.push_back(x);
    if (shown == 1 && hidden > 0) exposed.push_back(x);
  }
  CHECK(visible_facets(m, criterion) == expected);
  CHECK(exposed_facets(m, criterion) == exposed);
  CHECK(exposed.size() > 0);
  CHECK(exposed.size() < expected.size());
  if constexpr (VolumeMesh<M>) CHECK(visible_faces(m, criterion) == expected);  // surfaces have no faces
  const poly_criterion<M> any = criterion;
  CHECK(exposed_facets(m, any) == exposed);

  const auto weak = only_embedded_mesh(m);  // uses nothing but the concept
  const auto seen = visible_polys(weak, below('x', 0.6) && peeled(1));
  const auto same = visible_polys(m, below('x', 0.6) && peeled(1));
  for (const auto p : polys(weak)) CHECK(seen[p] == same[weak.base(p)]);
  CHECK(exposed_facets(weak, below('x', 0.6)).size() == exposed_facets(m, below('x', 0.6)).size());
  CHECK(visible_facets(M{}, below('x', 1)).empty());
}

TEST_CASE("visible_faces: a slice of a grid of hexes") {
  const hexmesh m(hex_grid(4));
  CHECK(visible_faces(m, below('x', 0.3)).size() == 2 * 16 + 4 * 4);
  CHECK(exposed_facets(m, below('x', 0.3)).size() == 16);
  CHECK(exposed_facets(m, between('x', 0.3, 0.6)).size() == 32);
  CHECK(visible_faces(m, below('x', 10)).size() == 96);
  CHECK(exposed_facets(m, below('x', 10)).empty());
  CHECK(visible_faces(m, below('x', -10)).empty());
  CHECK(exposed_facets(m, peeled(1)).size() == 24);
  CHECK(visible_faces(m, peeled(1)).size() == 24);
}

TEST_CASE("visible_faces: faces of three tets, and meshes with gaps") {
  const tetmesh m(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 2}}, std::vector<std::array<unsigned, 4>>{{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}});
  CHECK(visible_faces(m, where([](const poly_id&) { return true; })).size() == 9);
  CHECK(visible_faces(m, where([](const poly_id& p) { return p.raw() < 2; })).size() == 6);
  CHECK(visible_faces(m, where([](const poly_id& p) { return p.raw() == 2; })).size() == 4);
  CHECK(exposed_facets(m, where([](const poly_id& p) { return p.raw() == 2; })).size() == 1);
  const auto two = submesh(m, [](const poly_id& p) { return p.raw() > 0; });
  const auto visible = visible_polys(two, !below('z', 0));
  CHECK(!visible[poly_id{1}]);
  CHECK(visible[poly_id{2}]);
  CHECK(visible_faces(two, !below('z', 0)).size() == 4);
}
