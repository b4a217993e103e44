// remove_unreferenced and remove_face: what belongs to no poly is removed, and nothing else changes.
#include <concino/edit/remove_unreferenced.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>
#include <support/rebuilt.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <limits>

namespace cn = concino;
using cn::testing::keeps_all_laws;
using cn::testing::raw;

TEST_CASE_TEMPLATE("remove_unreferenced: empty meshes, and meshes without such verts, stay as they are", M, CONCINO_ALL_KINDS) {
  for (M m : {M(), cn::testing::grid<M>(2)}) {
    const auto before = cn::testing::whole(m);
    CHECK(cn::remove_unreferenced(m) == cn::removed_counts{});
    CHECK(cn::testing::whole(m) == before);
  }
}

TEST_CASE_TEMPLATE("remove_unreferenced: verts that polys left behind", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::two_grids<M>(2);  // with one isolated vert
  cn::testing::give_properties(m);
  const std::size_t n = cn::num_verts(m), polys = cn::num_polys(m);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const cn::vert_id added = cn::add_vert(m, {nan, nan, nan});
  M half = m;
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{2});
  CHECK(cn::num_verts(m) == n - 1);
  CHECK_FALSE(cn::contains(m, added));
  keeps_all_laws(m);

  std::vector<cn::poly_id> first(cn::polys(half).begin(), cn::polys(half).end());
  first.resize(polys / 2);
  for (const auto p : first) cn::remove_poly(half, p);
  const std::vector<unsigned> edges = raw(cn::edges(half));
  const auto a = cn::vert_property<double>(half, "a");
  CHECK(cn::remove_unreferenced(half).verts == (n - 1) / 2 + 2);
  CHECK(raw(cn::edges(half)) == edges);
  CHECK(cn::num_verts(half) == (n - 1) / 2);
  for (const auto v : cn::verts(half)) CHECK(a[v] == 0.5 + v.raw());
  keeps_all_laws(half);
}

TEST_CASE("remove_unreferenced: faces and edges of polyhedra that no poly has") {
  auto m = cn::testing::grid<cn::polyhedralmesh>(2);
  const auto before = cn::testing::whole(m);
  const cn::vert_id v = cn::add_vert(m, {9, 9, 9}), w = cn::add_vert(m, {9, 9, 8}), old = *cn::verts(m).begin();
  const cn::face_id f = cn::add_face(m, {old, v, w});
  const auto inner = cn::adj_f2v(m, *cn::faces(m).begin());
  const std::vector<cn::vert_id> copy(inner.begin(), inner.end());
  const cn::face_id g = cn::add_face(m, std::span<const cn::vert_id>(copy));
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{2, 3, 2});
  CHECK_FALSE(cn::contains(m, f));
  CHECK_FALSE(cn::contains(m, g));
  CHECK(cn::num_verts(m) == static_cast<std::size_t>(before[0]));
  CHECK(cn::num_edges(m) == static_cast<std::size_t>(before[1]));
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("remove_face: removes the polys at a face, and the face", M, CONCINO_ALL_VOLUME_KINDS) {
  M m = cn::testing::grid<M>(2);
  std::size_t removed = 0;
  const std::size_t polys = cn::num_polys(m), verts = cn::num_verts(m);
  for (const auto f : M(m).tables().faces().all()) {
    if (!cn::contains(m, f) || cn::is_boundary(m, f)) continue;
    removed += cn::num_elements(cn::adj_f2p(m, f));
    cn::remove_face(m, f);
    CHECK_FALSE(cn::contains(m, f));
    keeps_all_laws(m);
    if (removed > polys / 2) break;
  }
  CHECK(removed > 0);
  CHECK(cn::num_polys(m) == polys - removed);
  CHECK(cn::num_verts(m) == verts);
  CHECK_THROWS_WITH_AS(cn::remove_face(m, cn::face_id{100000}), doctest::Contains("remove_face: face 100000"), cn::invalid_mesh);
}

TEST_CASE("remove_face: a face without polys") {
  cn::polyhedralmesh m;
  for (int i = 0; i < 3; ++i) cn::add_vert(m, {i, i * i, 0});
  const cn::face_id f = cn::add_face(m, {cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}});
  cn::remove_face(m, f);
  CHECK(cn::num_faces(m) + cn::num_edges(m) == 0);
  CHECK(cn::num_verts(m) == 3);
  CHECK_THROWS_AS(cn::remove_face(m, f), cn::invalid_mesh);
}

TEST_CASE_TEMPLATE("remove_unreferenced: a transaction undoes it", M, CONCINO_KINDS) {
  M m = cn::testing::two_grids<M>(1);
  const auto polys = raw(cn::polys(m));
  for (std::size_t i = 0; i < polys.size() / 2; ++i) cn::remove_poly(m, cn::poly_id{polys[i]});
  const auto before = cn::testing::whole(m);
  {
    cn::transaction t(m);
    CHECK(cn::remove_unreferenced(m).verts == 1 + (cn::vert_index_bound(m) - 1) / 2);
    keeps_all_laws(m);
  }
  CHECK(cn::testing::whole(m) == before);
}
