#include <concino/edit/simplex_cavity.hpp>

#include <concino/edit/poly_split.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/kinds.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("simplex_cavity: a poly is replaced by those that join its facets to a new vert; a transaction undoes it", M, trimesh, tetmesh) {
  auto m = grid<M>(2);
  const auto label = poly_property<int>(m, "label");
  for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw());
  const auto before = whole(m);
  const poly_id p{5};
  const std::size_t n = num_polys(m);
  const auto split = [&] {
    simplex_cavity<M> c(m);
    REQUIRE(c.add_old(p));
    vec3 mean;
    for (unsigned i = 0; i < c.size; ++i) mean += point(m, c.vert_at(c.corners(0)[i])) / double(c.size);
    const unsigned a = c.corners(0)[0];
    c.add_point(mean, {a, a, 0});
    for (unsigned i = 0; i < c.size; ++i) c.add_new(0, c.corners(0)[i], c.added);
    c.keep(1);
    c.apply(m);
    CHECK(point(m, c.new_vert()) == mean);
    CHECK(num_elements(adj_v2p(m, c.new_vert())) == c.size);
    for (const auto q : adj_v2p(m, c.new_vert())) CHECK(label[q] == 5);
  };
  {
    transaction t(m);
    split();
  }
  CHECK(whole(m) == before);
  split();
  CHECK(num_polys(m) == n + dimension_v<M>);
  CHECK(contains(m, p));
  CHECK(check_laws(m).empty());
}

TEST_CASE("simplex_cavity: polys that are no simplices are refused") {
  const auto quads = grid<polygonmesh>(3);
  simplex_cavity<polygonmesh> c(quads);
  for (const auto p : polys(quads))
    if (num_elements(adj_p2v(quads, p)) != 3) {
      CHECK(!c.add_old(p));
      break;
    }
}
