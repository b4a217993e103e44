#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>
#include <concino/render/scene_html.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace concino;

namespace {

std::string page_of(const scene& s, const html_options& options = {}) {
  const testing::temporary_folder folder;
  save_html(s, folder / "a.html", options);
  CHECK(folder.num_files() == 1);
  return testing::read_file(folder / "a.html");
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// The text behind `before` up to `after`.
std::string between(const std::string& text, const std::string& before, const std::string& after, std::size_t from = 0) {
  const std::size_t first = text.find(before, from);
  REQUIRE(first != std::string::npos);
  const std::size_t begin = first + before.size();
  return text.substr(begin, text.find(after, begin) - begin);
}

/// The numbers of the array that the first `name` in the JSON names.
template<class T>
std::vector<T> numbers(const std::string& page, const std::string& name, const std::string& type) {
  const std::string json = between(page, "id=\"scene\">", "</script>");
  const std::size_t k = std::stoul(between(json, "\"" + name + "\":", ","));
  std::size_t at = 0;
  for (std::size_t i = 0; i <= k; ++i) at = page.find("<script type=\"text/plain\"", at + 1);
  CHECK(between(page, "data-type=\"", "\"", at) == type);
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/", text = between(page, ">", "<", at);
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    unsigned group = 0;
    for (std::size_t j = 0; j < 4; ++j) group = group << 6 | (text[i + j] == '=' ? 0u : static_cast<unsigned>(digits.find(text[i + j])));
    for (const unsigned shift : {16u, 8u, 0u}) bytes += static_cast<char>(group >> shift & 255);
  }
  std::vector<T> result(std::stoul(between(page, "data-length=\"", "\"", at)));
  CHECK(bytes.size() - result.size() * sizeof(T) < 3);
  std::memcpy(result.data(), bytes.data(), result.size() * sizeof(T));
  return result;
}

}  // namespace

TEST_CASE_TEMPLATE("save_html: the page holds the mesh as it is", M, CONCINO_ALL_KINDS) {
  M m = testing::grid<M>(2);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = 0.1 * static_cast<double>(index_of(m, v));
  scene s;
  s.add(m, {.field = u, .inspect = true, .name = "block"});
  const std::string page = page_of(s, {.title = "a block"});
  CHECK(page.find("<title>a block</title>") != std::string::npos);
  CHECK(between(page, "\"name\":\"block", "\"").empty());
  const auto values = numbers<double>(page, "numbers", "f8");  // 0.1 is no float
  for (const auto v : verts(m)) CHECK(values[index_of(m, v)] == u[v]);
  const auto points = numbers<float>(page, "points", "f4");    // halves are
  for (const auto v : verts(m))
    for (std::size_t k = 0; k < 3; ++k) CHECK(static_cast<double>(points[3 * index_of(m, v) + k]) == to_vec3(point(m, v))[k]);
  const inspected_mesh& kept = *s.drawables()[0].inspected;
  const auto corners = numbers<std::uint16_t>(page, "corners", "u2");
  CHECK(std::equal(corners.begin(), corners.end(), kept.polygon_verts.begin(), kept.polygon_verts.end()));
}

TEST_CASE("save_html: without inspect, the polygons of the picture") {
  const trimesh m = testing::grid<trimesh>(2);
  scene s;
  s.add(m).add_points({vec3{0, 0, 1}});
  const std::string page = page_of(s);
  CHECK(page.find("\"mesh\":") == std::string::npos);
  CHECK(count(page, "\"normals\":") == 2);
  const auto normals = numbers<std::int8_t>(page, "normals", "i1");
  CHECK(normals.size() == 3 * s.drawables()[0].corners.size());
}

TEST_CASE("save_html: textures, with the pixels of a picture") {
  const trimesh m = testing::grid<trimesh>(2);
  auto at = make_vert_map<std::array<double, 2>>(m);
  for (const auto v : verts(m)) at[v] = {point(m, v).x, point(m, v).y};
  image picture(3, 2, {1, 0, 0});
  picture(2, 1) = {0, 0, 1};
  for (const bool inspect : {false, true}) {
    scene s;
    s.add(m, {.texture = texture::from(picture, texture::outside::clamp), .texture_coordinates = at, .inspect = inspect});
    const std::string page = page_of(s);
    const auto pixels = numbers<std::uint8_t>(page, "pixels", "u1");
    CHECK(pixels == srgb_bytes(picture));
    CHECK(count(page, "\"repeats\":false") == 1);
    if (inspect) CHECK(count(page, "\"name\":\"texture coordinates\"") == 1);
    else CHECK(numbers<float>(page, "coordinates", "f4").size() == 2 * s.drawables()[0].corners.size());
  }
  scene s;
  s.add(m, {.texture = texture::isolines(5, {0, 1, 0}, 2), .texture_coordinates = at});
  CHECK(page_of(s).find("\"texture\":{\"kind\":2,\"count\":5,\"width\":2,\"first\":[0,1,0]") != std::string::npos);
}

TEST_CASE("save_html: texts end no script, and their control characters are escaped") {
  const std::string evil = "</script><b>&\"\\\n\x01";
  scene s;
  s.add_label({0, 0, 0}, evil);
  const std::string page = page_of(s, {.title = evil}), empty = page_of({});
  CHECK(count(page, "</script>") == count(empty, "</script>"));
  CHECK(page.find("<title>&lt;/script&gt;&lt;b&gt;&amp;\"\\</title>") != std::string::npos);
  CHECK(page.find("\"text\":\"\\u003c/script\\u003e\\u003cb\\u003e\\u0026\\u0022\\u005c\\u000a\\u0001\"") != std::string::npos);
}

TEST_CASE("save_html: coordinates and values of any size") {
  for (const double size : {1e30, 1e-30, 1e300, 1e-300}) {
    trimesh m = testing::grid<trimesh>(1);
    for (const auto v : verts(m)) set_point(m, v, point(m, v) * size);
    auto u = make_vert_map<double>(m, std::numeric_limits<double>::quiet_NaN());
    scene s;
    s.add(m, {.field = u, .inspect = true});
    const std::string page = page_of(s), json = between(page, "id=\"scene\">", "</script>");
    CHECK(json.find("nan") == std::string::npos);
    CHECK(json.find("inf") == std::string::npos);
    const double radius = std::stod(between(json, "\"radius\":", ","));
    CHECK(radius / size == doctest::Approx(std::sqrt(0.5)).epsilon(1e-6));
  }
}

TEST_CASE("save_html: the page has at most 120 kB, and 1.4 times the bytes of its arrays") {
  CHECK(page_of({}).size() < 120000);
  scene s;
  const trimesh m = testing::grid<trimesh>(60);
  s.add(m);
  const drawable& d = s.drawables()[0];
  const std::size_t bytes = 12 * d.points.size() + 2 * d.offsets.size() + 5 * d.corners.size();
  CHECK(static_cast<double>(page_of(s).size()) < 120000 + 1.4 * static_cast<double>(bytes));
}

TEST_CASE("save_html: errors") {
  const testing::temporary_folder folder;
  CHECK_THROWS_AS(save_html({}, folder / "none/a.html"), io_error);
  CHECK_THROWS_AS(save_html({}, folder / "a.html", {.up = {0, 0, 0}}), invalid_argument);
  CHECK_THROWS_AS(save_html({}, folder / "a.html", {.camera = view_options{.angle = 200}}), invalid_argument);
  CHECK(folder.num_files() == 0);
}
