// add_vert, add_poly and the other verbs that edit work on OpenMesh meshes.
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <concino/edit.hpp>

#include <random>

using namespace concino;
using namespace concino::testing::om;
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

static_assert(requirement::has_add_vert<only_one> && requirement::has_remove_vert<only_one>);
static_assert(requirement::has_add_poly<only_one> && requirement::has_remove_poly<only_one>);
static_assert(!requirement::has_add_vert<tri_planar> && requirement::has_add_poly<tri_planar>);

TEST_CASE_TEMPLATE("OpenMesh: set_point converts to the point type of the mesh", M, CONCINO_FIRST_OF(only_one, tri_own, poly_eigen)) {
  M m;
  const VertexHandle v = add_vert(m, {1, 2, 0.1});
  set_point(m, v, std::array{3, 4, 5});
  CHECK(to_vec3(point(m, v)) == vec3{3, 4, 5});
  set_point(m, v, vec3{0.1, 0, 0});
  CHECK(m.point(v)[0] == static_cast<typename M::Scalar>(0.1));
}

TEST_CASE_TEMPLATE("OpenMesh: a mesh can be built and removed, with or without status attributes", M, CONCINO_FIRST_OF(only_one, poly_double)) {
  const surface_arrays s = testing::with_offsets(testing::triangle_grid(3));
  M m;
  for (const vec3& x : s.points) add_vert(m, x);
  for (std::size_t p = 0; p + 1 < s.offsets.size(); ++p) {
    std::vector<VertexHandle> corners;
    for (std::size_t i = s.offsets[p]; i < s.offsets[p + 1]; ++i) corners.push_back(m.vertex_handle(s.verts[i].raw()));
    const FaceHandle f = add_poly(m, std::span<const VertexHandle>(corners));
    CHECK(index_of(m, f) == p);
  }
  check_laws_hold<>(m);
  check_rings(m);

  std::mt19937 random(7);
  while (num_polys(m) > 0) {
    std::vector<FaceHandle> all;
    for (const FaceHandle f : polys(m)) all.push_back(f);
    const FaceHandle f = all[random() % all.size()];
    const auto before = num_polys(m);
    remove_poly(m, f);
    CHECK(num_polys(m) == before - 1);
    CHECK(!contains(m, f));
    CHECK_THROWS_AS(remove_poly(m, f), invalid_mesh);
    if (random() % 4 == 0 && num_verts(m) > 1) {
      const VertexHandle v = *verts(m).begin();
      remove_vert(m, v);
      CHECK(!contains(m, v));
      CHECK_THROWS_AS(remove_vert(m, v), invalid_mesh);
    }
    check_laws_hold<>(m);
    check_rings(m);
  }
  CHECK(num_edges(m) == 0);
  CHECK(num_verts(m) > 0);
  m.garbage_collection();
  CHECK(vert_index_bound(m) == num_verts(m));
}

TEST_CASE("OpenMesh: polys that OpenMesh cannot hold throw, and the mesh is unchanged") {
  only_one m;
  fill(m, testing::triangle_grid(2));
  const auto v = [&](unsigned i) { return m.vertex_handle(i); };
  const VertexHandle extra = add_vert(m, {0, 0, 1}), gone = add_vert(m, {0, 0, 2});
  remove_vert(m, gone);
  const auto refused = [&](std::initializer_list<VertexHandle> corners, const char* why) {
    const auto edge_count = m.n_edges(), poly_count = m.n_faces();
    std::string said;
    try {
      add_poly(m, corners);
    } catch (const invalid_mesh& e) {
      said = e.what();
    }
    CHECK(said == "add_poly: poly 8 " + std::string(why));
    CHECK(m.n_edges() == edge_count);
    CHECK(m.n_faces() == poly_count);
    check_laws_hold<>(m);
  };
  refused({v(0), v(1)}, "has 2 verts; it needs 3");
  refused({v(0), v(1), extra, v(2)}, "has 4 verts; it needs 3");
  refused({v(0), extra, v(0)}, "has vert 0 twice; its verts must differ");
  refused({v(0), extra, gone}, "names vert 10, which is not in the mesh");
  refused({v(0), extra, VertexHandle()}, "names vert -1, which is not in the mesh");
  refused({v(4), v(1), extra}, "names vert 4, which is not on the boundary; OpenMesh cannot add a poly there");
  refused({v(0), v(1), extra},
          "goes from vert 0 to vert 1 as another poly does; in OpenMesh at most two polys share an edge, in opposite directions");
  CHECK(index_of(m, add_poly(m, {v(1), v(0), extra})) == 8);
  check_laws_hold<>(m);

  poly_double p;
  fill(p, testing::quad_grid(1));
  CHECK_THROWS_AS(add_poly(p, {p.vertex_handle(0), p.vertex_handle(1)}), invalid_mesh);
}

TEST_CASE("OpenMesh: closing the fan at a vert throws if the vert has another fan") {
  poly_double m;
  for (int i = 0; i < 7; ++i) add_vert(m, {i, 0, 0});
  const auto v = [&](unsigned i) { return m.vertex_handle(i); };
  add_poly(m, {v(0), v(1), v(2)});
  add_poly(m, {v(0), v(2), v(3)});
  add_poly(m, {v(0), v(4), v(5)});
  check_laws_hold<>(m);
  CHECK_THROWS_WITH_AS(add_poly(m, {v(0), v(3), v(1)}),
                       "add_poly: poly 3 closes a fan of polys around vert 0, which has polys of another fan too; in OpenMesh a closed fan is the only one at its vert",
                       invalid_mesh);
  check_laws_hold<>(m);
  CHECK(num_polys(m) == 3);
  // A poly that joins both fans can be added.
  add_poly(m, {v(0), v(5), v(1)});
  check_laws_hold<>(m);
  check_rings(m);
}

TEST_CASE("OpenMesh: polys are added in any order, or throw without a change, and can be removed") {
  std::mt19937 random(3);
  int taken = 0, refused = 0, removed = 0;
  for (int round = 0; round < 60; ++round) {
    poly_double m;
    for (int i = 0; i < 7; ++i) add_vert(m, {i, i * i, 0});
    for (int i = 0; i < 25; ++i) {
      if (const FaceHandle f(static_cast<int>(random() % 32)); contains(m, f)) {
        remove_poly(m, f);
        ++removed;
      }
      std::vector<VertexHandle> corners;
      for (unsigned k = 0; k < 3 + random() % 2; ++k) corners.push_back(m.vertex_handle(static_cast<unsigned>(random() % 7)));
      const auto edge_count = m.n_edges(), poly_count = m.n_faces();
      try {
        add_poly(m, std::span<const VertexHandle>(corners));
        ++taken;
      } catch (const invalid_mesh&) {
        ++refused;
        CHECK(m.n_edges() == edge_count);
        CHECK(m.n_faces() == poly_count);
      }
    }
    check_laws_hold<>(m);
    check_rings(m);
  }
  CHECK(taken > 200);
  CHECK(refused > 200);
  CHECK(removed > 50);
}

TEST_CASE("OpenMesh: properties follow their elements") {
  only_one m;
  fill(m, testing::triangle_grid(1));
  OpenMesh::VPropHandleT<double> h;
  m.add_property(h);
  const VertexHandle v = add_vert(m, {0, 0, 1});
  m.property(h, v) = 5;
  remove_poly(m, m.face_handle(0));
  CHECK(m.property(h, v) == 5);
}
