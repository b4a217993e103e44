#include <concino/io/detail/obj/obj_corner_values.hpp>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

using uv = std::array<double, 2>;
const std::string obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

template<class T, class M>
std::vector<T> corner_values(const M& m, const char* name) {
  std::vector<T> all;
  if (const auto u = find_corner_property<T>(m, name))
    for (const auto p : polys(m))
      for (const T& x : u.of(p)) all.push_back(x);
  return all;
}
polygonmesh from_obj(const std::string& text, load_report* report = nullptr) { return load_text<polygonmesh>(text, file_format::obj, {.report = report}); }
bool is_none(const uv& t) { return std::isnan(t[0]) && std::isnan(t[1]); }

}  // namespace

TEST_CASE("obj_corner_values: texture coordinates and normals become properties of corners") {
  load_report r;
  const auto m = from_obj(obj_square + "vt 0.25 0.5\nvt 1 0\nvt 0.125\nvn 0 0 1\nvn 0 1 0\nf 1/1/1 2/2/1 3/3/2\nf -4/-1/-1 3/2/1 4/1/2\n", &r);
  CHECK(corner_values<uv>(m, "texture") == std::vector<uv>{{0.25, 0.5}, {1, 0}, {0.125, 0}, {0.125, 0}, {1, 0}, {0.25, 0.5}});
  CHECK(corner_values<vec3>(m, "normal") == std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}});
  CHECK(r.skipped.empty());
  CHECK(r.notes.empty());
  const auto only_normals = from_obj(obj_square + "vn 0 0 1\nf 1//1 2//1 3//1\n");
  CHECK(!find_corner_property<uv>(only_normals, "texture"));
  CHECK(corner_values<vec3>(only_normals, "normal").size() == 3);
  CHECK(corner_values<uv>(from_obj("f 1/1 2/1 3/1\n" + obj_square + "vt 3 4\n"), "texture") == std::vector<uv>(3, uv{3, 4}));
}

TEST_CASE("obj_corner_values: corners without a value have not-a-number") {
  const auto m = from_obj(obj_square + "vt 0 1\nvn 0 0 1\nf 1 2 3 4\nf 1/1 2 3//1\nf 1 2 3\n");
  const auto t = corner_values<uv>(m, "texture");
  const auto n = corner_values<vec3>(m, "normal");
  REQUIRE(t.size() == 10);
  REQUIRE(n.size() == 10);
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(is_none(t[k]) == (k != 4));
    CHECK(concino::detail::is_no_corner_value(n[k]) == (k != 6));
  }
  CHECK(t[4] == uv{0, 1});
  CHECK(n[6] == vec3{0, 0, 1});
}

TEST_CASE("obj_corner_values: values that are not finite numbers, a third number, and unused values are reported") {
  load_report r;
  const auto m = from_obj(obj_square + "vt nan nan\nvt 1 2 3\nvt 0.5 0.5 0\nvn -nan(ind) 0 0\nvn 0 0\nvt\nvt 1 x\nvn 1 0 0 5\nvt 7 7 # c\nf 1/1/1 2/2/2 3/3/3\nf 1/4 2/5 3/6\n", &r);
  const auto t = corner_values<uv>(m, "texture");
  CHECK(is_none(t[0]));
  CHECK(t[1] == uv{1, 2});
  CHECK(t[2] == uv{0.5, 0.5});
  CHECK(is_none(t[3]));
  CHECK(is_none(t[4]));
  CHECK(t[5] == uv{7, 7});
  CHECK(corner_values<vec3>(m, "normal")[2] == vec3{1, 0, 0});
  CHECK(r.skipped == std::vector<std::string>{"1 texture coordinates with a third number other than 0: the number"});
  CHECK(r.notes == std::vector<std::string>{
                       "5 texture coordinates (vt) or normals (vn) are not finite numbers, so that their corners have no value; the first on line 5"});
  from_obj(obj_square + "vt 0 0\nvt 1 1\nvn 0 0 1\nf 1/2 2/2 3/2\n", &r);
  CHECK(r.skipped == std::vector<std::string>{"1 texture coordinates (vt) that no corner has", "1 normals (vn) that no corner has"});
}

TEST_CASE("obj_corner_values: each distinct value is written once, in the order of the corners") {
  polygonmesh m = from_obj(obj_square + "f 1 2 3 4\nf 1 3 2\n");
  auto t = corner_property<uv>(m, "texture");
  auto n = corner_property<vec3>(m, "normal");
  const poly_id p{0}, q{1};
  for (unsigned k = 0; k < 4; ++k) t[{p, k}] = {0.5 * (k % 2), 0}, n[{p, k}] = concino::detail::no_corner_value<vec3>();
  for (unsigned k = 0; k < 3; ++k) t[{q, k}] = {0.5, 0}, n[{q, k}] = {0, 0, 1};
  t[{q, 1}] = concino::detail::no_corner_value<uv>();
  t[{q, 2}] = {-0.0, 0};
  n[{p, 1}] = {0.1, 0, 0};
  n[{q, 1}] = {0.1, 0, 0};
  save_report lost;
  const std::string text = save_text(m, file_format::obj, {.report = &lost});
  CHECK(text == "# 4 verts, 2 polys\n" + obj_square + "vt 0 0\nvt 0.5 0\nvt -0 0\nvn 0.1 0 0\nvn 0 0 1\nf 1/1 2/2/1 3/1 4/2\nf 1/2/2 3//1 2/3/2\n");
  CHECK(lost.lost.empty());
  load_report r;
  const auto again = from_obj(text, &r);
  CHECK(r.skipped.empty());
  CHECK(save_text(again, file_format::obj) == text);
  n[{p, 0}] = {0, std::numeric_limits<double>::infinity(), 0};
  save_text(m, file_format::obj, {.report = &lost});
  CHECK(lost.lost == std::vector<std::string>{"1 texture coordinates or normals of corners that are not finite"});
  CHECK_THROWS_AS(save_text(m, file_format::obj, {.strict = true}), unsupported);
}

TEST_CASE("obj_corner_values: distinct values are found among many") {
  concino::detail::distinct_corner_values<uv> all;
  std::set<uv> expected;
  for (int i = 0; i < 5000; ++i) {
    const uv x{(i * 7919 % 701) / 16.0, i % 3 - 1.0};
    expected.insert(x);
    const auto k = all.add(x);
    REQUIRE(k < all.values().size());
    CHECK(all.values()[k] == x);
  }
  CHECK(all.values().size() == expected.size());
}

TEST_CASE("obj_corner_values: corpus files keep their texture coordinates, and are saved again as the same bytes") {
  CONCINO_CORPUS_OR_SKIP(file, "tri/spot_textured.obj");
  load_report r;
  const auto m = load<trimesh>(file, {.report = &r});
  CHECK(r.skipped.empty());
  const auto t = corner_values<uv>(m, "texture");
  CHECK(t.size() == 3 * num_polys(m));
  CHECK(std::none_of(t.begin(), t.end(), is_none));
  CHECK(std::set<uv>(t.begin(), t.end()).size() <= 3225);
  CHECK(std::set<uv>(t.begin(), t.end()).size() > 2930);
  const std::string text = save_text(m, file_format::obj);
  const auto again = load_text<trimesh>(text, file_format::obj);
  CHECK(corner_values<uv>(again, "texture") == t);
  CHECK(save_text(again, file_format::obj) == text);
}
