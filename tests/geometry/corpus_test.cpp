// Areas and volumes of every mesh of the corpus, against the figures of an independent program.
#include <concino/geometry.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: areas of surfaces and of the boundaries of volumes, volumes of cells") {
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

TEST_CASE("corpus: the centroid of the bunny's surface") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/bunny.obj");
  const auto m = load<trimesh>(path.string());
  vec3 sum;
  for (const auto p : polys(m)) sum += area(m, p) * centroid(m, p);
  CHECK(norm(sum / total_measure(m) - vec3{-0.125840088456, -0.218105558261, 0.129767731192}) < 1e-10);
}
