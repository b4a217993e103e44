// For every kind of defect, minimal meshes have this defect and no other, with the default options.
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/validate/validate.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace concino;

namespace {

using polygons = std::vector<std::vector<int>>;
using cells = std::vector<std::vector<std::pair<int, bool>>>;

const std::vector<vec3> some = {{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0.2, 0.3, 1}, {0.4, 0.2, -1}, {1, 1, 1}, {-1, 0.2, 0.5}, {-0.5, -1, 0.2}};

/// The points with these indices.
std::vector<vec3> points(std::initializer_list<std::size_t> which) {
  std::vector<vec3> r;
  for (const std::size_t i : which) r.push_back(some[i]);
  return r;
}

/// A tetmesh whose tets have positive volume.
tetmesh tets(const std::vector<vec3>& x, std::vector<std::array<std::size_t, 4>> list) {
  for (auto& t : list)
    if (dot(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]), x[t[3]] - x[t[0]]) < 0) std::swap(t[0], t[1]);
  return tetmesh(x, list);
}

using kinds_shown = std::set<defect_kind>;

template<class M>
void show(kinds_shown& shown, defect_kind kind, const M& m) {
  INFO(defect_name(kind));
  shown.insert(kind);
  const auto r = validate(m);
  for (const auto& d : r)
    if (d.kind != kind) FAIL_CHECK(d.what);
  CHECK(r.count(kind) == 1);
  CHECK(r.count() == 1);
  REQUIRE(r.size() == 1);
  CHECK(r[0].what.find_first_of("0123456789") != std::string::npos);
}

kinds_shown on_surfaces() {
  using enum defect_kind;
  kinds_shown shown;
  const auto shows_only = [&](defect_kind kind, const auto& m) { show(shown, kind, m); };
  const double nan = std::nan("");
  shows_only(non_finite_point, trimesh({{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  shows_only(isolated_vert, trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}));
  shows_only(duplicated_element, trimesh(points({0, 1, 2}), polygons{{0, 1, 2}, {0, 2, 1}}));
  shows_only(non_manifold_edge, trimesh(points({0, 1, 2, 3, 4}), polygons{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  shows_only(non_manifold_vert, trimesh(points({0, 1, 2, 3, 4}), polygons{{0, 1, 2}, {0, 3, 4}}));
  shows_only(inconsistent_winding, trimesh(points({0, 1, 2, 3}), polygons{{0, 1, 2}, {0, 1, 3}}));
  shows_only(not_orientable, trimesh(points({0, 1, 2, 3, 4}), polygons{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
  shows_only(zero_size, trimesh({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}));
  shows_only(zero_size, polygonmesh({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}));  // zero_size of an edge
  shows_only(self_touching, quadmesh({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
  shows_only(non_planar, quadmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2, 3}}));
  return shown;
}

kinds_shown on_volumes() {
  using enum defect_kind;
  kinds_shown shown;
  const auto shows_only = [&](defect_kind kind, const auto& m) { show(shown, kind, m); };
  const double inf = std::numeric_limits<double>::infinity();
  const auto four = points({0, 1, 2, 3});
  const polygons tet_faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  shows_only(non_finite_point, tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -inf}}, {{0, 1, 2, 3}}));
  shows_only(corner_order, hexmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}, {{0, 1, 2, 3, 4, 5, 6, 7}}));
  shows_only(isolated_vert, tetmesh(points({0, 1, 2, 3, 4}), polygons{{0, 1, 2, 3}}));
  // Two tets, and a triangle that would divide their union.
  shows_only(unreferenced_face, polyhedralmesh(points({0, 1, 2, 3, 4}), polygons{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 1}, {0, 2, 4}, {1, 4, 2}, {0, 3, 4}},
                                               cells{{{0, true}, {1, true}, {2, true}, {3, true}}, {{0, false}, {4, true}, {5, true}, {6, true}}}));
  // A thin spindle of three non-planar quads.
  const double r = 0.04, h = r * std::sqrt(0.75);
  shows_only(degenerate_element, polyhedralmesh(std::vector<vec3>{{0, 0, 0}, {0, 0, 1}, {r, 0, 0.5}, {-r / 2, h, 0.5}, {-r / 2, -h, 0.5}},
                                                polygons{{0, 2, 1, 3}, {0, 3, 1, 4}, {0, 4, 1, 2}}, cells{{{0, false}, {1, false}, {2, false}}}));
  shows_only(non_manifold_face, tets(points({0, 1, 2, 3, 4, 5}), {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}));
  shows_only(non_manifold_edge, tets(points({0, 1, 2, 3, 4, 7}), {{0, 1, 2, 3}, {0, 1, 4, 5}}));
  shows_only(non_manifold_vert, tets(points({0, 1, 2, 3, 4, 6, 7}), {{0, 1, 2, 3}, {0, 4, 5, 6}}));
  shows_only(inconsistent_winding, tets(points({0, 1, 2, 3, 5}), {{0, 1, 2, 3}, {0, 1, 2, 4}}));  // both tets are on the same side of their face
  shows_only(inconsistent_winding, polyhedralmesh(four, tet_faces, cells{{{0, true}, {1, true}, {2, false}, {3, true}}}));
  shows_only(open_cell, polyhedralmesh(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}, polygons{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                                       cells{{{0, true}, {1, true}, {2, true}, {3, true}}}));
  shows_only(inverted_cell, tetmesh(four, polygons{{0, 2, 1, 3}}));
  shows_only(zero_size, tetmesh({{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}));
  // Pyramids with a non-planar and a self-intersecting base.
  const polygons pyramid = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const cells one = {{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}}};
  shows_only(non_planar, polyhedralmesh(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.4}, {0, 1, 0}, {0.5, 0.5, 2}}, pyramid, one));
  shows_only(self_touching, polyhedralmesh(std::vector<vec3>{{0, 0, 0}, {3, 0, 0}, {0.5, 2, 0}, {1, -0.5, 0}, {1, 0.5, 2}}, pyramid, one));
  return shown;
}

}  // namespace

TEST_CASE("validate: for every kind of defect a minimal mesh has exactly this defect") {
  kinds_shown all = on_surfaces();
  all.merge(on_volumes());
  for (std::size_t k = 0; k < num_defect_kinds; ++k) {
    INFO(defect_name(defect_kind(k)));
    CHECK(all.count(defect_kind(k)) == 1);
  }
}

TEST_CASE("validate: the report has records in `defects` and a text with everything") {
  const trimesh sound(points({0, 1, 2}), std::vector<std::array<int, 3>>{{0, 1, 2}});
  CHECK(validate(sound).text() == "no defects\n");
  CHECK(validate(sound).defects.empty());

  const trimesh lonely(points({0, 1, 2, 3, 4, 5}), std::vector<std::array<int, 3>>{{0, 1, 2}});
  const auto all = validate(lonely);
  REQUIRE(all.defects.size() == 3);
  CHECK(all.text() == "3 defects\nisolated vert: " + all.defects[0].what + "\nisolated vert: " + all.defects[1].what + "\nisolated vert: " + all.defects[2].what + "\n");
  const auto some_of_them = validate(lonely, {.max_per_kind = 1});
  CHECK(some_of_them.defects.size() == 1);
  CHECK(some_of_them.text() == "3 defects\nisolated vert: " + all.defects[0].what + "\nisolated vert: 2 more\n");
}
