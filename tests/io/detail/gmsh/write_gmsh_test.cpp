#include <concino/io/detail/gmsh/write_gmsh.hpp>

#include <concino/io/gmsh.hpp>
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh.hpp>
#include <concino/mesh/corner_property.hpp>

#include <support/kinds.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

/// A mesh with values of every kind that Gmsh files hold.
template<class M>
M with_values() {
  M m = grid<M>(2);
  int i = 0;
  for (const auto v : verts(m)) {
    ++i;
    vert_property<int>(m, "label")[v] = i % 3;
    vert_property<double>(m, "heat")[v] = i == 5 ? std::numeric_limits<double>::quiet_NaN() : 0.1 * i;
    vert_property<vec3>(m, "flow")[v] = {1.0 / i, -0.0, 1e300};
  }
  for (const auto e : edges(m)) {
    ++i;
    edge_property<int>(m, "label")[e] = i % 2;
    edge_property<int>(m, "entity_tag")[e] = i % 2 ? 40 : i % 3 == 0 ? 41 : 0;
    edge_property<double>(m, "length")[e] = i % 5 == 0 ? i : 0;
  }
  for (const auto p : polys(m)) {
    poly_property<int>(m, "label")[p] = --i % 4 - 1;
    poly_property<double>(m, "length")[p] = i;
    poly_property<std::array<double, 9>>(m, "tensor")[p][8] = i;
  }
  if constexpr (dimension_v<M> == 3)
    for (const auto f : faces(m)) {
      ++i;
      face_property<int>(m, "label")[f] = i % 4 == 0 ? 9 : 0;
      face_property<int>(m, "entity")[f] = 1;
      face_property<vec3>(m, "force")[f] = {0, 0, i % 7 == 0 ? 1.0 : 0.0};
    }
  auto& names = mesh_property<label_names>(m, "label_names")->names;
  names = {{element_kind::poly, 2, "steel", {}}, {element_kind::edge, 1, "", {}}, {element_kind::vert, 2, "a b", {}}, {element_kind::poly, 1, "of none", {}}};
  if (dimension_v<M> == 3) names.push_back({element_kind::face, 9, std::string(200, 'x'), {}});
  return m;
}

template<class T, class A, class B, class R>
std::size_t num_different(const R& elements, const A& a, const B& b) {
  std::size_t n = 0;
  for (const auto x : elements) n += !(a[x] == b[x]) && a[x] == a[x];
  return n;
}

template<class M>
std::size_t num_wrong(const M& a, const M& b) {
  const auto of_verts = [&]<class T>(const char* name, T) { return num_different<T>(verts(a), find_vert_property<T>(a, name), find_vert_property<T>(b, name)); };
  const auto of_edges = [&]<class T>(const char* name, T) { return num_different<T>(edges(a), find_edge_property<T>(a, name), find_edge_property<T>(b, name)); };
  const auto of_polys = [&]<class T>(const char* name, T) { return num_different<T>(polys(a), find_poly_property<T>(a, name), find_poly_property<T>(b, name)); };
  std::size_t n = of_verts("label", int()) + of_verts("heat", double()) + of_verts("flow", vec3()) + of_edges("label", int()) + of_edges("length", double()) +
                  of_polys("label", int()) + of_polys("length", double()) + of_polys("tensor", std::array<double, 9>());
  for (const auto e : edges(a))  // edges that are listed for their length have an entity too
    if (const int tag = find_edge_property<int>(a, "entity_tag")[e]; tag != 0) n += find_edge_property<int>(b, "entity_tag")[e] != tag;
  for (const auto v : verts(a)) n += !(point(a, v) == point(b, v));
  for (const auto p : polys(a)) n += raw(adj_p2v(a, p)) != raw(adj_p2v(b, p));
  if constexpr (dimension_v<M> == 3)
    for (const char* name : {"label", "entity"}) n += num_different<int>(faces(a), find_face_property<int>(a, name), find_face_property<int>(b, name));
  return n + !(*find_mesh_property<label_names>(a, "label_names") == *find_mesh_property<label_names>(b, "label_names"));
}

const trimesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}});

/// The lines of a section.
std::string section(const std::string& text, const std::string& name) {
  const std::size_t first = text.find("$" + name + "\n") + name.size() + 2;
  return text.substr(first, text.find("$End" + name) - first);
}

}  // namespace

TEST_CASE_TEMPLATE("write_gmsh: values of all elements are read back, and written as the same bytes", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const M m = with_values<M>();
  for (const bool binary : {false, true}) {
    save_report saved;
    const std::string text = save_text(m, file_format::gmsh, {.report = &saved, .binary = binary});
    CHECK(saved.lost.empty());
    CHECK(saved.notes == (dimension_v<M> == 3 ? list{"1 names of labels have more than the 127 bytes that Gmsh reads"} : list{}));
    load_report r;
    const M again = load_text<M>(text, file_format::gmsh, {.report = &r});
    CHECK(r.skipped.empty());
    CHECK(r.notes.empty());
    CHECK(num_wrong(m, again) == 0);
    CHECK(save_text(again, file_format::gmsh, {.binary = binary}) == text);
    const M other = load_text<M>(save_text(m, file_format::gmsh, {.binary = !binary}), file_format::gmsh);
    CHECK(save_text(other, file_format::gmsh, {.binary = binary}) == text);
  }
}

TEST_CASE("write_gmsh: the form of the files") {
  const std::string nodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0.5\n$EndNodes\n";
  CHECK(save_text(triangle, file_format::gmsh) == "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes + "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n");
  const std::string binary = save_text(triangle, file_format::gmsh, {.binary = true});
  CHECK(binary.starts_with(std::string("$MeshFormat\n2.2 1 8\n\1\0\0\0\n$EndMeshFormat\n$Nodes\n3\n\1\0\0\0", 50)));
  CHECK(binary.ends_with(std::string("\n$EndNodes\n$Elements\n1\n\2\0\0\0\1\0\0\0\2\0\0\0\1\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0\n$EndElements\n", 73)));
  trimesh m = triangle;
  mesh_property<label_names>(m, "label_names")->names = {{element_kind::poly, 4, "a b", {}}};
  poly_property<int>(m, "label")[poly_id{0}] = 4;
  edge_property<int>(m, "entity")[edge_id{0}] = 1;
  vert_property<int>(m, "label")[vert_id{2}] = 1;
  vert_property<int>(m, "entity")[vert_id{1}] = 1;
  poly_property<float>(m, "x")[poly_id{0}] = 0.5f;
  save_report r;
  const std::string text = save_text(m, file_format::gmsh, {.report = &r});
  CHECK(section(text, "PhysicalNames") == "1\n2 4 \"a b\"\n");
  CHECK(section(text, "Elements").starts_with("4\n1 2 2 4 4 1 2 3\n2 1 2 0 1 "));
  CHECK(section(text, "Elements").ends_with("\n3 15 2 0 2 2\n4 15 2 1 1 3\n"));
  CHECK(section(text, "ElementData") == "1\n\"x\"\n1\n0\n3\n0\n1\n1\n1 0.5\n");
  CHECK(r.lost == list{"poly property \"x\": its numbers are written as doubles, and read again as such"});
  CHECK(r.notes.empty());
  CHECK(find_poly_property<double>(load_text<trimesh>(text, file_format::gmsh), "x")[poly_id{0}] == 0.5);
  CHECK(load_text<trimesh>(save_text(trimesh(), file_format::gmsh), file_format::gmsh).points().empty());
  CHECK(num_polys(load_text<tetmesh>(save_text(tetmesh(), file_format::gmsh, {.binary = true}), file_format::gmsh)) == 0);
}

TEST_CASE("write_gmsh: elements of one entity have one label") {
  trimesh m = grid<trimesh>(2);
  const auto label = poly_property<int>(m, "label"), tag = poly_property<int>(m, "entity_tag");
  const int labels[] = {0, 7, 7, 3, 3, -2, 0, 5}, tags[] = {3, 3, 3, 0, 8, -1, 0, 0};
  for (const auto p : polys(m)) label[p] = labels[p.raw()], tag[p] = tags[p.raw()];
  save_report r;
  const std::string text = save_text(m, file_format::gmsh, {.report = &r});
  CHECK(r.lost == list{"\"entity_tag\" of 3 elements: tags are positive, and elements of one entity have one label"});
  const auto back = load_text<trimesh>(text, file_format::gmsh);
  std::set<std::pair<int, int>> pairs;
  std::set<int> of_tags;
  for (const auto p : polys(m)) {
    CHECK(find_poly_property<int>(back, "label")[p] == labels[p.raw()]);
    const int t = find_poly_property<int>(back, "entity_tag")[p];
    CHECK(t > 0);
    pairs.emplace(t, labels[p.raw()]);
    of_tags.insert(t);
  }
  CHECK(find_poly_property<int>(back, "entity_tag")[poly_id{0}] == 3);
  CHECK(find_poly_property<int>(back, "entity_tag")[poly_id{1}] == 7);
  CHECK(find_poly_property<int>(back, "entity_tag")[poly_id{7}] == 5);
  CHECK(pairs.size() == of_tags.size());
  CHECK(save_text(back, file_format::gmsh) == text);
}

TEST_CASE("write_gmsh: what Gmsh files do not hold is lost with a word, or refused") {
  trimesh m = triangle;
  mesh_property<label_names>(m, "label_names")->names = {
      {element_kind::poly, 1, "a\"b", {}}, {element_kind::face, 1, "a", {}}, {element_kind::poly, 2, "c", {"type wall;"}}, {element_kind::poly, 3, "d\ne", {}}};
  vert_property<std::int64_t>(m, "count");
  vert_property<double>(m, "a\"b");
  vert_property<double>(m, "label");
  poly_property<std::string>(m, "group");
  poly_property<std::array<double, 2>>(m, "uv");
  edge_property<double>(m, "sharp");
  mesh_property<double>(m, "time");
  corner_property<std::array<double, 2>>(m, "texture");
  save_report r;
  save_text(m, file_format::gmsh, {.report = &r});
  CHECK(r.lost == list{"3 names of labels: with line ends or quotation marks, or of elements that the mesh does not have", "1 lines about labels in \"label_names\"",
                       "edge property \"sharp\", which has default values only: .msh lists elements with other values", "vert property \"count\": .msh cannot store it",
                       "vert property \"a\"b\": .msh cannot store it", "vert property \"label\": .msh cannot store it", "poly property \"group\": .msh cannot store it",
                       "poly property \"uv\": .msh cannot store it", "mesh property \"time\": .msh cannot store it", "corner property \"texture\": .msh cannot store it"});
  CHECK_THROWS_AS(save_text(m, file_format::gmsh, {.strict = true}), unsupported);
  CHECK_THROWS_WITH_AS(save_text(polygonmesh({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4}}), file_format::gmsh),
                       "text: .msh cannot hold poly 0, a polygon of 5 verts; save it as .obj, .ply or .vtu", unsupported);
  auto octahedron = load_text<polyhedralmesh>("6 8 1\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n3 1 2 5\n3 2 3 5\n3 3 4 5\n3 4 1 5\n3 2 1 6\n3 3 2 6\n3 4 3 6\n3 1 4 6\n8 1 2 3 4 5 6 7 8\n",
                                              file_format::hedra);
  CHECK_THROWS_WITH_AS(save_text(octahedron, file_format::gmsh),
                       "text: .msh cannot hold poly 0, a polyhedron of 8 faces that is not a tet, hex, prism or pyramid; save it as .hedra", unsupported);
}
