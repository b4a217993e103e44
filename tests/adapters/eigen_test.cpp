#include <concino/adapters/eigen.hpp>

#include <concino/graph/dijkstra.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/eigen_arrays.hpp>
#include <support/kinds.hpp>
#include <support/models.hpp>

#include <doctest/doctest.h>

#include <cstdint>

using namespace concino;
using namespace concino::testing;
using Eigen::Dynamic;

namespace {

template<class V, class F>
struct layout {
  using points = V;
  using polys = F;
};
using by_columns = layout<Eigen::MatrixXd, Eigen::MatrixXi>;
using by_rows = layout<Eigen::Matrix<float, Dynamic, 3, Eigen::RowMajor>, Eigen::Array<std::int64_t, Dynamic, Dynamic, Eigen::RowMajor>>;

template<class V, class F> concept makes_tri = requires(V&& v, F&& f) { view_tri(static_cast<V&&>(v), static_cast<F&&>(f)); };
using V = Eigen::MatrixXd;
using F = Eigen::MatrixXi;
using tri_of = decltype(view_tri(std::declval<V&>(), std::declval<F&>()));

}  // namespace

static_assert(models_in_all_forms<tri_of>(surface | embedded | mutable_points | fixed_arity));
static_assert(models_in_all_forms<decltype(view_quad(std::declval<const V&>(), std::declval<F&>()))>(surface | embedded | fixed_arity));
static_assert(models_in_all_forms<decltype(view_tet(std::declval<V&>(), std::declval<F&>()))>(concino::testing::volume | embedded | mutable_points | fixed_arity));
static_assert(TriMesh<tri_of> && HexMesh<decltype(view_hex(std::declval<V&>(), std::declval<F&>()))> && is_view_v<tri_of>);

// Temporaries are rejected, unless they only refer to memory of others. Rows of other than three numbers and indices that are no integers are rejected.
static_assert(makes_tri<V&, F&> && makes_tri<const V&, const F&> && makes_tri<cloud&, F&>);
static_assert(!makes_tri<V, F&> && !makes_tri<V&, F> && !makes_tri<const V, F&> && !makes_tri<cloud, F&>);
static_assert(makes_tri<Eigen::Map<V>, Eigen::Map<const F>> && makes_tri<Eigen::Ref<V>, Eigen::Ref<F>> && makes_tri<const Eigen::Ref<const V>&, F&>);
static_assert(!makes_tri<Eigen::Ref<const V>, F&> && !makes_tri<decltype(std::declval<V&>().leftCols(3)), F&>);
static_assert(makes_tri<decltype(std::declval<V&>().leftCols(3))&, F&> && makes_tri<decltype(std::declval<V&>().transpose())&, F&>);
static_assert(!makes_tri<decltype(std::declval<V&>() + std::declval<V&>())&, F&> && !makes_tri<decltype(V::Zero(3, 3))&, F&>);
static_assert(!makes_tri<V&, V&> && !makes_tri<F&, F&> && !makes_tri<Eigen::MatrixXcd&, F&> && !makes_tri<V&, Eigen::Matrix<bool, Dynamic, 3>&>);
static_assert(!makes_tri<V&, Eigen::MatrixX4i&> && !makes_tri<Eigen::MatrixX4d&, F&> && !makes_tri<Eigen::VectorXd&, F&> && !makes_tri<int&, F&>);

TEST_CASE_TEMPLATE("eigen: views of triangles, quads, tets and hexes equal the native meshes", L, CONCINO_FIRST_OF(by_columns, by_rows)) {
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
  compare(tetmesh(), 4, [](const auto& v, const auto& f) { return view_tet(v, f); });
  if constexpr (std::same_as<L, by_columns>) {
    compare(quadmesh(), 4, [](const auto& v, const auto& f) { return view_quad(v, f); });
    compare(hexmesh(), 8, [](const auto& v, const auto& f) { return view_hex(v, f); });
  }
}

TEST_CASE("eigen: views refer to the user's coordinates") {
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
  points = V::Ones(4, 3);  // moved in from other memory
  CHECK(point(m, v) == vec3{1, 1, 1});
  Eigen::MatrixXf floats = points.cast<float>();
  auto n = view_tri(floats, lists);
  set_point(n, v, vec3{0.5, 0.1, 0});
  CHECK(floats(2, 1) == 0.1f);
  CHECK(point(n, v)[1] == static_cast<double>(0.1f));
}

TEST_CASE("eigen: views are cheap to copy, and maps and other views store a copy") {
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
