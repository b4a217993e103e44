// Harmonic maps on real meshes agree with known functions, and obey the maximum principle.
#include <concino/fields.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/operators.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace concino;
using namespace concino::testing;

namespace {

using values = std::map<vert_id, double>;

/// The values of f at the verts of boundary edges (surfaces) or boundary faces (volumes).
template<class M, class F>
values on_boundary(const M& m, const F& f) {
  values given;
  const auto add = [&](const auto& around) {
    for (const auto v : around) given[v] = f(to_vec3(point(m, v)));
  };
  const auto one = [](const auto& sides) {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto p : sides) ++n;
    return n == 1;
  };
  if constexpr (SurfaceMesh<M>) {
    for (const auto e : edges(m))
      if (one(adj_e2p(m, e))) add(adj_e2v(m, e));
  } else {
    for (const auto x : faces(m))
      if (one(adj_f2p(m, x))) add(adj_f2v(m, x));
  }
  return given;
}

template<class M, class F>
double nodal_error(const M& m, const F& f, double* energy = nullptr) {
  const auto u = harmonic_map(m, on_boundary(m, f), cotangent);
  double worst = 0;
  for (const auto v : verts(m)) worst = std::max(worst, std::abs(u[v] - f(to_vec3(point(m, v)))));
  if (energy) {
    const Eigen::Map<const Eigen::VectorXd> x(u.values().data(), static_cast<Eigen::Index>(u.values().size()));
    *energy = -0.5 * x.dot(laplacian(m, cotangent) * x);
  }
  return worst;
}

}  // namespace

TEST_CASE("corpus: harmonic maps are exact on the regular grid of triangles") {
  CONCINO_CORPUS_OR_SKIP(path, "fields/grid_33.obj");
  const auto m = load<trimesh>(path.string());
  double energy = 0;
  CHECK(nodal_error(m, [](const vec3& x) { return x.x * x.x - x.y * x.y; }, &energy) < 1e-13);
  CHECK(energy == doctest::Approx(1.3330078125).epsilon(1e-10));
  CHECK(nodal_error(m, [](const vec3& x) { return x.x * x.y; }, &energy) < 1e-13);
  CHECK(energy == doctest::Approx(0.33349609375).epsilon(1e-10));
  CHECK(nodal_error(m, [](const vec3& x) { return x.x; }, &energy) < 1e-13);
  CHECK(energy == doctest::Approx(0.5).epsilon(1e-10));
  const auto smooth = [](const vec3& x) { return std::sin(std::numbers::pi * x.x) * std::sinh(std::numbers::pi * x.y) / std::sinh(std::numbers::pi); };
  CHECK(nodal_error(m, smooth) == doctest::Approx(0.00027796145785).epsilon(1e-8));
  CHECK(harmonic_map(m, on_boundary(m, smooth), cotangent)[vert_id{544}] == doctest::Approx(0.199498816585).epsilon(1e-10));
}

TEST_CASE("corpus: harmonic maps agree with known functions on the disk") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/circle_disk.obj");
  const auto m = load<trimesh>(path.string());
  CHECK(nodal_error(m, [](const vec3& x) { return x.x; }) < 1e-13);
  CHECK(nodal_error(m, [](const vec3& x) { return x.x * x.x - x.y * x.y; }) == doctest::Approx(0.00051309700845).epsilon(1e-8));
}

TEST_CASE("corpus: harmonic maps agree with known functions on the cube of tets") {
  CONCINO_CORPUS_OR_SKIP(path, "fields/kuhn_6.mesh");
  const auto m = load<tetmesh>(path.string());
  CHECK(nodal_error(m, [](const vec3& x) { return x.x + 2 * x.y - x.z; }) < 1e-13);
  CHECK(nodal_error(m, [](const vec3& x) { return x.x * x.x + x.y * x.y - 2 * x.z * x.z; }) < 1e-13);
}

TEST_CASE("corpus: masses of the sphere sum to its area, the Laplacian of its points is twice the curvature") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/sphere.obj");
  const auto m = load<trimesh>(path.string());
  const auto mass = vert_masses(m);
  const auto l = laplacian(m, cotangent);
  Eigen::MatrixXd x(l.rows(), 3);
  double sum = 0;
  for (const auto v : verts(m)) {
    sum += mass[v];
    for (int k = 0; k < 3; ++k) x(static_cast<Eigen::Index>(index_of(m, v)), k) = point(m, v)[static_cast<std::size_t>(k)];
  }
  CHECK(sum == doctest::Approx(3.13293354753).epsilon(1e-11));
  const Eigen::MatrixXd lx = l * x;
  double mean = 0, least = 1e9, most = 0;
  for (const auto v : verts(m)) {
    const double h = lx.row(static_cast<Eigen::Index>(index_of(m, v))).norm() / (2 * mass[v]);
    mean += h / static_cast<double>(num_verts(m));
    least = std::min(least, h);
    most = std::max(most, h);
  }
  CHECK(mean == doctest::Approx(2.0165755623).epsilon(1e-9));
  CHECK(least == doctest::Approx(0.248478134992).epsilon(1e-9));
  CHECK(most == doctest::Approx(7.03603419647).epsilon(1e-9));
}

TEST_CASE("corpus: uniform harmonic maps obey the maximum principle, on every mesh of up to 10,000 verts") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    INFO(row.name);
    std::visit(
        [](const auto& m) {
          if (num_verts(m) > 10000 && !long_run()) return;
          values given;
          auto seen = make_vert_map<bool>(m, false);
          for (const auto v : verts(m)) {
            if (seen[v]) continue;
            const auto hops = bfs(m, v);
            auto last = v;
            for (const auto w : verts(m)) {
              if (hops[w] < 0) continue;
              seen[w] = true;
              last = w;
            }
            given[v] = -1;
            given[last] = 2;
          }
          const auto u = harmonic_map(m, given, uniform);
          std::size_t outside = 0;
          for (const auto v : verts(m)) outside += !(u[v] >= -1 - 1e-9 && u[v] <= 2 + 1e-9);
          CHECK(outside == 0);
          for (const auto& [v, x] : given) CHECK(u[v] == x);
        },
        load_any(row.file.string()));
  }
}
