// Laplacians and masses of real meshes obey the laws of operators.
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

bool are_equal(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b, double factor) {
  if (a.nonZeros() != b.nonZeros()) return false;
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k)
    if (a.innerIndexPtr()[k] != b.innerIndexPtr()[k] || a.valuePtr()[k] != factor * b.valuePtr()[k]) return false;
  return true;
}

template<class M>
void check(M m) {
  double sizes = 0;
  bool all_have_measure = true;
  for (const auto p : polys(m)) {
    sizes += std::abs(measure(m, p));
    all_have_measure = all_have_measure && measure(m, p) != 0;
  }
  CHECK(mass_matrix(m).sum() == doctest::Approx(sizes).epsilon(1e-12));
  if (!all_have_measure) {
    CHECK_THROWS_AS(laplacian(m), invalid_mesh);
    return;
  }
  CHECK(mass_matrix(m, {.lumped = false}).sum() == doctest::Approx(sizes).epsilon(1e-12));
  const auto l = laplacian(m);
  CHECK(are_equal(l, Eigen::SparseMatrix<double>(l.transpose()), 1));
  double largest = 0;
  for (Eigen::Index k = 0; k < l.nonZeros(); ++k) largest = std::max(largest, std::abs(l.valuePtr()[k]));
  const Eigen::VectorXd of_ones = l * Eigen::VectorXd::Ones(l.cols());
  CHECK(of_ones.cwiseAbs().maxCoeff() <= 1e-13 * largest);
  Eigen::VectorXd u(l.cols());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::sin(static_cast<double>(i));
  CHECK(u.dot(l * u) < 0);
  const M original = m;
  for (const double s : {0x1p20, 0x1p-20}) {
    for (const auto v : verts(m)) set_point(m, v, s * point(original, v));
    CHECK(are_equal(laplacian(m), l, VolumeMesh<M> ? s : 1));
  }
}

}  // namespace

TEST_CASE("corpus: Laplacians and masses obey their laws") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    if (std::filesystem::file_size(row.file) > 150'000 && row.name != "polyhedral/eight_voronoi.hedra" && !long_run()) continue;
    INFO(row.name);
    std::visit([](const auto& m) { check(m); }, load_any(row.file.string()));
  }
}
