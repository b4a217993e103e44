// OpenMesh meshes with deleted elements, before garbage collection, obey all laws, and rings have only the remaining elements.
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <random>

using namespace concino;
using namespace concino::testing::om;

namespace {

template<class M>
void check_state(const M& m) {
  check_laws_hold<>(m);
  check_rings(m);
  std::size_t live = 0;
  for (unsigned i = 0; i < m.n_vertices(); ++i) {
    const bool is_deleted = m.has_vertex_status() && m.status(m.vertex_handle(i)).deleted();
    live += !is_deleted;
    CHECK(contains(m, m.vertex_handle(i)) == !is_deleted);
  }
  CHECK(num_verts(m) == live);
  CHECK(vert_index_bound(m) == m.n_vertices());
  CHECK(edge_index_bound(m) == m.n_edges());
  CHECK(poly_index_bound(m) == m.n_faces());
}

template<class H>
H any(const auto& range, std::mt19937& random) {
  std::vector<H> all;
  for (const auto x : range) all.push_back(x);
  return all[random() % all.size()];
}

/// Makes one random edit by OpenMesh's own functions.
template<class M>
void edit(M& m, std::mt19937& random) {
  using namespace OpenMesh;
  if (num_polys(m) == 0) return;
  const auto what = random() % 8;
  const bool drop = random() % 2;  // whether verts without edges are deleted too
  if (what < 3) m.delete_face(any<FaceHandle>(polys(m), random), drop);
  else if (what == 3) m.delete_vertex(any<VertexHandle>(verts(m), random), drop);
  else if (what == 4) m.delete_edge(any<EdgeHandle>(edges(m), random), drop);
  else if (what == 5) {
    const HalfedgeHandle h = m.halfedge_handle(any<EdgeHandle>(edges(m), random), random() % 2);
    if constexpr (triangles_only<M>)
      if (m.is_collapse_ok(h)) m.collapse(h);
  } else if (what == 6) {
    // Adds a triangle with a new vert at a boundary edge.
    for (const EdgeHandle e : edges(m)) {
      if (!m.is_boundary(e)) continue;
      const HalfedgeHandle h = m.halfedge_handle(e, m.is_boundary(m.halfedge_handle(e, 0)) ? 0 : 1);
      const VertexHandle v = m.add_vertex({0, 0, 1});
      CHECK(m.add_face(m.from_vertex_handle(h), m.to_vertex_handle(h), v).is_valid());
      break;
    }
  } else if (random() % 4 == 0) {
    m.garbage_collection();
  }
}

}  // namespace

TEST_CASE_TEMPLATE("OpenMesh: laws hold after any edits", M, CONCINO_FIRST_OF(tri_status, poly_status)) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    M m;
    fill(m, two_grids<M>(2));
    for (int step = 0; step < 12; ++step) {
      edit(m, random);
      check_state(m);
    }
  }
}

TEST_CASE("OpenMesh: laws hold if everything is deleted, and after garbage collection") {
  poly_double m;  // its status attributes are not requested yet
  fill(m, two_grids<poly_double>(2));
  m.request_vertex_status();
  m.request_edge_status();
  m.request_face_status();
  for (unsigned i = 0; i < m.n_vertices(); ++i) m.delete_vertex(m.vertex_handle(i), false);
  check_state(m);
  CHECK(num_verts(m) == 0);
  CHECK(num_edges(m) == 0);
  CHECK(num_polys(m) == 0);
  m.garbage_collection();
  CHECK(vert_index_bound(m) == 0);
  check_state(m);
}

TEST_CASE("OpenMesh: edges without status attributes are deleted with their last face") {
  poly_double m;
  fill(m, two_grids<poly_double>(2));
  m.request_face_status();
  for (const unsigned i : {0u, 3u, 7u}) {
    m.delete_face(m.face_handle(i), false);
    check_state(m);
  }
  CHECK(num_edges(m) < m.n_edges());
}

TEST_CASE("OpenMesh: elements with the status hidden are elements of the mesh") {
  poly_status m;
  fill(m, two_grids<poly_status>(2));
  m.status(m.vertex_handle(0)).set_hidden(true);
  m.status(m.face_handle(0)).set_hidden(true);
  CHECK(num_verts(m) == m.n_vertices());
  check_state(m);
}

TEST_CASE("OpenMesh: a vert may have several fans, from the start or after deletion") {
  poly_status m;
  fill(m, {std::vector<vec3>(7), {}, {}, 3});
  for (const unsigned i : {1u, 3u, 5u}) m.add_face(m.vertex_handle(0), m.vertex_handle(i), m.vertex_handle(i + 1));
  CHECK(!m.is_manifold(m.vertex_handle(0)));
  check_state(m);
  m.delete_face(m.face_handle(1), false);
  check_state(m);

  poly_status grid;
  fill(grid, testing::quad_grid(4));
  const OpenMesh::VertexHandle middle = grid.vertex_handle(12);
  const std::vector<OpenMesh::FaceHandle> around(grid.vf_begin(middle), grid.vf_end(middle));
  grid.delete_face(around[0], false);
  grid.delete_face(around[2], false);
  CHECK(!grid.is_manifold(middle));
  check_state(grid);
}
