// Views accept matrices of every layout, and polygons and polyhedra; their errors name the poly.
#include <concino/adapters/eigen.hpp>

#include <support/eigen_arrays.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;
using Eigen::Dynamic;

namespace {

using V = Eigen::MatrixXd;
using F = Eigen::MatrixXi;

template<class Case> std::string message(Case&& f) {
  try {
    f();
  } catch (const invalid_mesh& e) {
    return e.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("eigen: views of polygons and polyhedra accept column, row and strided vectors") {
  const auto a = two_grids_arrays<polygonmesh>(2);
  const V points = points_of<V>(a);
  const auto offsets = vector_of<int>(a.offsets);
  const auto indices = vector_of<std::int64_t, Eigen::RowMajor>(raws<std::uint32_t>(a.verts));
  check_same_mesh(view_polygons(points, offsets, indices), polygonmesh(a));
  Eigen::MatrixXi wide(indices.size(), 3);
  wide.setConstant(-1);
  wide.col(1) = indices.transpose().cast<int>();
  const auto column = wide.col(1);
  check_same_mesh(view_polygons(points, offsets, column), polygonmesh(a));
  const Eigen::VectorXi no_offsets, no_indices;
  CHECK(num_polys(view_polygons(points, no_offsets, no_indices)) == 0);

  const auto b = two_grids_arrays<polyhedralmesh>(2);
  const V corners = points_of<V>(b);
  const auto face_offsets = vector_of<unsigned>(b.face_offsets), face_verts = vector_of<unsigned>(raws<std::uint32_t>(b.face_verts));
  const auto poly_offsets = vector_of<short>(b.poly_offsets);
  Eigen::VectorXi poly_faces = vector_of<int>(raws<std::uint32_t>(b.poly_faces));
  Eigen::ArrayX<bool> outward(poly_faces.size());
  for (Eigen::Index k = 0; k < outward.size(); ++k) outward(k) = b.outward[static_cast<std::size_t>(k)] != 0;
  check_same_mesh(view_polyhedra(corners, face_offsets, face_verts, poly_offsets, poly_faces, outward), polyhedralmesh(b));
  for (Eigen::Index k = 0; k < outward.size(); ++k)
    if (!outward(k)) poly_faces(k) = ~poly_faces(k);
  check_same_mesh(view_polyhedra(corners, face_offsets, face_verts, poly_offsets, poly_faces), polyhedralmesh(b));
}

TEST_CASE("eigen: views accept maps, references, blocks, transposes and derived classes") {
  const auto a = grid_arrays<trimesh>(2);
  const trimesh native(a);
  const V points = points_of<V>(a);
  const F lists = polys_of<F>(a, 3);
  const Eigen::Matrix3Xd lying = points.transpose();
  const Eigen::Matrix<unsigned char, 3, Dynamic> lying_polys = lists.transpose().cast<unsigned char>();
  const auto standing = lying.transpose();
  const auto standing_polys = lying_polys.transpose();
  check_same_mesh(view_tri(standing, standing_polys), native);

  V wide = V::Constant(points.rows() + 2, 6, 7.0);
  wide.block(1, 2, points.rows(), 3) = points;
  const auto block = wide.block(1, 2, points.rows(), 3);
  auto view = view_tri(block, lists);
  static_assert(!MutablePoints<decltype(view)>);
  check_same_mesh(view, native);
  auto open_block = wide.block(1, 2, points.rows(), 3);
  auto open = view_tri(open_block, lists);
  set_point(open, vert_id{4}, vec3{1, 2, 3});
  CHECK((wide.row(5) - Eigen::RowVectorXd::Map(std::vector<double>{7, 7, 1, 2, 3, 7}.data(), 6)).norm() == 0);
  const Eigen::Ref<const V> ref = points;
  check_same_mesh(view_tri(ref, Eigen::Map<const F>(lists.data(), lists.rows(), 3)), native);
  cloud mine(points.rows(), 3);
  mine.topRows(points.rows()) = points;
  check_same_mesh(view_tri(mine, lists), native);

  const Eigen::MatrixX2d flat = points.leftCols(2);  // the grid is planar
  auto in_plane = view_tri(flat, lists);
  static_assert(Embedded<decltype(in_plane)> && !MutablePoints<decltype(view_tri(std::declval<Eigen::MatrixX2d&>(), lists))>);
  check_same_mesh(in_plane, native);

  const Eigen::Matrix3d corner = Eigen::Matrix3d::Identity();
  const Eigen::Matrix<int, 1, 3> one(2, 0, 1);
  CHECK(adj_p2v(view_tri(corner, one), poly_id{0})[0] == vert_id{2});
}

TEST_CASE("eigen: errors name the poly, the index and the bound") {
  const V points = V::Zero(4, 3);
  F lists(2, 3);
  lists << 0, 1, 2, 0, 2, 3;
  lists(1, 1) = -3;
  CHECK(message([&] { view_tri(points, lists); }) == "view_tri: poly 1 names point -3, but there are 4 points, numbered from 0");
  lists(1, 1) = 4;
  CHECK(message([&] { view_tri(points, lists); }) == "view_tri: poly 1 names point 4, but there are 4 points, numbered from 0");
  Eigen::Matrix<std::int64_t, 1, 4> huge(0, 1, 2, (std::int64_t{1} << 32) + 3);  // this is 3 if it is truncated to 32 bits
  CHECK(message([&] { view_tet(points, huge); }) == "view_tet: poly 0 names point 4294967299, but there are 4 points, numbered from 0");
  huge[3] = std::numeric_limits<std::int64_t>::min();
  CHECK(message([&] { view_quad(points, huge); }) == "view_quad: poly 0 names point -9223372036854775808, but there are 4 points, numbered from 0");
  lists(1, 1) = 3;
  CHECK(message([&] { view_tri(points, lists); }) == "surface_tables: poly 1 has vert 3 twice; its verts must differ");
  const F quads = F::Zero(2, 4);
  CHECK(message([&] { view_tri(points, quads); }) == "view_tri: the array of polys has 4 columns; it needs 3");
  const V flat = V::Zero(4, 2);
  CHECK(message([&] { view_tri(flat, lists); }) ==
        "view_tri: the array of points has 2 columns; it needs 3, or a type with 2 columns such as Eigen::MatrixX2d");
  const V none;
  const F nothing;
  CHECK(num_verts(view_tri(none, nothing)) == 0);

  Eigen::VectorXi offsets(2), indices(3);
  offsets << 0, 3;
  indices << 0, 1, 2;
  const auto polygons = [&] { view_polygons(points, offsets, indices); };
  CHECK(message(polygons) == "none");
  offsets << 1, 3;
  CHECK(message(polygons) == "view_polygons: the offsets of polys begin with 1; they must begin with 0");
  offsets << 0, 4;
  CHECK(message(polygons) == "view_polygons: the offsets of polys have 4 at position 1, but there are 3 indices");
  offsets << 0, -1;
  CHECK(message(polygons) == "view_polygons: the offsets of polys have -1 at position 1, but there are 3 indices");
  offsets << 0, 2;
  CHECK(message(polygons) == "view_polygons: the offsets of polys end with 2, but there are 3 indices");
  offsets = Eigen::VectorXi(3);
  offsets << 0, 3, 2;
  CHECK(message(polygons) == "view_polygons: the offsets of polys decrease at position 2, from 3 to 2");
  offsets << 0, 1, 3;
  CHECK(message(polygons) == "surface_tables: poly 0 has 1 verts; it needs at least 3");
  offsets = Eigen::VectorXi(0);
  CHECK(message(polygons) == "view_polygons: the offsets of polys end with 0, but there are 3 indices");

  Eigen::VectorXi face_offsets(2), poly_offsets(2), poly_faces(1);
  face_offsets << 0, 3;
  poly_offsets << 0, 1;
  poly_faces << 0;
  Eigen::VectorXi outward(1);
  outward << 1;
  const auto polyhedra = [&] { view_polyhedra(points, face_offsets, indices, poly_offsets, poly_faces, outward); };
  const auto with_signs = [&] { view_polyhedra(points, face_offsets, indices, poly_offsets, poly_faces); };
  CHECK(message(polyhedra) == "none");
  CHECK(message(with_signs) == "none");
  poly_faces << -1;
  CHECK(message(polyhedra) == "view_polyhedra: poly 0 names face -1, but there are 1 faces, numbered from 0");
  CHECK(message(with_signs) == "none");
  poly_faces << -2;
  CHECK(message(with_signs) == "view_polyhedra: poly 0 names face 1, but there are 1 faces, numbered from 0");
  poly_faces << 0;
  outward = Eigen::VectorXi(2);
  CHECK(message(polyhedra) == "view_polyhedra: 2 outward flags were given for 1 faces of polys; each needs one");
  indices << 0, 1, 9;
  CHECK(message(with_signs) == "view_polyhedra: face 0 names point 9, but there are 4 points, numbered from 0");
  indices << 0, 1, 2;
  poly_offsets << 0, 0;
  CHECK(message(with_signs) == "view_polyhedra: the offsets of polys end with 0, but there are 1 indices");
}
