#include <concino/adapters/eigen.hpp>

#include <concino/edit/elements.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/given_arrays.hpp>
#include <support/models.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

using namespace concino;
using namespace concino::testing;
using Eigen::Dynamic;

namespace {

template<class Matrix>
Matrix rows(const std::vector<double>& values, int width) {
  Matrix m(static_cast<Eigen::Index>(values.size()) / width, width);
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (int k = 0; k < width; ++k) m(i, k) = static_cast<typename Matrix::Scalar>(values[static_cast<std::size_t>(i * width + k)]);
  return m;
}
template<class V, class Arrays>
V points_of(const Arrays& a) { return rows<V>(coordinates<double>(a.points), 3); }
template<class F, class Arrays>
F polys_of(const Arrays& a, int arity) { return rows<F>(raws<double>(a.verts), arity); }
template<class I, int Options = Eigen::ColMajor>
auto vector_of(const std::vector<std::uint32_t>& x) {
  Eigen::Matrix<I, Options == Eigen::RowMajor ? 1 : Dynamic, Options == Eigen::RowMajor ? Dynamic : 1, Options> v(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) v(static_cast<Eigen::Index>(i)) = static_cast<I>(x[i]);
  return v;
}

template<class V, class F>
struct layout {
  using points = V;
  using polys = F;
};
using by_columns = layout<Eigen::MatrixXd, Eigen::MatrixXi>;
using by_rows = layout<Eigen::Matrix<float, Dynamic, 3, Eigen::RowMajor>, Eigen::Array<std::int64_t, Dynamic, Dynamic, Eigen::RowMajor>>;

template<class Case> std::string message(Case&& f) {
  try {
    f();
  } catch (const invalid_mesh& e) {
    return e.what();
  }
  return "none";
}

template<class V, class F> concept makes_tri = requires(V&& v, F&& f) { view_tri(static_cast<V&&>(v), static_cast<F&&>(f)); };
using V = Eigen::MatrixXd;
using F = Eigen::MatrixXi;
using tri_of = decltype(view_tri(std::declval<V&>(), std::declval<F&>()));

/// A matrix of the user's.
struct cloud : Eigen::MatrixXd {
  using Eigen::MatrixXd::MatrixXd;
  std::string name;
};

}  // namespace

static_assert(models_in_all_forms<tri_of>(surface | embedded | mutable_points | fixed_arity));
static_assert(models_in_all_forms<decltype(view_quad(std::declval<const V&>(), std::declval<F&>()))>(surface | embedded | fixed_arity));
static_assert(models_in_all_forms<decltype(view_tet(std::declval<V&>(), std::declval<F&>()))>(concino::testing::volume | embedded | mutable_points | fixed_arity));
static_assert(TriMesh<tri_of> && HexMesh<decltype(view_hex(std::declval<V&>(), std::declval<F&>()))> && is_view_v<tri_of>);

// Temporaries are refused, unless they only point to what somebody else keeps. So are what is no row of three, and what is no index.
static_assert(makes_tri<V&, F&> && makes_tri<const V&, const F&> && makes_tri<cloud&, F&>);
static_assert(!makes_tri<V, F&> && !makes_tri<V&, F> && !makes_tri<const V, F&> && !makes_tri<cloud, F&>);
static_assert(makes_tri<Eigen::Map<V>, Eigen::Map<const F>> && makes_tri<Eigen::Ref<V>, Eigen::Ref<F>> && makes_tri<const Eigen::Ref<const V>&, F&>);
static_assert(!makes_tri<Eigen::Ref<const V>, F&> && !makes_tri<decltype(std::declval<V&>().leftCols(3)), F&>);
static_assert(makes_tri<decltype(std::declval<V&>().leftCols(3))&, F&> && makes_tri<decltype(std::declval<V&>().transpose())&, F&>);
static_assert(!makes_tri<decltype(std::declval<V&>() + std::declval<V&>())&, F&> && !makes_tri<decltype(V::Zero(3, 3))&, F&>);
static_assert(!makes_tri<V&, V&> && !makes_tri<F&, F&> && !makes_tri<Eigen::MatrixXcd&, F&> && !makes_tri<V&, Eigen::Matrix<bool, Dynamic, 3>&>);
static_assert(!makes_tri<V&, Eigen::MatrixX4i&> && !makes_tri<Eigen::MatrixX4d&, F&> && !makes_tri<Eigen::VectorXd&, F&> && !makes_tri<int&, F&>);

TEST_CASE_TEMPLATE("eigen: views of triangles, quads, tets and hexes are the native meshes of the same arrays", L, by_columns, by_rows) {
  const auto compare = [](auto kind, int arity, const auto& view) {
    using M = decltype(kind);
    for (const auto& arrays : {grid_arrays<M>(2), two_grids_arrays<M>(1), decltype(grid_arrays<M>(1)){}}) {
      auto a = arrays;
      a.arity = static_cast<std::uint32_t>(arity);
      const auto points = points_of<typename L::points>(a);
      const auto lists = polys_of<typename L::polys>(a, arity);
      check_same_mesh(view(points, lists), M(a));
    }
  };
  compare(trimesh(), 3, [](const auto& v, const auto& f) { return view_tri(v, f); });
  compare(quadmesh(), 4, [](const auto& v, const auto& f) { return view_quad(v, f); });
  compare(tetmesh(), 4, [](const auto& v, const auto& f) { return view_tet(v, f); });
  compare(hexmesh(), 8, [](const auto& v, const auto& f) { return view_hex(v, f); });
}

TEST_CASE("eigen: views of polygons and polyhedra, in vectors that stand, lie or leave gaps") {
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

TEST_CASE("eigen: matrices of other shapes, maps, references, blocks, transposes, classes of the user's") {
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

  const Eigen::MatrixX2d flat = points.leftCols(2);  // the grid lies in the plane
  auto in_plane = view_tri(flat, lists);
  static_assert(Embedded<decltype(in_plane)> && !MutablePoints<decltype(view_tri(std::declval<Eigen::MatrixX2d&>(), lists))>);
  check_same_mesh(in_plane, native);

  const Eigen::Matrix3d corner = Eigen::Matrix3d::Identity();
  const Eigen::Matrix<int, 1, 3> one(2, 0, 1);
  CHECK(adj_p2v(view_tri(corner, one), poly_id{0})[0] == vert_id{2});
}

TEST_CASE("eigen: the coordinates are the user's") {
  V points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  F lists(2, 3);
  lists << 0, 1, 2, 0, 2, 3;
  auto m = view_tri(points, lists);
  const vert_id v{2};
  points(2, 2) = 5;
  CHECK(point(m, v) == vec3{1, 1, 5});
  set_point(m, v, vec3{7, 8, 9});
  CHECK(points.row(2) == Eigen::RowVector3d(7, 8, 9));
  points = V::Ones(4, 3);  // another piece of memory, moved in
  CHECK(point(m, v) == vec3{1, 1, 1});
  Eigen::MatrixXf floats = points.cast<float>();
  auto n = view_tri(floats, lists);
  set_point(n, v, vec3{0.5, 0.1, 0});
  CHECK(floats(2, 1) == 0.1f);
  CHECK(point(n, v)[1] == static_cast<double>(0.1f));
}

TEST_CASE("eigen: views are copied cheaply, and maps and views of views keep a copy") {
  const auto a = grid_arrays<tetmesh>(2);
  const V points = points_of<V>(a);
  const F lists = polys_of<F>(a, 4);
  auto height = make_vert_map<double>(view_tet(points, lists), 1.0);
  CHECK(height[vert_id{3}] == 1.0);
  const auto skin = boundary(view_tet(points, lists));
  CHECK(check_laws(skin).empty());
  auto copy = view_tet(points, lists);
  const auto original = copy;
  copy = original;
  CHECK(&copy.tables() == &original.tables());
  const auto d = dijkstra(view_tet(points, lists), vert_id{0});
  CHECK(d[vert_id{0}] == 0);
}

TEST_CASE("eigen: errors name the poly, the index and the bound") {
  const V points = V::Zero(4, 3);
  F lists(2, 3);
  lists << 0, 1, 2, 0, 2, 3;
  lists(1, 1) = -3;
  CHECK(message([&] { view_tri(points, lists); }) == "view_tri: poly 1 names point -3, but there are 4 points, numbered from 0");
  lists(1, 1) = 4;
  CHECK(message([&] { view_tri(points, lists); }) == "view_tri: poly 1 names point 4, but there are 4 points, numbered from 0");
  Eigen::Matrix<std::int64_t, 1, 4> huge(0, 1, 2, (std::int64_t{1} << 32) + 3);  // 3, once it is cut to 32 bits
  CHECK(message([&] { view_tet(points, huge); }) == "view_tet: poly 0 names point 4294967299, but there are 4 points, numbered from 0");
  huge[3] = std::numeric_limits<std::int64_t>::min();
  CHECK(message([&] { view_quad(points, huge); }) == "view_quad: poly 0 names point -9223372036854775808, but there are 4 points, numbered from 0");
  lists(1, 1) = 3;
  CHECK(message([&] { view_tri(points, lists); }) == "poly 1 has vert 3 twice; its verts must differ");
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
  CHECK(message(polygons) == "view_polygons: the offsets of polys have 4 at place 1, but there are 3 indices");
  offsets << 0, -1;
  CHECK(message(polygons) == "view_polygons: the offsets of polys have -1 at place 1, but there are 3 indices");
  offsets << 0, 2;
  CHECK(message(polygons) == "view_polygons: the offsets of polys end with 2, but there are 3 indices");
  offsets = Eigen::VectorXi(3);
  offsets << 0, 3, 2;
  CHECK(message(polygons) == "view_polygons: the offsets of polys decrease at place 2, from 3 to 2");
  offsets << 0, 1, 3;
  CHECK(message(polygons) == "poly 0 has 1 verts; it needs at least 3");
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
  CHECK(message(polyhedra) == "view_polyhedra: 2 outward flags were given for 1 faces of polys");
  indices << 0, 1, 9;
  CHECK(message(with_signs) == "view_polyhedra: face 0 names point 9, but there are 4 points, numbered from 0");
  indices << 0, 1, 2;
  poly_offsets << 0, 0;
  CHECK(message(with_signs) == "view_polyhedra: the offsets of polys end with 0, but there are 1 indices");
}
