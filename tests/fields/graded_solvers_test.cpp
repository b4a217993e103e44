// Harmonic maps on grids graded by x^3, whose cells have very different sizes and shapes, are the same by iteration and by factorisation.
#include <concino/fields/heat_geodesics.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/graded_solvers.hpp>

#include <string>
#include <utility>

using namespace graded_solvers;

TEST_CASE("harmonic_map: iteration agrees with factorisation on graded triangles") {
  for (const bool all : {true, false}) CHECK(difference(graded<trimesh>(40, 3), all) < 1e-9);
}
TEST_CASE("harmonic_map: iteration agrees with factorisation on graded tets") {
  for (const bool all : {true, false}) CHECK(difference(graded<tetmesh>(9, 3), all) < 1e-9);
}
TEST_CASE("harmonic_map: iteration agrees with factorisation on graded hexes") {
  for (const bool all : {true, false}) CHECK(difference(graded<hexmesh>(9, 3), all) < 1e-9);
}
TEST_CASE("harmonic_map: iteration agrees with factorisation if half of a square is 10^9 times as high") {
  auto m = graded<trimesh>(30, 1);
  for (const auto v : verts(m)) {
    vec3 p = to_vec3(point(m, v));
    if (p.y > 0.5) p.y = 0.5 + 1e9 * (p.y - 0.5);
    set_point(m, v, p);
  }
  CHECK(difference(m, true) < 1e-9);
  CHECK(difference(m, false) < 1e-9);
}

TEST_CASE("fields: the error of a singular system names the problem, a vert and a remedy") {
  auto m = make_grid<hexmesh>({.cells = {4, 4, 4}});
  for (const auto v : verts(m)) {
    vec3 p = to_vec3(point(m, v));
    p.z *= 1e-9;
    set_point(m, v, p);
  }
  const vert_id corner{0};
  const auto said = [](auto f) {
    try {
      f();
    } catch (const solver_error& e) {
      return std::string(e.what());
    }
    return std::string("solved");
  };
  const std::string harmonic = said([&] { harmonic_map(m, {{corner, 0.0}, {vert_id{4}, 1.0}}, {}, ldlt{}); });
  const std::string heat = said([&] { heat_geodesics(m, corner, {}, ldlt{}); });
  for (const auto& [text, who] : {std::pair{harmonic, "harmonic_map: "}, std::pair{heat, "heat_geodesics: "}}) {
    CHECK(text.find(who) == 0);
    CHECK(text.find(" at vert ") != std::string::npos);
    CHECK(text.find("remesh") != std::string::npos);
  }
}
