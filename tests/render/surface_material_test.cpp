#include <concino/render/surface_material.hpp>

#include <concino/render/render.hpp>
#include <concino/render/shapes.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

double brightness(const rgb& c) { return (c.r + c.g + c.b) / 3; }

std::vector<vec3> normals() {
  std::vector<vec3> all;
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j)
      if (const double x = i / 8.5, y = j / 8.5; x * x + y * y < 1) all.push_back({x, y, std::sqrt(1 - x * x - y * y)});
  return all;
}

/// A picture of a ball in the middle, of the red component for light from the right and of the green one for light from above.
image lit_ball() {
  image ball(33, 33);
  for (std::size_t y = 0; y < 33; ++y)
    for (std::size_t x = 0; x < 33; ++x) ball(x, y) = {static_cast<float>(x) / 32, 1 - static_cast<float>(y) / 32, 0};
  return ball;
}

image picture_of(const drawable& d, int occlusion_rays = 0) {
  render_options o{.width = 40, .height = 40, .samples = 2, .occlusion_rays = occlusion_rays, .ground = false};
  o.camera = view_options{.towards = {0, 0, 1}, .margin = 0};
  return render(scene().add(d), o);
}

}  // namespace

TEST_CASE("surface_material: materials are bright toward the light, and finite for all normals") {
  CHECK(surface_material().is_daylight());
  for (const surface_material& m : {surface_material::matte(), surface_material::clay(), surface_material::porcelain(), surface_material::metal()}) {
    CHECK(!m.is_daylight());
    CHECK(brightness(m({-0.45, 0.6, 0.66})) > 1.4 * brightness(m({0.6, -0.6, 0.529})));
    for (const vec3& n : normals()) {
      const rgb c = m(n);
      CHECK_MESSAGE((c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r < 3), n.x << " " << n.y);
    }
  }
  const rgb clay = surface_material::clay()({0, 0, 1});
  CHECK(clay.r > clay.g);
  CHECK(clay.g > clay.b);
  const rgb grey = surface_material::matte()({0.3, 0.2, 0.932});
  CHECK(grey.r == grey.b);
}

TEST_CASE("surface_material: the picture of a ball gives the light of each normal") {
  const surface_material m = surface_material::from(lit_ball());
  for (const vec3& n : normals()) {
    if (std::abs(n.x) > 0.9 || std::abs(n.y) > 0.9) continue;  // half a pixel from the border
    CHECK(m(n).r == doctest::Approx((1 + n.x) / 2).epsilon(0.05));
    CHECK(m(n).g == doctest::Approx((1 + n.y) / 2).epsilon(0.05));
  }
  CHECK_THROWS_AS(surface_material::from(image()), invalid_argument);
}

TEST_CASE("surface_material: a ball in a picture shows the picture of the ball, in the colour of its surface") {
  const vec3 origin;
  drawable d = make_balls({origin}, {.radius = 3, .color = {1, 0.5f, 1}});
  d.look.material = surface_material::from(lit_ball());
  const image seen = picture_of(d);
  for (const std::size_t at : {std::size_t{12}, std::size_t{20}, std::size_t{28}}) {
    const double t = (static_cast<double>(at) + 0.5) / 20 - 1;  // of the radius
    CHECK(seen(at, 20).r == doctest::Approx((1 + t) / 2).epsilon(0.1));
    CHECK(seen(20, at).g == doctest::Approx((1 - t) / 4).epsilon(0.1));
  }
}

TEST_CASE("surface_material: cavities are darker with occlusion rays, and nothing else is") {
  // Three sides of a box, which is open to the viewer, and a plate beside it.
  drawable d;
  d.points = {{0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  d.corners = {0, 1, 2, 3, 0, 4, 5, 1, 3, 2, 6, 7, 5, 8, 9, 6};
  d.offsets = {0, 4, 8, 12, 16};
  detail::add_triangles(d);
  d.polys = {0, 1, 2, 3};
  d.normals = smooth_normals(d.polygons(), 0);
  d.look.material = surface_material::matte();
  const image plain = picture_of(d), occluded = picture_of(d, 64);
  CHECK(brightness(occluded(30, 20)) == doctest::Approx(brightness(plain(30, 20))).epsilon(0.1));
  CHECK(brightness(occluded(8, 20)) < 0.8 * brightness(plain(8, 20)));
}
