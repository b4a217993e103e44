#include <concino/io/detail/ply/write_ply.hpp>

#include <concino/io/ply.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <support/kinds.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;
using texture = std::array<double, 2>;

/// A grid with properties of all kinds and of many types, whose names are like those with a meaning.
template<class M>
M with_values(unsigned n, bool bytes) {
  M m = grid<M>(n);
  std::mt19937 random(11);
  const auto real = [&] { return static_cast<double>(random()) / 3 - 1e9; };
  const auto part = [&] { return bytes ? static_cast<float>(static_cast<double>(random() % 256) / 255.0) : static_cast<float>(random()) / 4294967296.0f; };
  const auto x = vert_property<double>(m, "x"), nx = vert_property<double>(m, "nx"), end = vert_property<double>(m, "end_x"), other_end = vert_property<double>(m, "end_y");
  const auto color = vert_property<rgba>(m, "color");
  const auto paint = vert_property<rgba>(m, "a paint%");
  const auto normal = vert_property<vec3>(m, "normal"), flow = vert_property<vec3>(m, "flow");
  const auto where = vert_property<texture>(m, "texture");
  const auto tensor = vert_property<std::array<float, 6>>(m, "tensor");
  const auto weights = vert_property<std::vector<float>>(m, "weights");
  for (const auto v : verts(m)) {
    x[v] = real(), nx[v] = real(), end[v] = real(), other_end[v] = std::numeric_limits<double>::infinity();
    color[v] = {part(), part(), part(), part()};
    paint[v] = {part(), part(), part(), part()};
    normal[v] = {-0.1, 1.0 / 3, 1e-300};
    flow[v] = {real(), -0.0, real()};
    where[v] = {real(), real()};
    for (float& t : tensor[v]) t = static_cast<float>(real());
    weights[v].assign(random() % 4, static_cast<float>(real()));
  }
  const auto label = poly_property<int>(m, "label");
  const auto small = poly_property<std::int8_t>(m, "t");
  const auto large = poly_property<std::uint16_t>(m, "vertex_indices");
  const auto marks = poly_property<std::vector<int>>(m, "vertex_index");
  const auto poly_normal = poly_property<vec3>(m, "normal");
  for (const auto p : polys(m)) {
    label[p] = static_cast<int>(random()), small[p] = -7, large[p] = 65535;
    marks[p].assign(random() % 300, 5);
    poly_normal[p] = {0, 0, real()};
  }
  auto corners = corner_property<texture>(m, "texture");
  for (const auto p : polys(m))
    for (texture& t : corners.of(p)) t = p.raw() % 2 ? texture{real(), real()} : texture{NAN, NAN};
  const auto sharp = edge_property<std::uint8_t>(m, "sharp");
  const auto crease = edge_property<double>(m, "crease");
  for (const auto e : edges(m))
    if (random() % 3 == 0) sharp[e] = 1, crease[e] = real();
  return m;
}

template<class T, class A, class B, class R>
std::size_t num_different(const R& elements, const A& a, const B& b) {
  std::size_t n = 0;
  for (const auto x : elements) n += !(a[x] == b[x]);
  return n;
}

template<class M>
std::size_t num_wrong(const M& a, const M& b) {
  const auto of_verts = [&]<class T>(const char* name, T) { return num_different<T>(verts(a), find_vert_property<T>(a, name), find_vert_property<T>(b, name)); };
  const auto of_polys = [&]<class T>(const char* name, T) { return num_different<T>(polys(a), find_poly_property<T>(a, name), find_poly_property<T>(b, name)); };
  std::size_t n = 0;
  for (const char* name : {"x", "nx", "end_x", "end_y"}) n += of_verts(name, double());
  n += of_verts("color", rgba()) + of_verts("normal", vec3()) + of_verts("flow", vec3()) + of_verts("texture", texture()) + of_verts("tensor", std::array<float, 6>()) +
       of_verts("weights", std::vector<float>());
  n += of_polys("label", int()) + of_polys("t", std::int8_t()) + of_polys("vertex_indices", std::uint16_t()) + of_polys("vertex_index", std::vector<int>()) + of_polys("normal", vec3());
  n += num_different<double>(edges(a), find_edge_property<double>(a, "crease"), find_edge_property<double>(b, "crease"));
  for (const auto v : verts(a)) n += !(point(a, v) == point(b, v));
  for (const auto p : polys(a)) {
    n += raw(adj_p2v(a, p)) != raw(adj_p2v(b, p));
    for (unsigned k = 0; p.raw() % 2 && k < num_elements(adj_p2v(a, p)); ++k)
      n += find_corner_property<texture>(a, "texture")[{p, k}] != find_corner_property<texture>(b, "texture")[{p, k}];
  }
  return n;
}

}  // namespace

TEST_CASE_TEMPLATE("write_ply: loading gives the same mesh and properties to the last bit", M, trimesh, quadmesh, polygonmesh) {
  for (const bool binary : {false, true})
    for (const bool bytes : {false, true}) {
      const M m = with_values<M>(4, bytes);
      save_report saved;
      load_report loaded;
      const std::string first = save_text(m, file_format::ply, {.report = &saved, .binary = binary});
      CHECK(saved.lost.empty());
      const M back = load_text<M>(first, file_format::ply, {.report = &loaded});
      CHECK(loaded.skipped.empty());
      CHECK(loaded.notes.empty());
      CHECK(num_wrong(m, back) == 0);
      CHECK(find_vert_property<std::array<float, 4>>(back, "a paint%")[vert_id{3}][2] == find_vert_property<rgba>(m, "a paint%")[vert_id{3}].b);
      CHECK(first.find(bytes ? "property uchar red" : "property float red") != first.npos);
      CHECK(save_text(back, file_format::ply, {.binary = binary}) == first);
    }
}

TEST_CASE("write_ply: the form of the files") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}}, {{0, 1, 2}});
  CHECK(save_text(m, file_format::ply) ==
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0.1\n3 0 1 2\n");
  const std::string binary = save_text(m, file_format::ply, {.binary = true});
  CHECK(binary.starts_with("ply\nformat binary_little_endian 1.0\n"));
  CHECK(binary.ends_with(std::string("end_header\n") + std::string(8 * 3, '\0') + std::string("\0\0\0\0\0\0\xf0\x3f", 8) + std::string(8 * 3, '\0') +
                         std::string("\0\0\0\0\0\0\xf0\x3f\x9a\x99\x99\x99\x99\x99\xb9\x3f", 16) + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13)));
  edge_property<int>(m, "label")[edge_id{1}] = 4;
  const auto e = adj_e2v(m, edge_id{1});
  CHECK(save_text(m, file_format::ply).ends_with("3 0 1 2\n" + std::to_string(e[0].raw()) + ' ' + std::to_string(e[1].raw()) + " 4\n"));
  CHECK(load_text<trimesh>(save_text(trimesh(), file_format::ply), file_format::ply).points().empty());
}

TEST_CASE("write_ply: what PLY does not hold is lost with a word, or refused") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  vert_property<std::int64_t>(m, "count");
  poly_property<std::string>(m, "group");
  mesh_property<double>(m, "time");
  edge_property<int>(m, "label");
  auto corners = corner_property<texture>(m, "texture");
  corners[{poly_id{0}, 0}] = {1, 1};
  corners[{poly_id{0}, 1}] = corners[{poly_id{0}, 2}] = {NAN, NAN};
  vert_property<rgba>(m, "color")[vert_id{0}].r = NAN;
  save_report r;
  save_text(m, file_format::ply, {.report = &r});
  CHECK(r.lost == list{"corner property \"texture\" of 1 polys that have it at some corners only: .ply cannot store it",
                       "edge property \"label\", which has default values only: .ply lists edges with other values", "vert property \"count\": .ply cannot store it",
                       "poly property \"group\": .ply cannot store it", "mesh property \"time\": .ply cannot store it", "corner property \"texture\": .ply cannot store it",
                       "1 numbers of colours and other properties that are not finite: written as 0"});
  CHECK_THROWS_AS(save_text(m, file_format::ply, {.strict = true}), unsupported);
  CHECK_THROWS_WITH_AS(save_text(tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), file_format::ply), "text: .ply cannot hold volumes, unless options.as_boundary is set; save it as .mesh or .hedra",
                       unsupported);
}
