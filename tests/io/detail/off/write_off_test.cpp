#include <concino/io/detail/off/write_off.hpp>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>

#include <support/kinds.hpp>
#include <support/reading.hpp>
#include <support/temporary.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;
using texture = std::array<double, 2>;

template<class M>
bool same(const M& a, const M& b) {
  if (num_verts(a) != num_verts(b) || num_polys(a) != num_polys(b)) return false;
  for (const auto v : verts(a))
    if (!(point(a, v) == point(b, v))) return false;
  for (const auto p : polys(a))
    if (raw(adj_p2v(a, p)) != raw(adj_p2v(b, p))) return false;
  return true;
}

/// A grid with different properties at every element.
template<class M>
M dressed(unsigned n, bool bytes) {
  M m = grid<M>(n);
  std::mt19937 random(7);
  const auto part = [&] {
    const auto x = static_cast<std::uint32_t>(random());
    return bytes ? static_cast<float>((x >> 8) % 256 / 255.0) : static_cast<float>(x) / 4294967296.0f;
  };
  const auto color = vert_property<rgba>(m, "color");
  const auto normal = vert_property<vec3>(m, "normal");
  const auto where = vert_property<texture>(m, "texture");
  const auto paint = poly_property<rgba>(m, "color");
  for (const auto v : verts(m)) {
    color[v] = {part(), part(), part(), part()};
    normal[v] = {-0.1, 1.0 / 3, 1e-300};
    where[v] = {1.0 / static_cast<double>(static_cast<std::uint32_t>(random()) | 1u), -0.0};
  }
  for (const auto p : polys(m)) paint[p] = {part(), part(), part(), part()};
  return m;
}

}  // namespace

TEST_CASE_TEMPLATE("write_off: loading gives the same mesh to the last bit", M, trimesh, quadmesh, polygonmesh) {
  const temporary_folder dir;
  for (const bool bytes : {false, true})
    for (const M& m : {dressed<M>(1, bytes), dressed<M>(5, bytes)}) {
      save_report r;
      save(m, dir / "a.off", {.report = &r});
      CHECK(r.lost.empty());
      CHECK(dir.num_files() == 1);
      const M again = load<M>(dir / "a.off");
      CHECK(same(m, again));
      std::size_t wrong = 0;
      for (const auto v : verts(m)) {
        wrong += find_vert_property<rgba>(m, "color")[v] != find_vert_property<rgba>(again, "color")[v];
        wrong += !(find_vert_property<vec3>(m, "normal")[v] == find_vert_property<vec3>(again, "normal")[v]);
        wrong += find_vert_property<texture>(m, "texture")[v] != find_vert_property<texture>(again, "texture")[v];
      }
      for (const auto p : polys(m)) wrong += find_poly_property<rgba>(m, "color")[p] != find_poly_property<rgba>(again, "color")[p];
      CHECK(wrong == 0);
    }
  for (const M& m : {grid<M>(1), grid<M>(4), M()}) {
    const M again = load_text<M>(save_text(m, file_format::off), file_format::off);
    CHECK(same(m, again));
    CHECK(property_list(again).empty());
  }
}

TEST_CASE("write_off: colours of polys are integers if they are multiples of 1/255, else reals") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  poly_property<rgba>(m, "color")[poly_id{0}] = {1, 0, 0.2f};
  poly_property<rgba>(m, "color")[poly_id{1}] = {1, 0, 0.5f};
  CHECK(save_text(m, file_format::off) == "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 51 255\n3 0 2 1 1.0 0.0 0.5 1.0\n");
}

TEST_CASE("write_off: labels are saved as indices of colours, if there are no colours") {
  auto m = grid<quadmesh>(2);
  const auto label = poly_property<int>(m, "label");
  label[poly_id{1}] = std::numeric_limits<int>::min();
  label[poly_id{2}] = std::numeric_limits<int>::max();
  save_report r;
  const auto again = load_text<quadmesh>(save_text(m, file_format::off, {.report = &r}), file_format::off);
  for (const auto p : polys(m)) CHECK(find_poly_property<int>(again, "label")[p] == label[p]);
  CHECK(r.lost.empty());
  poly_property<rgba>(m, "color");
  vert_property<int>(m, "label");
  vert_property<int>(m, "color");
  save_text(m, file_format::off, {.report = &r});
  CHECK(r.lost == list{"poly property \"label\": .off cannot store it", "vert property \"label\": .off cannot store it",
                       "vert property \"color\": .off cannot store it"});
}

TEST_CASE("write_off: binary rounds numbers to floats, and keeps colours and labels") {
  for (const bool bytes : {false, true}) {
    const auto m = dressed<quadmesh>(2, bytes);
    save_report r;
    const auto text = save_text(m, file_format::off, {.report = &r, .binary = true});
    CHECK(r.lost == list{"binary .off holds floats: coordinates and other numbers were rounded to 32 bits"});
    const auto again = load_text<quadmesh>(text, file_format::off);
    CHECK(save_text(again, file_format::off, {.report = &r, .binary = true}) == text);
    CHECK(r.lost.empty());
    CHECK(num_polys(again) == num_polys(m));
    for (const auto v : verts(m)) CHECK(find_vert_property<rgba>(m, "color")[v] == find_vert_property<rgba>(again, "color")[v]);
    for (const auto p : polys(m)) CHECK(find_poly_property<rgba>(m, "color")[p] == find_poly_property<rgba>(again, "color")[p]);
  }
  auto m = grid<trimesh>(1);
  poly_property<int>(m, "label")[poly_id{1}] = -3;
  const auto again = load_text<trimesh>(save_text(m, file_format::off, {.binary = true}), file_format::off);
  CHECK(find_poly_property<int>(again, "label")[poly_id{1}] == -3);
  CHECK(same(m, again));
  CHECK_THROWS_AS(save_text(m, file_format::obj, {.binary = true}), unsupported);
}

TEST_CASE("write_off: binary rounds labels to floats that are labels") {
  auto m = grid<trimesh>(1);
  auto label = poly_property<int>(m, "label");
  constexpr int least = std::numeric_limits<int>::min(), largest = std::numeric_limits<int>::max();
  for (const int written : {least, least + 1, 0x1000001, largest}) {
    CAPTURE(written);
    label[poly_id{1}] = written;
    const auto text = save_text(m, file_format::off, {.binary = true});
    const auto again = load_text<trimesh>(text, file_format::off);
    CHECK(find_poly_property<int>(again, "label")[poly_id{1}] == doctest::Approx(written).epsilon(1e-7));
    CHECK(save_text(again, file_format::off, {.binary = true}) == text);
  }
}

TEST_CASE("write_off: throws for volumes and points that are not finite; other numbers become 0") {
  CHECK_THROWS_AS(save_text(grid<tetmesh>(1), file_format::off), unsupported);
  auto m = grid<trimesh>(1);
  vert_property<rgba>(m, "color")[vert_id{0}].r = std::numeric_limits<float>::infinity();
  poly_property<rgba>(m, "color")[poly_id{0}].a = std::numeric_limits<float>::quiet_NaN();
  save_report r;
  const auto again = load_text<trimesh>(save_text(m, file_format::off, {.report = &r}), file_format::off);
  CHECK(r.lost == list{"2 numbers of colours and other properties that are not finite: written as 0"});
  CHECK(find_poly_property<rgba>(again, "color")[poly_id{0}] == rgba{1, 1, 1, 0});
  m = grid<trimesh>(1);
  set_point(m, vert_id{1}, vec3{0, std::numeric_limits<double>::infinity(), 0});
  for (const bool binary : {false, true}) {
    CHECK_THROWS_AS(save_text(m, file_format::off, {.binary = binary}), invalid_mesh);
  }
  const auto s = load_text<polygonmesh>(save_text(user_mesh::surface_example(), file_format::off), file_format::off);
  CHECK(num_polys(s) == 4);
  CHECK(num_verts(s) == 8);
}

TEST_CASE("write_off: components of colours read back as the same floats") {
  std::mt19937 random(3);
  std::vector<float> written;
  text_sink out;  // one for all: its buffer is large
  for (int i = 0; i < 20000; ++i) {
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(x)) continue;
    written.push_back(x);
    concino::detail::write_float(out, x, true);
    out << '\n';
  }
  std::istringstream lines(std::move(out).release());
  std::string text;
  for (const float x : written) {
    REQUIRE(std::getline(lines, text));
    double back = 0;
    CHECK(parse_real(text.data(), text.data() + text.size(), back) == text.data() + text.size());
    if (static_cast<float>(back) != x) FAIL_CHECK(text);
    if (text.find_first_of(".e") == text.npos) FAIL_CHECK(text);
  }
}

TEST_CASE("write_off: numbers too large for floats are refused in binary") {
  auto m = grid<trimesh>(1);
  set_point(m, vert_id{1}, vec3{0, 1e39, 0});
  CHECK_THROWS_WITH_AS(save_text(m, file_format::off, {.binary = true}), "text: binary .off cannot hold a number that is too large for floats; save it as text, with binary = false", unsupported);
  CHECK(load_text<trimesh>(save_text(m, file_format::off), file_format::off).points()[1].y == 1e39);
}

TEST_CASE("write_off: a mesh without verts is written without their properties") {
  trimesh m;
  vert_property<vec3>(m, "normal");
  vert_property<rgba>(m, "color");
  CHECK(save_text(m, file_format::off) == "OFF\n0 0 0\n");
}
