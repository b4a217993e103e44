#include <concino/generate/subdivide_barycentric.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("subdivide_barycentric: a simplex for each vert, edge, face and poly in each other", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto s = subdivide_barycentric(m);
  CHECK(check_laws(s).empty());
  std::size_t expected = 0, centres = num_verts(m) + num_edges(m) + num_polys(m);
  if constexpr (VolumeMesh<M>) {
    centres += num_faces(m);
    for (const poly_t<M> p : polys(m))
      for (const face_t<M> f : adj_p2f(m, p)) expected += 2 * num_elements(adj_f2v(m, f));
  } else {
    for (const poly_t<M> p : polys(m)) expected += 2 * num_elements(adj_p2v(m, p));
  }
  CHECK(num_verts(s) == centres);
  CHECK(num_polys(s) == expected);
  CHECK(euler(s) == 1);
  double sum = 0;
  for (const poly_id p : polys(s)) sum += measure(s, p);
  if constexpr (VolumeMesh<M>) CHECK(sum == doctest::Approx(1).epsilon(1e-13));  // signed
  if constexpr (arity_v<M> != 0) check_sound(s, 1);                              // the L-shaped ones have parts that the means do not see
}

TEST_CASE_TEMPLATE("subdivide_barycentric: properties, correspondence, repetition", M, CONCINO_KINDS) {
  check_subdivision(grid<M>(1), [](const auto& m, const subdivide_options& o) { return subdivide_barycentric(m, o); });
}
