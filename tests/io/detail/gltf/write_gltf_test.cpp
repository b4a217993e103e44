#include <concino/io/detail/gltf/write_gltf.hpp>

#include <concino/io/gltf.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

std::uint32_t word(const std::string& s, std::size_t at) {
  std::uint32_t x = 0;
  for (std::size_t i = 4; i-- > 0;) x = x << 8 | static_cast<unsigned char>(s[at + i]);
  return x;
}

/// The two chunks of a file, whose sizes are checked.
struct chunks {
  std::string json, bytes;

  explicit chunks(const std::string& file) {
    REQUIRE(file.size() >= 20);
    CHECK(file.starts_with("glTF"));
    CHECK(word(file, 4) == 2);
    CHECK(word(file, 8) == file.size());
    const std::size_t n = word(file, 12);
    CHECK(n % 4 == 0);
    CHECK(file.substr(16, 4) == "JSON");
    json = file.substr(20, n);
    if (file.size() == 20 + n) return;
    CHECK(word(file, 20 + n) == file.size() - 28 - n);
    CHECK(file.substr(24 + n, 4) == std::string("BIN\0", 4));
    bytes = file.substr(28 + n);
    CHECK(bytes.size() % 4 == 0);
  }
  float real(std::size_t i) const { return std::bit_cast<float>(word(bytes, 4 * i)); }
  std::uint32_t integer(std::size_t i) const { return word(bytes, 4 * i); }
};

const trimesh triangle({{0, 0, 0.5}, {1, 0, -2}, {0, 1, 0}}, {{0, 1, 2}});
chunks written(const auto& m, save_report* r = nullptr, save_options options = {}) {
  options.report = r;
  return chunks(save_text(m, file_format::gltf, options));
}

}  // namespace

TEST_CASE("write_gltf: positions with their bounds, and indices") {
  save_report r;
  const chunks c = written(triangle, &r, {.strict = true});
  CHECK(c.json.starts_with(R"({"asset":{"version":"2.0","generator":"concino"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{)"
                           R"("attributes":{"POSITION":0},"indices":1,"material":0,"mode":4}]}],"materials":[{"pbrMetallicRoughness":{"metallicFactor":0},"doubleSided":true}],)"
                           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,-2],"max":[1,1,0.5]},)"
                           R"({"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}],)"
                           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36,"target":34962},{"buffer":0,"byteOffset":36,"byteLength":12,"target":34963}],)"
                           R"("buffers":[{"byteLength":48}]})"));
  CHECK(c.bytes.size() == 48);
  CHECK(c.real(2) == 0.5f);
  CHECK(c.real(5) == -2.f);
  for (std::uint32_t i = 0; i < 3; ++i) CHECK(c.integer(9 + i) == i);
  CHECK(r.lost.empty());
  const std::string whole = save_text(triangle, file_format::gltf);
  CHECK(save_text(triangle, file_format::gltf, {.binary = true}) == whole);
  const temporary_folder dir;
  save(triangle, dir / "a.GLB");
  save_gltf(triangle, dir / "b");
  CHECK(read_file(dir / "a.GLB") == whole);
  CHECK(read_file(dir / "b") == whole);
}

TEST_CASE("write_gltf: meshes without triangles") {
  save_report r;
  const chunks c = written(trimesh(), &r);
  CHECK(c.json.starts_with(R"({"asset":{"version":"2.0","generator":"concino"},"scene":0,"scenes":[{}]})"));
  CHECK(c.bytes.empty());
  CHECK(r.lost.empty());
  CHECK(written(trimesh({{0, 0, 0}}, {}), &r).bytes.empty());
  CHECK(r.lost == list{"1 verts of no poly: .glb has no mesh without triangles"});
}

TEST_CASE("write_gltf: normals, texture coordinates and colours of verts") {
  trimesh m = triangle;
  auto normal = vert_property<vec3>(m, "normal");
  auto texture = vert_property<std::array<double, 2>>(m, "texture");
  auto color = vert_property<rgba>(m, "color");
  for (const auto v : verts(m)) normal[v] = {0, 0.6, -0.8}, texture[v] = {0.25, 0.75}, color[v] = {0.5f, 0, 1, 1};
  *mesh_property<std::string>(m, "name") = "a \"b\"\\\n\x01 \xc3\xa9 \xff\xed\xa0\x80";
  save_report r;
  chunks c = written(m, &r);
  CHECK(c.json.find(R"("name":"a \"b\"\\\u000a\u0001 )"
                    "\xc3\xa9 \xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"") != std::string::npos);
  CHECK(c.json.find(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3},"indices":4)") != std::string::npos);
  CHECK(c.real(10) == 0.6f);
  CHECK(c.real(18) == 0.25f);
  CHECK(c.real(19) == 0.25f);
  CHECK(c.real(24) == doctest::Approx(0.21404114f));  // 0.5 of a screen as light
  CHECK(c.real(26) == 1.f);
  CHECK(c.json.find("BLEND") == std::string::npos);
  CHECK(r.lost == list{".glb holds floats: coordinates and other numbers were rounded to 32 bits"});

  color[vert_id{1}] = {2, -1, std::nanf(""), 0.5f};
  normal[vert_id{0}] = {0, 0, 2};
  texture[vert_id{0}] = {std::nan(""), 0};
  c = written(m, &r);
  CHECK(c.json.find("NORMAL") == std::string::npos);
  CHECK(c.json.find("\"alphaMode\":\"BLEND\"") != std::string::npos);
  CHECK(c.real(9) == 0);
  CHECK(c.real(19) == 1);
  CHECK(c.real(20) == 0);
  CHECK(c.real(21) == 0);
  CHECK(c.real(22) == 0.5f);
  CHECK(r.lost == list{"1 colours with parts beyond 0 to 1 were limited to that", "vert property \"normal\": .glb cannot store it",
                       "1 numbers of colours and other properties that are not finite: written as 0"});
}

TEST_CASE("write_gltf: colours of polys split the verts where they meet") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}}, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}});
  auto color = poly_property<rgba>(m, "color");
  color[poly_id{0}] = color[poly_id{2}] = {1, 0, 0, 1};
  color[poly_id{1}] = {0, 0, 1, 1};
  save_report r;
  chunks c = written(m, &r, {.strict = true});
  CHECK(r.lost.empty());
  CHECK(r.notes == list{"2 verts were added where polys of different colours meet"});
  CHECK(c.json.find("\"count\":8,\"type\":\"VEC4\"") != std::string::npos);
  const std::size_t colors = 8 * 3, indices = 8 * 7;
  const vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  for (std::size_t i = 0; i < 9; ++i) {
    const std::size_t v = c.integer(indices + i);
    REQUIRE(v < 8);
    CHECK(vec3{c.real(3 * v), c.real(3 * v + 1), c.real(3 * v + 2)} == corners[i]);
    CHECK(c.real(colors + 4 * v) == (i / 3 == 1 ? 0.f : 1.f));
  }
  vert_property<rgba>(m, "color");
  c = written(m, &r);
  CHECK(c.json.find("\"count\":6,\"type\":\"VEC4\"") != std::string::npos);
  CHECK(r.lost == list{"poly property \"color\": .glb cannot store it"});
}

TEST_CASE("write_gltf: polygons and volumes need options, and floats have bounds") {
  const quadmesh q = grid<quadmesh>(1);
  CHECK_THROWS_WITH_AS(save_text(q, file_format::gltf), "text: .glb cannot hold poly 0 of 4 corners, unless options.as_triangles is set; save it as .ply or .obj", unsupported);
  save_report r;
  CHECK(written(q, &r, {.as_triangles = true}).bytes.size() == 12 * 4 + 4 * 6);
  CHECK(r.lost == list{"1 polygons were cut into triangles"});
  CHECK_THROWS_AS(save_text(grid<hexmesh>(1), file_format::gltf), unsupported);
  CHECK(written(grid<hexmesh>(1), &r, {.as_triangles = true, .as_boundary = true}).bytes.size() == 12 * 8 + 4 * 36);
  CHECK_THROWS_AS(save_text(trimesh({{0, 0, 0}, {1e39, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), file_format::gltf), unsupported);
  CHECK_THROWS_AS(save_text(trimesh({{0, 0, 0}, {std::nan(""), 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), file_format::gltf), invalid_mesh);
}

TEST_CASE("write_gltf: bytes that are no UTF-8 are found") {
  for (const char* good : {"a", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xed\x9f\xbf", "\xf4\x8f\xbf\xbf"}) CHECK(concino::detail::utf8_length(good) == std::string_view(good).size());
  for (const char* bad : {"", "\x80", "\xc0\x80", "\xc1\xbf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xc3"})
    CHECK(concino::detail::utf8_length(bad) == 0);
}
