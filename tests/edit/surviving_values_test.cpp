// Edits of polygons and polyhedra: edges and faces whose verts stay keep their values and descriptors, and parts of others have those of the whole.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/random_poly_edits.hpp>
#include <support/surviving_values.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using namespace cn::testing;

TEST_CASE_TEMPLATE("edges and faces whose verts stay keep their values and descriptors in edits of polys", M, cn::polygonmesh, cn::polyhedralmesh) {
  const M start = grid<M>(cn::VolumeMesh<M> ? 1 : 3);
  std::mt19937 random(17);
  random_poly_editor<M> editor(start, random);
  std::size_t survived[num_poly_operators] = {};
  for (unsigned i = 0; i < (long_run() ? 5000u : 100u); ++i) {
    for (unsigned what = 0; what < num_poly_operators; ++what) {
      if (what > p_collapse && !cn::VolumeMesh<M>) continue;
      INFO("operator " << what);
      const surviving_values<M> before(editor.m);
      // a collapse gives edges and faces at its vert the values of two that become one, as that of simplices does
      if (editor.apply(what) && what != p_collapse) survived[what] += before.check(editor.m);
    }
    if (cn::num_polys(editor.m) < 4) editor.m = start;
  }
  for (unsigned what = 0; what < num_poly_operators; ++what)
    if (what != p_collapse && (what < p_collapse || cn::VolumeMesh<M>)) CHECK_MESSAGE(survived[what] > 0, "operator " << what);
}

TEST_CASE_TEMPLATE("values of edges of polys that are split, cut, merged and collapsed", M, cn::polygonmesh, cn::polyhedralmesh) {
  M m = grid<M>(cn::VolumeMesh<M> ? 1 : 3);
  const auto mark = cn::edge_property<double>(m, "mark");
  for (const auto e : cn::edges(m)) mark[e] = 1;
  const auto all_are_one = [&] {
    for (const auto e : cn::edges(m)) CHECK(mark[e] == 1);
  };
  const auto v = cn::edge_split(m, *cn::edges(m).begin(), 0.25);
  REQUIRE(v);
  all_are_one();  // two halves
  REQUIRE(cn::edge_merge(m, v.vert));
  all_are_one();
  for (const auto f : cn::facets(m))
    if (cn::merge_polys(m, f)) break;
  all_are_one();
  bool is_collapsed = false;
  for (const auto e : cn::edges(m)) {
    if (!cn::can_edge_collapse(m, e)) continue;
    mark[e] = 7;  // it vanishes, and nothing becomes of it
    is_collapsed = bool(cn::edge_collapse(m, e));
    break;
  }
  CHECK(is_collapsed);
  all_are_one();
  if constexpr (cn::SurfaceMesh<M>) {
    const auto p = *cn::polys(m).begin();
    const std::vector<cn::vert_id> corners(cn::adj_p2v(m, p).begin(), cn::adj_p2v(m, p).end());
    const auto cut = cn::poly_cut(m, p, corners[0], corners[2]);
    REQUIRE(cut);
    for (const auto e : cn::edges(m)) CHECK(mark[e] == (e == cut.edge ? 0 : 1));
  } else {
    for (const auto f : cn::faces(m)) {
      const std::vector<cn::vert_id> corners(cn::adj_f2v(m, f).begin(), cn::adj_f2v(m, f).end());
      if (corners.size() < 4) continue;
      const auto cut = cn::face_cut(m, f, corners[0], corners[2]);
      if (!cut) continue;
      for (const auto e : cn::edges(m)) CHECK(mark[e] == (e == cut.edge ? 0 : 1));
      break;
    }
  }
}
