// Views of Eigen's matrices, of every kind of poly, pass the conformance kit.
#include <concino/adapters/doctest.hpp>
#include <concino/adapters/eigen.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>
#include <support/soups.hpp>

namespace cn = concino;

namespace {

template<class M>
struct matrices {
  Eigen::MatrixXd points;
  Eigen::MatrixXi polys;

  explicit matrices(const M& m) : points(static_cast<Eigen::Index>(cn::num_verts(m)), 3), polys(static_cast<Eigen::Index>(cn::num_polys(m)), cn::arity_v<M>) {
    for (const auto v : cn::verts(m))
      for (int k = 0; k < 3; ++k) points(static_cast<Eigen::Index>(v.raw()), k) = cn::point(m, v)[static_cast<std::size_t>(k)];
    for (const auto p : cn::polys(m)) {
      int k = 0;
      for (const auto v : cn::adj_p2v(m, p)) polys(static_cast<Eigen::Index>(p.raw()), k++) = static_cast<int>(v.raw());
    }
  }
  auto view() const {
    if constexpr (cn::TriMesh<M>) return cn::view_tri(points, polys);
    else if constexpr (cn::QuadMesh<M>) return cn::view_quad(points, polys);
    else if constexpr (cn::TetMesh<M>) return cn::view_tet(points, polys);
    else return cn::view_hex(points, polys);
  }
};

}  // namespace

TEST_CASE_TEMPLATE("views of matrices conform on grids and soups", M, CONCINO_FIRST_OF(cn::trimesh, cn::quadmesh, cn::tetmesh, cn::hexmesh)) {
  const matrices<M> grid(cn::testing::grid<M>(2));
  cn::check_conformance([&] { return grid.view(); });
  std::mt19937 random(3);
  const matrices<M> soup(cn::testing::random_soup<M>(random, 14, 9).mesh());
  cn::check_conformance([&] { return soup.view(); }, {.turned_polys = true});
}
