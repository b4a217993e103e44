#include <concino/generate/box.hpp>

#include <concino/geometry/bounding_box.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

namespace {

/// The volume inside a closed surface, positive if its polygons are oriented outward.
template<class M>
double enclosed(const M& m) {
  double sum = 0;
  for (const poly_t<M> p : polys(m)) {
    const polygon_shape s = shape_of(m, adj_p2v(m, p));
    sum += dot(s.mean, s.area) / 3;
  }
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("make_box: a surface is the closed surface of the box", M, CONCINO_SURFACE_KINDS) {
  for (const std::array<std::size_t, 3> cells : {std::array<std::size_t, 3>{1, 1, 1}, {3, 2, 1}, {1, 1, 4}, {2, 3, 4}}) {
    const M m = make_box<M>({.cells = cells, .min = {-1, 2, 0.5}, .max = {2, 4, 3}});
    check_sound(m, 2);
    CHECK(validate(m).facts.closed);
    CHECK(total_measure(m) == doctest::Approx(2 * (6 + 5 + 7.5)).epsilon(1e-14));
    CHECK(enclosed(m) == doctest::Approx(15).epsilon(1e-13));
    CHECK(bounding_box(m).min == vec3{-1, 2, 0.5});
    CHECK(bounding_box(m).max == vec3{2, 4, 3});
    const std::size_t quads = 2 * (cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0]);
    CHECK(num_polys(m) == (arity_v<M> == 3 ? 2 * quads : quads));
  }
}

TEST_CASE_TEMPLATE("make_box: a volume is the solid box", M, CONCINO_VOLUME_KINDS) {
  const M m = make_box<M>({.cells = {2, 3, 1}, .max = {2, 3, 4}});
  check_sound(m, 1);
  CHECK(total_measure(m) == doctest::Approx(24).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("make_box: throws if an option is out of range", M, CONCINO_KINDS) {
  CHECK_THROWS_WITH_AS(make_box<M>({.cells = {4, 4, 0}}), doctest::Contains(": cells[2] is 0; it must be at least 1"), invalid_argument);
  CHECK_THROWS_AS(make_box<M>({.cells = {~std::size_t{0}, 1u << 30, 1u << 30}}), invalid_argument);
  CHECK_THROWS_AS(make_box<M>({.max = {1, 1, 0}}), invalid_argument);
  CHECK_THROWS_AS(make_box<M>({.max = {1, 1, std::nan("")}}), invalid_argument);
}
