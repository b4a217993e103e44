// Areas, volumes and angles of every mesh of the corpus agree with the results of an independent program and with known laws.
#include <concino/geometry.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: areas and volumes match the index") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t surfaces = 0, volumes = 0;
  for (const auto& row : rows) {
    INFO(row.name);
    std::visit(
        [&](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          if constexpr (SurfaceMesh<M>) {
            ++surfaces;
            CHECK(total_measure(m) == doctest::Approx(row.area).epsilon(1e-9));
          } else {
            ++volumes;
            double boundary = 0, sum = 0;
            for (const auto f : faces(m)) {
              std::size_t sides = 0;
              for ([[maybe_unused]] const auto p : adj_f2p(m, f)) ++sides;
              if (sides == 1) boundary += area(m, f);
            }
            for (const auto p : polys(m)) sum += std::abs(volume(m, p));
            CHECK(boundary == doctest::Approx(row.area).epsilon(1e-9));
            CHECK(sum == doctest::Approx(row.volume).epsilon(1e-9));
          }
        },
        load_any(row.file.string()));
  }
  CHECK(surfaces > 10);
  CHECK(volumes > 5);
}

TEST_CASE("corpus: the centroid of the bunny is the known one") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/bunny.obj");
  const auto m = load<trimesh>(path.string());
  vec3 sum;
  for (const auto p : polys(m)) sum += area(m, p) * centroid(m, p);
  CHECK(norm(sum / total_measure(m) - vec3{-0.125840088456, -0.218105558261, 0.129767731192}) < 1e-10);
}

TEST_CASE("corpus: normals have length 1 or 0; angles sum to the known totals") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  const double pi = std::numbers::pi;
  std::size_t surfaces = 0, volumes = 0;
  const auto is_normal = [](const vec3& n) { return n == vec3{} || std::abs(norm(n) - 1) < 1e-15; };
  for (const auto& row : rows) {
    INFO(row.name);
    std::visit(
        [&](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          const auto of_verts = vert_normals(m);
          bool good = true;
          for (const auto v : verts(m)) good = good && is_normal(of_verts[v]);
          if constexpr (SurfaceMesh<M>) {
            const auto of_polys = poly_normals(m);
            for (const auto p : polys(m)) good = good && is_normal(of_polys[p]);
          }
          CHECK(good);
          if constexpr (TriMesh<M>) {
            ++surfaces;
            const auto defect = angle_defects(m);
            double sum = 0;
            for (const auto v : verts(m)) sum += defect[v];
            CHECK(std::abs(sum - 2 * pi * std::stod(row.column.at("euler_chi"))) < 1e-8);
          }
          if constexpr (VolumeMesh<M>) {
            if (num_polys(m) > 2000) return;
            double least = 1;
            for (const auto p : polys(m)) least = std::min(least, volume(m, p));
            if (least <= 0) return;
            ++volumes;
            const auto skin = boundary(m);
            std::size_t turns = 0, inside = 0;
            for (const auto e : edges(m)) {
              if (contains(skin, e)) continue;
              double sum = 0;
              for (const auto p : adj_e2p(m, e)) sum += dihedral_angle(m, p, e);
              ++inside;
              turns += std::abs(sum - 2 * pi) < 1e-9;
            }
            CHECK(turns == inside);
          }
        },
        load_any(row.file.string()));
  }
  CHECK(surfaces > 10);
  CHECK(volumes > 3);
}
