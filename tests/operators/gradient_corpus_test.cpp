// Gradients and divergences on real meshes are exact on linear functions, for polys of any shape.
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/vert_gradient_matrix.hpp>

#include <support/corpus_meshes.hpp>
#include <support/fields.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
void check_divergence(const M& m) {
  const auto d = divergence_matrix(m);
  check_compressed(d);
  const Eigen::VectorXd sums = Eigen::VectorXd::Ones(d.rows()).transpose() * d;
  const double diagonal = centre_and_diagonal(m).second;
  CHECK(sums.cwiseAbs().maxCoeff() < 1e-14 * std::pow(diagonal, dimension_v<M> - 1));
  if constexpr (VolumeMesh<M>) CHECK(constant_divergence(m, d) < 1e-14);
}

template<class M>
void check_scaling(M m) {
  const auto g = gradient_matrix(m), d = divergence_matrix(m), w = vert_gradient_matrix(m);
  check_compressed(g);
  check_compressed(w);
  const auto growth = [](double s) { return VolumeMesh<M> ? s * s : s; };
  const M original = m;
  const auto scale = [&](double s) {
    for (const auto v : verts(m)) set_point(m, v, s * point(original, v));
  };
  for (const double s : {0x1p20, 0x1p-20}) {
    scale(s);
    CHECK(same_entries(gradient_matrix(m), g, 1 / s));
    CHECK(same_entries(vert_gradient_matrix(m), w, 1 / s));
    CHECK(same_entries(divergence_matrix(m), d, growth(s)));
  }
  for (const double s : {1e6, 1e-6}) {
    scale(s);
    CHECK(difference(s * gradient_matrix(m), g) < 1e-9);
    CHECK(difference(s * vert_gradient_matrix(m), w) < 1e-9);
    CHECK(difference(1 / growth(s) * divergence_matrix(m), d) < 1e-9);
  }
}

}  // namespace

TEST_CASE("corpus: gradients are exact on linear functions, and divergences of constants are 0") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    const auto bytes = std::filesystem::file_size(row.file);
    if (bytes > 150'000 && row.name != "polyhedral/eight_voronoi.hedra" && !long_run()) continue;
    INFO(row.name);
    std::visit(
        [&](const auto& m) {
          CHECK(linear_error(m, gradient_matrix(m)) < 1);
          check_divergence(m);
          if (bytes < 50'000) check_scaling(m);
        },
        load_any(row.file.string()));
  }
}

TEST_CASE("corpus: gradients of the functions of EXPECTED_FIELDS are exact") {
  CONCINO_CORPUS_OR_SKIP(disk_file, "tri/circle_disk.obj");
  const auto disk = load<trimesh>(disk_file.string());
  auto u = make_vert_map<double>(disk);
  for (const auto v : verts(disk)) u[v] = 2 * point(disk, v).x - 3 * point(disk, v).y + 1;
  const auto g = gradient(disk, u);
  const auto at = vert_gradient(disk, u);
  double worst = 0;
  for (const auto p : polys(disk)) worst = std::max(worst, distance(g[p], {2, -3, 0}));
  for (const auto v : verts(disk)) worst = std::max(worst, distance(at[v], {2, -3, 0}));
  CHECK(worst < 1e-12);

  CONCINO_CORPUS_OR_SKIP(cube_file, "fields/kuhn_6.mesh");
  const auto cube = load<tetmesh>(cube_file.string());
  auto w = make_vert_map<double>(cube);
  for (const auto v : verts(cube)) w[v] = point(cube, v).x + 2 * point(cube, v).y - point(cube, v).z;
  const auto h = gradient(cube, w);
  worst = 0;
  for (const auto p : polys(cube)) worst = std::max(worst, distance(h[p], {1, 2, -1}));
  CHECK(worst < 1e-12);
}
