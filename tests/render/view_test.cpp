#include <concino/render/make_drawable.hpp>
#include <concino/render/view.hpp>

#include <doctest/doctest.h>
#include <support/kinds.hpp>

using namespace concino;

TEST_CASE("view: named views look from their side, with up upwards, at the whole scene") {
  const drawable d = make_drawable(testing::grid<hexmesh>(2));
  for (const vec3& up : {vec3{0, 1, 0}, vec3{0, 0, 2}, vec3{1, 0, 0}}) {
    const auto look = [&](camera::named_view which) { return view(which).of({&d, 1}, 1.5, up); };
    const camera front = look(camera::from_front);
    CHECK(dot(front.up, up) == doctest::Approx(norm(up)));
    CHECK(norm(look(camera::from_back).back + front.back) == doctest::Approx(0));
    CHECK(norm(look(camera::from_right).back - front.right) == doctest::Approx(0));
    CHECK(norm(look(camera::from_left).back + front.right) == doctest::Approx(0));
    CHECK(norm(look(camera::from_above).back - front.up) == doctest::Approx(0));
    CHECK(norm(look(camera::from_above).right - front.right) == doctest::Approx(0));
    CHECK(norm(look(camera::from_below).back + front.up) == doctest::Approx(0));
    CHECK(norm(look(camera::from_below).right - front.right) == doctest::Approx(0));
    const camera three = look(camera::isometric);
    for (const vec3& side : {front.right, front.up, front.back}) CHECK(dot(three.back, side) == doctest::Approx(std::sqrt(1.0 / 3)));
    for (const auto which : {camera::three_quarter, camera::isometric, camera::from_front, camera::from_above})
      for (const vec3& p : d.points) {
        const image_point q = look(which).project(p);
        CHECK(std::abs(q.x) <= 1.5);
        CHECK(std::abs(q.y) <= 1);
      }
  }
  CHECK(view().of({&d, 1}, 1.5).back == frame({&d, 1}, 1.5).back);
}

TEST_CASE("view: a camera is taken as it is, and options frame the scene; up must be a direction") {
  const drawable d = make_drawable(testing::grid<trimesh>(1));
  const camera c = perspective_camera({1, 2, 3}, {0, 0, 0});
  CHECK(view(c).of({&d, 1}, 1).eye == c.eye);
  const view_options o{.towards = {1, 0, 0.1}, .angle = 40};
  CHECK(view(o).of({&d, 1}, 1).eye == frame({&d, 1}, 1, o).eye);
  CHECK_THROWS_AS(view().of({&d, 1}, 1, {0, 0, 0}), invalid_argument);
  CHECK_THROWS_AS(view().of({&d, 1}, 0), invalid_argument);
}
