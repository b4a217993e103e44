// One function body for all six kinds: load a file, run graph algorithms and fields, save a file.
#include <concino/fields.hpp>
#include <concino/graph.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/validate.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

namespace cn = concino;

static_assert(!cn::PrimalGraph<int>);

namespace {

template<class M>
std::string everything(const char* file) {
  M m = cn::load<M>(file);
  std::size_t n = cn::num_verts(m) + cn::num_edges(m) + cn::num_polys(m);
  if constexpr (cn::VolumeMesh<M>) n += cn::num_faces(m);
  cn::vert_t<M> a = *cn::verts(m).begin(), b = a;
  for (auto v : cn::verts(m)) b = v;
  auto d = cn::dijkstra(m, a);
  auto h = cn::bfs(m, a);
  auto p0 = *cn::polys(m).begin();
  auto dd = cn::dijkstra(m, p0);
  auto n1 = cn::dijkstra(m, a, [](auto, auto) { return 1.0; }, {.targets = {b}});
  auto u = cn::harmonic_map(m, {{a, 0.0}, {b, 1.0}}, cn::uniform);
  auto p = cn::point(m, b);
  std::string text = fmt::format("{} {} {} {} {} {} {}\n", n, d[b], h[b], dd[p0], n1[b], u[b], p[2]);
  cn::save(m, cn::VolumeMesh<M> ? "copy.hedra" : "copy.obj");
  static_assert(cn::Embedded<M> && cn::AnyMesh<const M&>);
  for (auto& broken : cn::check_laws(m)) text += fmt::format("{} {}\n", broken.law, broken.witness);
  return text;
}

}  // namespace

TEST_CASE_TEMPLATE("one function body loads, computes and saves on all six kinds", M, CONCINO_KINDS) {
  const auto before = std::filesystem::current_path();
  const auto folder = std::filesystem::temp_directory_path() / "concino_contract_test";
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  const char* const file = cn::VolumeMesh<M> ? "grid.hedra" : "grid.obj";
  const M grid = cn::testing::grid<M>(2);
  cn::save(grid, file);
  const std::string text = everything<M>(file);
  const M copy = cn::load<M>(cn::VolumeMesh<M> ? "copy.hedra" : "copy.obj");
  std::filesystem::current_path(before);
  std::filesystem::remove_all(folder);

  CHECK(text.find('\n') == text.size() - 1);  // no law was broken
  CHECK(cn::num_verts(copy) == cn::num_verts(grid));
  CHECK(cn::num_edges(copy) == cn::num_edges(grid));
  for (const auto v : cn::verts(grid)) CHECK(cn::point(copy, v) == cn::point(grid, v));
}

TEST_CASE("load_any returns a variant that can be visited") {
  const auto file = std::filesystem::temp_directory_path() / "concino_contract_any.mesh";
  cn::save(cn::testing::grid<cn::hexmesh>(2), file);
  auto any = cn::load_any(file);
  std::filesystem::remove(file);
  CHECK(std::holds_alternative<cn::hexmesh>(any));
  CHECK(std::visit([](const auto& m) { return cn::num_polys(m); }, any) == 8);
}
