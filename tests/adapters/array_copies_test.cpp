// Views of arrays do not copy the arrays: a view takes less memory than a native mesh, and its results change with the arrays.
#include <concino/adapters/eigen.hpp>
#include <concino/adapters/span.hpp>
#include <concino/render/scene.hpp>

#include <support/allocations.hpp>
#include <support/input_arrays.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>

#include <malloc.h>

using namespace concino;
using namespace concino::testing;

namespace {

std::size_t bytes_now() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// The memory that an object still uses after its construction.
template<class F>
std::size_t bytes_of(F&& make) {
  const std::size_t before = bytes_now();
  const auto made = make();
  return bytes_now() - before;
}

/// Checks that `view` takes less memory than `mesh`, by the size of the arrays that stay with the user, up to a few pages.
template<class Mesh, class View>
void check_no_copy(const Mesh& mesh, const View& view, std::size_t left_with_user) {
  const std::size_t whole = bytes_of(mesh), part = bytes_of(view);
  if (whole == 0) {
    MESSAGE("not measured: this allocator does not report its memory");
    return;
  }
  INFO(part << " + " << left_with_user << " beside " << whole);
  CHECK(part + left_with_user < whole + 65536);
  CHECK(left_with_user > 500000);
}

template<class T> using rows_of = Eigen::Matrix<T, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A sum over all elements and adjacencies of a mesh, so that the compiler does not remove the loops.
template<class M>
double walked(const M& m) {
  double sum = 0;
  for (const auto v : verts(m)) {
    sum += point(m, v)[0];
    for (const auto w : adj_v2v(m, v)) sum += w.raw();
    for (const auto p : adj_v2p(m, v)) sum += p.raw();
  }
  for (const auto p : polys(m)) {
    for (const auto v : adj_p2v(m, p)) sum += v.raw();
    for (const auto e : adj_p2e(m, p)) sum += e.raw();
    for (const auto q : adj_p2p(m, p)) sum += q.raw();
  }
  return sum;
}

}  // namespace

TEST_CASE("arrays: a view takes the memory of a native mesh minus points and lists") {
  const auto tris = grid_arrays<trimesh>(150);
  const auto xyz = coordinates<double>(tris.points);
  const auto corners = raws<int>(tris.verts);
  const Eigen::Map<const rows_of<double>> V(xyz.data(), static_cast<Eigen::Index>(tris.points.size()), 3);
  const Eigen::MatrixXi F = Eigen::Map<const rows_of<int>>(corners.data(), static_cast<Eigen::Index>(tris.num_polys()), 3);
  const std::size_t points = tris.points.size() * sizeof(vec3);
  check_no_copy([&] { return trimesh(tris); }, [&] { return view_tri(xyz, corners); }, points + corners.size() * 4);
  check_no_copy([&] { return trimesh(tris); }, [&] { return view_tri(V, F); }, points + corners.size() * 4);

  const auto polygons = grid_arrays<polygonmesh>(100);
  const auto indices = raws<int>(polygons.verts);
  check_no_copy([&] { return polygonmesh(polygons); }, [&] { return view_polygons(polygons.points, polygons.offsets, indices); },
                polygons.points.size() * sizeof(vec3) + indices.size() * 4);

  const auto tets = grid_arrays<tetmesh>(16);
  const auto tet_corners = raws<int>(tets.verts);
  check_no_copy([&] { return tetmesh(tets); }, [&] { return view_tet(tets.points, tet_corners); },
                tets.points.size() * sizeof(vec3) + tet_corners.size() * 4);

  const auto polyhedra = grid_arrays<polyhedralmesh>(16);
  const auto face_verts = raws<int>(polyhedra.face_verts), poly_faces = raws<int>(polyhedra.poly_faces);
  check_no_copy([&] { return polyhedralmesh(polyhedra); },
                [&] {
                  return view_polyhedra(polyhedra.points, polyhedra.face_offsets, face_verts, polyhedra.poly_offsets, poly_faces,
                                        polyhedra.outward);
                },
                polyhedra.points.size() * sizeof(vec3) + face_verts.size() * 4);
}

TEST_CASE("arrays: iterating over a view and copying it allocate no memory") {
  const auto tris = grid_arrays<trimesh>(20);
  const Eigen::MatrixXd V = Eigen::MatrixXd::Random(static_cast<Eigen::Index>(tris.points.size()), 3);
  const auto corners = raws<long>(tris.verts);
  const auto view = view_tri(V, corners);
  double sum = 0;
  CHECK(allocated_by([&] { sum = walked(view); }) == allocations{});
  CHECK(allocated_by([&] {
          const auto copy = view;
          sum -= walked(copy);
        }) == allocations{});
  CHECK(sum == 0);
}

TEST_CASE("arrays: a picture of a view takes as much memory as that of a native mesh") {
  const auto tris = grid_arrays<trimesh>(40);
  const trimesh native(tris);
  const auto corners = raws<int>(tris.verts);
  const auto view = view_tri(tris.points, corners);
  const with_num_threads alone(1);  // threads that help in a loop allocate
  CHECK(allocated_by([&] { scene().add(view); }) == allocated_by([&] { scene().add(native); }));
}

TEST_CASE("arrays: the verts of polys and faces are read from the user's array") {
  auto tris = grid_arrays<trimesh>(2);
  auto corners = raws<int>(tris.verts);
  const auto m = view_tri(tris.points, corners);
  const vert_id second{corners[1]};
  std::rotate(corners.begin(), corners.begin() + 1, corners.begin() + 3);  // users must not do this
  CHECK(*adj_p2v(m, poly_id{0}).begin() == second);
  corners = std::vector<int>(corners);
  CHECK(*adj_p2v(m, poly_id{0}).begin() == second);

  const auto solid = grid_arrays<polyhedralmesh>(1);
  auto face_verts = raws<short>(solid.face_verts);
  const auto poly_faces = raws<short>(solid.poly_faces);
  const auto w = view_polyhedra(solid.points, solid.face_offsets, face_verts, solid.poly_offsets, poly_faces, solid.outward);
  const vert_id next{face_verts[1]};
  std::rotate(face_verts.begin(), face_verts.begin() + 1, face_verts.begin() + static_cast<std::ptrdiff_t>(solid.face_offsets[1]));
  CHECK(*adj_f2v(w, face_id{0}).begin() == next);
}
