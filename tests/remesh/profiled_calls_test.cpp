// Functions of remesh, convert, render and print open a scope in a profiler.
#include <concino/convert/convert.hpp>
#include <concino/core/profiler.hpp>
#include <concino/print/slice_mesh.hpp>
#include <concino/remesh/decimate.hpp>
#include <concino/remesh/improve.hpp>
#include <concino/remesh/remesh.hpp>
#include <concino/remesh/smooth_points.hpp>
#include <concino/render/render.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("profiler: each call is a scope") {
  profiler p;
  auto m = grid<trimesh>(4);
  scene s;
  s.add(m);
  render(s, {.width = 8, .height = 8, .profiler = &p});
  convert<polygonmesh>(m, {.profiler = &p});
  remesh(m, {.edge_length = 0.3, .max_rounds = 1, .profiler = &p});
  smooth_points(m, {.max_rounds = 1, .profiler = &p});
  decimate(m, {.target_polys = 10, .profiler = &p});
  auto v = grid<tetmesh>(1);
  improve(v, {.max_rounds = 1, .profiler = &p});
  slice_mesh(v, {0.25, 0.75}, {.profiler = &p});
  std::vector<std::string> names;
  for (const auto& e : p.entries())
    if (e.depth == 0) names.push_back(e.name);
  CHECK(names == std::vector<std::string>{"render", "convert", "remesh", "smooth_points", "decimate", "improve", "slice_mesh"});
}
