// Random edits by every operator, those of elements too, on all kinds of mesh: numbers of elements and measures as predicted, laws, and a newly constructed
// mesh agrees.
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/random_edits.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <random>

namespace cn = concino;
using namespace cn::testing;

TEST_CASE_TEMPLATE("random edits of elements: all kinds of mesh", M, CONCINO_KINDS) {
  std::array<std::size_t, num_random_operators> done{};
  for (const unsigned seed : {11u, 12u}) {  // two short sequences, as meshes grow
    std::mt19937 random(seed);
    M m = grid<M>(cn::dimension_v<M> == 2 ? 2 : is_of_simplices<M> ? 1 : 2);
    const auto a = cn::vert_property<double>(m, "a");
    for (const auto v : cn::verts(m)) a[v] = v.raw();
    const auto d = cn::poly_property<int>(m, "d");
    for (const auto p : cn::polys(m)) d[p] = static_cast<int>(p.raw());
    const auto r = edit_at_random(m, random, long_run() ? 500000 : 5000, num_random_operators);
    for (unsigned what = 0; what < num_random_operators; ++what) done[what] += r.done[what];
  }
  for (unsigned what = 0; what < num_random_operators; ++what)
    if (has_operator<M>(what)) CHECK_MESSAGE(done[what] > 0, "operator " << what);
}

TEST_CASE("random edits: triangles in a mesh of polygons") {
  std::mt19937 random(13);
  const auto r = edit_at_random(cn::polygonmesh(triangle_grid(3)), random, long_run() ? 750000 : 7500, num_topological_operators);
  for (unsigned what = 0; what < flip_face; ++what) CHECK_MESSAGE(r.done[what] > 0, "operator " << what);
}
