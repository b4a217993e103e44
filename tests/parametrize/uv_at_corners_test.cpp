// Maps of surfaces that are cut open, at corners: drawn, saved, measured. And the scopes that UV maps open in a profiler.
#include <concino/parametrize/uv_at_corners.hpp>

#include <concino/generate/torus.hpp>
#include <concino/graph/cut_along.hpp>
#include <concino/graph/homology.hpp>
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/parametrize/injective_map.hpp>
#include <concino/parametrize/lscm.hpp>
#include <concino/parametrize/map_distortion.hpp>
#include <concino/parametrize/spectral_conformal.hpp>
#include <concino/parametrize/arap_map.hpp>
#include <concino/parametrize/tutte.hpp>
#include <concino/render/make_drawable.hpp>

#include <support/profiled.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <cstdio>
#include <set>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("uv_at_corners: of a torus that is cut open", M, CONCINO_ALL_SURFACE_KINDS) {
  auto torus = make_torus<M>({.cells = {20, 10}});
  CHECK_THROWS_AS((void)lscm(torus), invalid_mesh);
  const auto cut = cut_along(torus, homology_generators(torus));
  const M open(cut.surface);
  const auto uv = injective_map(open, {.max_iterations = 5}).uv;
  const auto at = uv_at_corners(torus, cut.polys, open, uv);
  std::size_t several = 0;
  for (const auto v : verts(torus)) {
    std::set<uv_point> places;
    for (const auto p : adj_v2p(torus, v)) {
      std::uint32_t k = 0;
      for (const auto w : adj_p2v(torus, p)) {
        if (w == v) places.insert(at[{p, k}]);
        ++k;
      }
    }
    several += places.size() > 1;
  }
  CHECK(several > 5);
  CHECK(several < num_verts(torus));
  const auto here = map_distortion(torus, at), there = map_distortion(open, uv);
  CHECK(here.flipped == 0);
  CHECK(here.max_angle == there.max_angle);
  CHECK(here.max_area == there.max_area);
  CHECK(here.max_stretch == there.max_stretch);
  // drawn
  const drawable d = make_drawable(torus, {.texture = texture::checkerboard(), .texture_coordinates = at});
  CHECK(d.texture_coordinates.size() == d.corners.size());
  // saved
  const auto property = corner_property<uv_point>(torus, "texture");
  for (const auto p : polys(torus))
    for (std::uint32_t k = 0; k < at.of(p).size(); ++k) property[{p, k}] = at[{p, k}];
  const std::string path = std::string("uv_at_corners_") + std::to_string(arity_v<M>) + ".obj";
  save(torus, path);
  const auto again = load<M>(path);
  std::remove(path.c_str());
  const auto loaded = find_corner_property<uv_point>(again, "texture");
  REQUIRE(static_cast<bool>(loaded));
  CHECK(map_distortion(again, loaded).flipped == 0);
  CHECK(map_distortion(again, loaded).max_area == doctest::Approx(here.max_area).epsilon(1e-6));
}

TEST_CASE("uv_at_corners: of a view, and bad input") {
  const auto m = grid<quadmesh>(4);
  const auto part = submesh(m, [](poly_id p) { return p.raw() < 8; });
  const auto uv = lscm(part);
  std::vector<poly_id> some;
  for (const auto p : polys(part)) some.push_back(p);
  const auto at = uv_at_corners(m, some, part, uv);
  CHECK(at[{poly_id{3}, 0}] == uv[*adj_p2v(m, poly_id{3}).begin()]);
  CHECK(at[{poly_id{9}, 2}] == uv_point{0, 0});
  some.pop_back();
  CHECK_THROWS_AS((void)uv_at_corners(m, some, part, uv), invalid_argument);
  some.push_back(poly_id{7});
  some.push_back(poly_id{8});
  CHECK_THROWS_AS((void)uv_at_corners(m, some, part, uv), invalid_argument);
  some.pop_back();
  some[0] = poly_id{1000};
  CHECK_THROWS_AS((void)uv_at_corners(m, some, part, uv), invalid_mesh);
  const auto triangles = grid<trimesh>(2);
  some.assign(num_polys(triangles), poly_id{0});
  CHECK_THROWS_AS((void)uv_at_corners(m, some, triangles, make_vert_map<uv_point>(triangles)), invalid_argument);
}

TEST_CASE("profiler: UV maps open scopes") {
  const auto m = grid<trimesh>(3);
  profiler p;
  tutte(m, {.profiler = &p});
  lscm(m, {.profiler = &p});
  spectral_conformal(m, {.profiler = &p});
  arap_map(m, {.profiler = &p});
  injective_map(m, {.profiler = &p});
  std::set<std::string> all;
  for (const auto& e : p.entries())
    if (e.depth == 0) all.insert(e.name);
  CHECK(all == std::set<std::string>{"tutte", "lscm", "spectral_conformal", "arap_map", "injective_map"});
}
