// Whatever happens in the child process in which TetGen runs, the caller lives and learns why there is no result.
#include <concino/adapters/tetgen.hpp>

#include <concino/generate/box.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus_meshes.hpp>
#include <support/ignored_leaks.hpp>

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <random>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

trimesh cube() { return make_box<trimesh>({.cells = {2, 2, 2}}); }

std::string failure_of(const tetrahedralize_options& o) {
  try {
    tetrahedralize(cube(), tetgen, o);
  } catch (const unsupported& e) {
    return e.what();
  }
  return "";
}
bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

/// A polygon soup, changed in a random way.
template<class Random>
surface_arrays damaged(surface_arrays a, Random& random) {
  const auto any = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (std::size_t changes = 1 + any(3); changes-- > 0;) {
    const std::size_t p = any(a.verts.size() / 3);
    switch (any(7)) {
      case 0: a.verts.erase(a.verts.begin() + static_cast<std::ptrdiff_t>(3 * p), a.verts.begin() + static_cast<std::ptrdiff_t>(3 * p + 3)); break;
      case 1: a.points[any(a.points.size())] += vec3{0.3, -0.2, 0.4} * (1 + static_cast<double>(any(5))); break;
      case 2: a.points[any(a.points.size())] = a.points[any(a.points.size())]; break;
      case 3: std::swap(a.verts[3 * p], a.verts[3 * p + 1]); break;
      case 4: a.points[any(a.points.size())].y *= 1e-9; break;
      case 5: a.points[any(a.points.size())].z = any(2) == 0 ? std::nan("") : 1e30; break;
      default: for (vec3& q : a.points) q.z *= 1e-7; break;
    }
    if (a.verts.size() < 6) break;
  }
  return a;
}

}  // namespace

TEST_CASE("tetgen: a crash, an exception or a loop in the child is an exception of the caller") {
  CHECK(has(failure_of({.edge_length = [](const vec3&) -> double { std::raise(SIGSEGV); return 1; }, .keep_boundary = false}), "TetGen crashed, by signal 11"));
  CHECK(has(failure_of({.edge_length = [](const vec3&) -> double { throw std::runtime_error("?"); }, .keep_boundary = false}), "by an exception of options.edge_length"));
  const auto start = std::chrono::steady_clock::now();
  CHECK(has(failure_of({.edge_length = [](const vec3&) { return 0.0; }, .keep_boundary = false, .max_seconds = 0.3}), "longer than max_seconds"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
  const ignored_leaks by_tetgen;  // what it holds when the exception passes through it
  CHECK_THROWS_AS(tetrahedralize(cube(), tetgen, {.edge_length = [](const vec3&) -> double { throw std::logic_error("?"); }, .keep_boundary = false, .in_process = true}),
                  std::logic_error);
}

TEST_CASE("tetgen: a child that needs more memory than allowed") {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
  return skip("the address sanitizer reserves addresses beyond any limit");
#endif
#endif
  const trimesh m = make_sphere<trimesh>({.cells = 20});
  CHECK_THROWS_WITH_AS(tetrahedralize(m, tetgen, {.max_volume = 1e-7, .max_bytes = 20'000'000}), doctest::Contains("TetGen"), unsupported);
  CHECK(num_polys(tetrahedralize(m, tetgen, {.max_bytes = 500'000'000}).mesh) > 0);
}

TEST_CASE("tetgen: progress is reported while the child runs, and can end it") {
  const auto slow = [](const vec3&) { return 0.02; };
  std::size_t calls = 0;
  const auto stop = [&](double fraction, const char*) {
    CHECK(fraction < 1);
    return ++calls < 5;
  };
  CHECK_THROWS_AS(tetrahedralize(cube(), tetgen, {.edge_length = slow, .keep_boundary = false, .progress = stop}), cancelled);
  CHECK(calls == 5);
}

TEST_CASE("tetgen: damaged surfaces are refused or filled, and the caller lives") {
  surface_arrays whole{{}, {}, {}, 3};
  const trimesh m = make_sphere<trimesh>({.cells = 2});
  for (const auto v : verts(m)) whole.points.push_back(point(m, v));
  for (const auto p : polys(m))
    for (const auto v : adj_p2v(m, p)) whole.verts.push_back(v);
  std::mt19937 random(5);
  std::size_t filled = 0, refused = 0;
  const std::size_t rounds = long_run() ? 500 : 100;
  for (std::size_t i = 0; i < rounds; ++i) {
    const trimesh bad{damaged(whole, random)};
    try {
      const auto t = tetrahedralize(bad, tetgen, {.radius_edge = i % 2 == 0 ? 1.5 : 0, .keep_boundary = i % 4 < 2, .max_seconds = 2});
      CHECK(num_polys(t.mesh) > 0);
      ++filled;
    } catch (const error& e) {
      CHECK(has(e.what(), "tetrahedralize: "));
      ++refused;
    }
  }
  CHECK(filled + refused == rounds);
  CHECK(filled > rounds / 20);
  CHECK(refused > rounds / 3);
}

TEST_CASE("tetgen: every closed surface of the corpus") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t filled = 0;
  for (const auto& row : rows)
    std::visit(
        [&](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          if constexpr (SurfaceMesh<M>) {
            if (!long_run() && num_polys(m) > 2000) return;
            INFO(row.name);
            try {
              const auto t = tetrahedralize(m, tetgen);
              ++filled;
              if (TriMesh<M>) CHECK(total_measure(t.mesh) == doctest::Approx(std::abs(row.volume)).epsilon(1e-9));
            } catch (const invalid_mesh& e) {
              CHECK_MESSAGE((has(e.what(), "must be closed") || has(e.what(), "same point") || has(e.what(), "intersect") ||
                             has(e.what(), "more than two polys")), std::string(e.what()));
            }
          }
        },
        load_any(row.file));
  CHECK(filled >= (long_run() ? 13 : 5));
}
