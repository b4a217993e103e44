#include <concino/io/detail/gmsh/read_gmsh.hpp>

#include <concino/io/gmsh.hpp>
#include <concino/io/load_any.hpp>
#include <concino/mesh.hpp>

#include <support/poly_volume.hpp>
#include <support/reading.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

/// A binary file from a text: numbers after `i`, `s` and `d` are integers, sizes and doubles; the rest stays as it is, up to the character `\n`.
std::string binary(const std::string& text, bool big = false, unsigned bytes_of_size = 8) {
  std::string r;
  std::istringstream in(text);
  const auto put = [&](std::uint64_t x, unsigned n) {
    for (unsigned k = 0; k < n; ++k) r += static_cast<char>(x >> 8 * (big ? n - 1 - k : k) & 0xff);
  };
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] != '~') {
      r += line + '\n';
      continue;
    }
    std::istringstream words(line.substr(1));
    char kind = 'i';
    for (std::string w; words >> w;) {
      if (w == "i" || w == "s" || w == "d") kind = w[0];
      else if (kind == 'd') put(std::bit_cast<std::uint64_t>(std::stod(w)), 8);
      else put(static_cast<std::uint64_t>(std::stoll(w)), kind == 'i' ? 4 : bytes_of_size);
    }
    if (in.peek() == '$') r += '\n';
  }
  return r;
}

const std::string head2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", head4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string nodes = "$Nodes\n5\n10 0 0 0\n20 1 0 0\n7 0 1 0\n1000000 0 0 1\n3 0 0 -1\n$EndNodes\n";
const std::string triangles = head2 + nodes + "$Elements\n2\n1 2 2 0 0 10 20 7\n2 2 0 10 20 3\n$EndElements\n";

/// The two tets of one group, two triangles of them, an edge and a vert, in groups with names and without.
const std::string tets4 =
    head4 + "$PhysicalNames\n3\n3 7 \"my \"steel\"\"\n2 5 \"wall\"\n0 5 \"corner\"\n$EndPhysicalNames\n"
            "$Entities\n1 1 2 1\n4 0 0 0 1 5\n2 0 0 0 1 0 0 1 -8 2 4 -5\n1 0 0 0 1 1 0 2 5 6 1 2\n2 0 0 0 1 1 1 0 0\n7 0 0 0 1 1 1 1 7 2 1 2\n$EndEntities\n"
            "$Nodes\n3 5 3 1000000\n0 4 1 1\n10\n0 0 0\n3 7 0 3\n20\n7\n1000000\n1 0 0\n0 1 0\n0 0 1\n2 1 1 1\n3\n0 0 -1 .5 .25\n$EndNodes\n"
            "$Elements\n5 6 1 90\n0 4 15 1\n1 10\n1 2 1 1\n2 20 10\n2 1 2 1\n90 7 20 10\n2 2 2 1\n5 10 20 1000000\n3 7 4 2\n8 10 20 7 1000000\n9 10 7 20 3\n"
            "$EndElements\n";

template<class M>
M gmsh(const std::string& text, const load_options& options = {}) {
  return load_alone<M>(text, file_format::gmsh, options, "t.msh");
}
template<class M = polyhedra_arrays>
std::string says(const std::string& text) {
  return complaint<M>(text, file_format::gmsh);
}
template<class M>
std::string refuses(const std::string& text, const load_options& options = {}) {
  try {
    load_text<M>(text, file_format::gmsh, options, "t.msh");
  } catch (const unsupported& e) {
    return e.what();
  }
  return {};
}
template<class M, class Elements, class Property>
list values(const M&, const Elements& elements, const Property& p) {
  list r;
  for (const auto x : elements) r.push_back(std::to_string(p[x]));
  return r;
}

/// A mesh, its report, and what is the same of all files with the tets above.
void check_tets(const std::string& text, bool has_bounds) {
  load_report r;
  const auto m = load_text<tetmesh>(text, file_format::gmsh, {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CHECK(raw(adj_p2v(m, poly_id{0})) == std::vector<unsigned>{0, 1, 2, 3});
  CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{0, 2, 1, 4});
  CHECK(point(m, vert_id{4}) == vec3{0, 0, -1});
  CHECK(values(m, polys(m), find_poly_property<int>(m, "label")) == list{"7", "7"});
  CHECK(!find_poly_property<int>(m, "entity_tag"));
  const auto label = find_face_property<int>(m, "label"), tag = find_face_property<int>(m, "entity_tag");
  int num = 0;
  for (const auto f : faces(m)) {
    std::vector<unsigned> v = raw(adj_f2v(m, f));
    std::sort(v.begin(), v.end());
    const bool wall = v == std::vector<unsigned>{0, 1, 2}, other = v == std::vector<unsigned>{0, 1, 3};
    CHECK(label[f] == (wall ? 5 : 0));
    CHECK(tag[f] == (wall ? 1 : other ? 2 : 0));
    num += wall + other;
  }
  CHECK(num == 2);
  CHECK(!find_face_property<int>(m, "entity"));
  for (const auto e : edges(m)) CHECK(find_edge_property<int>(m, "label")[e] == (std::max(raw(adj_e2v(m, e))[0], raw(adj_e2v(m, e))[1]) == 1 ? 8 : 0));
  CHECK(values(m, verts(m), find_vert_property<int>(m, "label")) == list{"5", "0", "0", "0", "0"});
  CHECK(values(m, verts(m), find_vert_property<int>(m, "entity_tag")) == list{"4", "0", "0", "0", "0"});
  const label_names names = *find_mesh_property<label_names>(m, "label_names");
  CHECK(names == label_names{{{element_kind::poly, 7, "my \"steel\"", {}}, {element_kind::face, 5, "wall", {}}, {element_kind::vert, 5, "corner", {}}}});
  if (has_bounds)
    CHECK(r.skipped == list{"section Entities: which ones bound others, 5 tags", "more than one physical group of 1 elements: \"label\" is the first one",
                            "the parameters of 1 nodes on entities"});
  CHECK(r.notes.size() == has_bounds);
}

}  // namespace

TEST_CASE("read_gmsh: the example of the manual, in both versions") {
  const std::string values = "$NodeData\n1\n\"A scalar view\"\n1\n0.0\n3\n0\n1\n6\n1 0.0\n2 0.1\n3 0.2\n4 0.0\n5 0.2\n6 0.4\n$EndNodeData\n";
  const std::string by_line = "0. 0. 0.\n1. 0. 0.\n1. 1. 0.\n0. 1. 0.\n2. 0. 0.\n2. 1. 0.\n$EndNodes\n$Elements\n";
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (const std::string& text :
         {head4 + "$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n" + by_line + "1 2 1 2\n2 1 3 2\n1 1 2 3 4\n2 2 5 6 3\n$EndElements\n" + values,
          head2 + "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n$EndNodes\n$Elements\n2\n1 3 2 0 1 1 2 3 4\n2 3 2 0 1 2 5 6 3\n$EndElements\n" + values}) {
      load_report r;
      const auto m = gmsh<quadmesh>(with_line_ends(text, end), {.report = &r});
      CHECK(r.skipped.empty());
      CHECK(r.notes.empty());
      CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{1, 4, 5, 2});
      CHECK(!find_poly_property<int>(m, "label"));
      CHECK(!find_poly_property<int>(m, "entity_tag"));
      CHECK(find_vert_property<double>(m, "A scalar view")[vert_id{5}] == 0.4);
    }
  }
  CHECK(gmsh<surface_arrays>(triangles).points[3] == vec3{0, 0, 1});
  CHECK(raw(gmsh<surface_arrays>(triangles).verts) == std::vector<unsigned>{0, 1, 2, 0, 1, 4});
}

TEST_CASE("read_gmsh: groups and entities become labels, in all forms of the file") {
  load_report r;
  gmsh<tetmesh>(tets4, {.report = &r});
  CHECK(r.notes[0].starts_with("the physical groups of 1 elements contain them in the other direction"));
  check_tets(tets4, true);
  const std::string names = "$PhysicalNames\n3\n3 7 \"my \"steel\"\"\n2 5 \"wall\"\n0 5 \"corner\"\n$EndPhysicalNames\n";
  check_tets(head2 + names + nodes + "$Elements\n6\n1 15 2 5 4 10\n2 1 2 8 2 20 10\n90 2 2 5 1 7 20 10\n5 2 2 0 2 10 20 1000000\n8 4 2 7 7 10 20 7 1000000\n9 4 2 7 0 10 7 20 3\n"
                                      "$EndElements\n", false);
  for (const bool big : {false, true}) {
    check_tets(binary("$MeshFormat\n2.2 1 8\n~ 1\n$EndMeshFormat\n" + names + "$Nodes\n5\n~ i 10 d 0 0 0 i 20 d 1 0 0 i 7 d 0 1 0 i 1000000 d 0 0 1 i 3 d 0 0 -1\n$EndNodes\n$Elements\n6\n"
                      "~ 15 1 2  1 5 4 10  1 1 2  2 8 2 20 10  2 2 2  90 5 1 7 20 10  5 0 2 10 20 1000000  4 1 2  8 7 7 10 20 7 1000000  4 1 1  9 7 10 7 20 3\n$EndElements\n", big), false);
    for (const unsigned size : {4u, 8u})
      check_tets(binary("$MeshFormat\n4.1 1 " + std::to_string(size) + "\n~ 1\n$EndMeshFormat\n" + names +
                        "$Entities\n~ s 1 1 2 1  i 4 d 0 0 0 s 1 i 5  i 2 d 0 0 0 1 0 0 s 1 i -8 s 2 i 4 -5  i 1 d 0 0 0 1 1 0 s 2 i 5 6 s 1 i 2 i 2 d 0 0 0 1 1 1 s 0 0 "
                        "i 7 d 0 0 0 1 1 1 s 1 i 7 s 2 i 1 2\n$EndEntities\n"
                        "$Nodes\n~ s 3 5 3 1000000 i 0 4 1 s 1 10 d 0 0 0  i 3 7 0 s 3 20 7 1000000 d 1 0 0 0 1 0 0 0 1 i 2 1 1 s 1 3 d 0 0 -1 .5 .25\n$EndNodes\n"
                        "$Elements\n~ s 5 6 1 90 i 0 4 15 s 1 1 10 i 1 2 1 s 1 2 20 10 i 2 1 2 s 1 90 7 20 10 i 2 2 2 s 1 5 10 20 1000000 "
                        "i 3 7 4 s 2 8 10 20 7 1000000 9 10 7 20 3\n$EndElements\n", big, size), true);
  }
}

TEST_CASE("read_gmsh: entities are kept where labels do not say the same") {
  const auto text = [](const std::string& elements, int n) { return head2 + nodes + "$Elements\n" + std::to_string(n) + "\n" + elements + "$EndElements\n"; };
  const auto tags_of = [&](const std::string& elements, int n) {
    const auto m = gmsh<trimesh>(text(elements, n));
    const auto tag = find_poly_property<int>(m, "entity_tag");
    return tag ? values(m, polys(m), tag) : list{};
  };
  CHECK(tags_of("1 2 2 3 3 10 20 7\n2 2 2 0 1 10 20 3\n", 2).empty());
  CHECK(tags_of("1 2 2 1 1 10 20 7\n2 2 2 0 2 10 20 3\n", 2).empty());
  CHECK(tags_of("1 2 2 1 0 10 20 7\n2 2 2 2 0 10 20 3\n", 2).empty());
  CHECK(tags_of("1 2 2 3 3 10 20 7\n2 2 2 0 2 10 20 3\n", 2) == list{"3", "2"});
  CHECK(tags_of("1 2 2 0 1 10 20 7\n2 2 2 0 2 10 20 3\n", 2) == list{"1", "2"});
  const auto m = gmsh<trimesh>(text("1 1 2 0 1 10 20\n2 2 2 3 3 10 20 7\n3 2 1 4 10 20 3\n4 15 2 0 1 7\n", 4));
  CHECK(values(m, polys(m), find_poly_property<int>(m, "label")) == list{"3", "4"});
  CHECK(values(m, verts(m), find_vert_property<int>(m, "entity")) == list{"0", "0", "1", "0", "0"});
  CHECK(find_edge_property<int>(m, "entity")[edge_id{0}] == 1);
  CHECK(!find_edge_property<int>(m, "label"));
}

TEST_CASE("read_gmsh: elements in several groups, partitions, and edges that the mesh does not have") {
  load_report r;
  const auto m = gmsh<trimesh>(head2 + nodes + "$Elements\n6\n1 2 2 4 1 10 20 7\n2 2 2 5 1 10 20 7\n3 2 4 6 1 1 2 10 20 3\n4 2 4 7 1 1 2 10 20 3\n5 2 4 8 1 1 2 10 20 3\n6 1 2 9 9 7 3\n"
                                       "$EndElements\n$ElementData\n1\nx\n0\n3\n0 1 3\n1 .5\n4 .25\n6 1\n$EndElementData\n", {.report = &r});
  CHECK(num_polys(m) == 2);
  CHECK(values(m, polys(m), find_poly_property<int>(m, "label")) == list{"4", "6"});
  CHECK(find_poly_property<double>(m, "x")[poly_id{1}] == 0.25);  // of the element that is listed again
  CHECK(r.skipped == list{"partitions of 3 elements", "3 elements that are listed again for another physical group: \"label\" is the first one",
                          "values of 1 elements of kind edge that the mesh does not have"});
  const auto parts = gmsh<trimesh>(head4 + "$Entities\n0 0 1 0\n1 0 0 0 1 1 1 1 9 0\n$EndEntities\n$PartitionedEntities\n2\n1\n5 1\n0 0 1 0\n3 2 1 1 2 0 0 0 1 1 1 1 9 0\n$EndPartitionedEntities\n"
                                           "$Nodes\n1 3 1 3\n2 3 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n$Elements\n1 1 1 1\n2 3 2 1\n1 1 2 3\n$EndElements\n", {.report = &r});
  CHECK(find_poly_property<int>(parts, "label")[poly_id{0}] == 9);
  CHECK(find_poly_property<int>(parts, "entity_tag")[poly_id{0}] == 1);
  CHECK(r.skipped == list{"partitions of 1 elements"});
}

TEST_CASE("read_gmsh: prisms, pyramids and hexes have the order of Gmsh") {
  const std::string cube = head2 + "$Nodes\n11\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n9 .5 .5 2\n10 2 0 0\n11 2 0 1\n$EndNodes\n$Elements\n";
  load_report r;
  const auto m = gmsh<polyhedra_arrays>(cube + "4\n1 5 2 1 1 1 2 3 4 5 6 7 8\n2 7 2 1 1 5 6 7 8 9\n3 6 2 2 2 2 10 3 6 11 7\n4 4 2 2 2 6 11 7 9\n$EndElements\n", {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CHECK(r.notes.empty());
  double volume = 0;
  for (std::size_t p = 0; p < 4; ++p) volume += six_times_poly_volume(m, p) / 6;
  CHECK(volume == doctest::Approx(1 + 1.0 / 3 + 0.5 + 1.0 / 6));
  gmsh<hexmesh>(cube + "1\n1 5 2 1 1 4 3 2 1 8 7 6 5\n$EndElements\n", {.report = &r});
  CHECK(r.reoriented_polys == 1);
}

TEST_CASE("read_gmsh: values of nodes and elements of all dimensions") {
  const std::string data = "$ElementData\n2\n\"a b\"\n\"scheme\"\n2\n0.5 1\n4\n0\n3\n3\n0\n8 1 2 3\n9 4 5 6\n90 7 8 9\n$EndElementData\n"
                           "$NodeData\n0\n0\n3\n0\n1\n2\n7 nan\n8 1\n$EndNodeData\n$NodeData\n1\n\"t\"\n1\n0\n3\n0 1 1\n10 1\n$EndNodeData\n"
                           "$NodeData\n1\n\"t\"\n1\n0\n3\n0 1 2\n20 2\n20 3\n$EndNodeData\n$NodeData\n1\n\"t\"\n1\n0\n3\n1 1 1\n3 5\n$EndNodeData\n"
                           "$ElementData\n1\n\"odd\"\n0\n3\n0 5 1\n8 1 2 3 4 5\n$EndElementData\n$ElementData\n1\n\"w\"\n0\n3\n0 9 1\n8 1 2 3 4 5 6 7 8 9\n$EndElementData\n"
                           "$ElementData\n1\n\"v\"\n0\n3\n0 1 2\n1 4\n90 6\n$EndElementData\n$NodeData\n1\nlabel\n0\n3\n0 1 1\n3 5\n$EndNodeData\n";
  load_report r;
  const auto m = gmsh<tetmesh>(tets4 + data, {.report = &r});
  CHECK(find_poly_property<vec3>(m, "a b")[poly_id{1}] == vec3{4, 5, 6});
  vec3 of_face;
  for (const auto f : faces(m)) of_face += find_face_property<vec3>(m, "a b")[f];
  CHECK(of_face == vec3{7, 8, 9});
  CHECK(!find_edge_property<vec3>(m, "a b"));
  CHECK(std::isnan(find_vert_property<double>(m, "NodeData")[vert_id{2}]));
  CHECK(values(m, verts(m), find_vert_property<double>(m, "t")) == list{"1.000000", "3.000000", "0.000000", "0.000000", "0.000000"});
  CHECK(find_vert_property<double>(m, "t_2")[vert_id{4}] == 5);
  CHECK(find_poly_property<std::array<double, 9>>(m, "w")[poly_id{0}][8] == 9);
  CHECK(find_vert_property<double>(m, "v")[vert_id{0}] == 4);
  CHECK(!find_poly_property<double>(m, "v"));
  CHECK(find_vert_property<double>(m, "label_2")[vert_id{4}] == 5);
  CHECK(r.skipped == list{"values \"odd\" of 5 numbers: properties have 1, 2, 3, 4, 6 or 9", "section Entities: which ones bound others, 5 tags", "more than one physical group of 1 elements: \"label\" is the first one", "the parameters of 1 nodes on entities",
                          "1 values of nodes that the file does not have", "1 values of nodes or elements that have another one of the same name and step, which follows"});
  CHECK(r.notes.size() == 3);
  const auto two = binary("$MeshFormat\n4.1 1 8\n~ 1\n$EndMeshFormat\n$Nodes\n~ s 1 3 1 3 i 2 1 0 s 3 1 2 3 d 0 0 0 1 0 0 0 1 0\n$EndNodes\n$Elements\n~ s 1 1 1 1 i 2 1 2 s 1 5 1 2 3\n"
                          "$EndElements\n$ElementData\n1\n\"v\"\n1\n0\n3\n0\n3\n1\n~ i 5 d 1 2 3\n$EndElementData\n$NodeData\n1\n\"v\"\n1\n0\n3\n0\n1\n2\n~ i 3 d .5 i -1 d 1\n$EndNodeData\n", true);
  const auto t = load_text<trimesh>(two, file_format::gmsh, {.report = &r});
  CHECK(find_poly_property<vec3>(t, "v")[poly_id{0}] == vec3{1, 2, 3});
  CHECK(find_vert_property<double>(t, "v")[vert_id{2}] == 0.5);
  CHECK(r.skipped == list{"1 values of nodes that the file does not have"});
}

TEST_CASE("read_gmsh: values of few nodes in very many sections are unsupported") {
  std::string text = head2 + "$Nodes\n2000\n";
  for (int i = 1; i <= 2000; ++i) text += std::to_string(i) + " 0 0 0\n";
  text += "$EndNodes\n$Elements\n0\n$EndElements\n";
  for (int i = 0; i < 2000; ++i) text += "$NodeData\n1\nx\n0\n3\n" + std::to_string(i) + " 1 1\n1 1\n$EndNodeData\n";
  CHECK(refuses<trimesh>(text).starts_with("t.msh: very many sections with values of few nodes or elements: properties of "));
}

TEST_CASE("read_gmsh: other sections are skipped, and comments may come first") {
  load_report r;
  const auto m = gmsh<trimesh>("$Comments\n$MeshFormat is below\n$EndComments\n" + triangles + "$Periodic\n1\n1 2 3\n$EndPeriodic\n$What\n$EndWhat", {.report = &r});
  CHECK(num_polys(m) == 2);
  CHECK(num_verts(m) == 5);  // one of which no element uses
  CHECK(r.skipped == list{"section $Comments", "section $Periodic", "section $What"});
  CHECK(gmsh_format::has_signature("$Comments\n$EndComments\n" + triangles));
  CHECK(gmsh_format::has_signature(triangles));
  CHECK(!gmsh_format::has_signature("$Comments\n" + triangles));
  CHECK(!gmsh_format::has_signature("$NOD\n"));
  CHECK(num_polys(gmsh<polygonmesh>(triangles + std::string("\0\x1a", 2))) == 2);
}

TEST_CASE("read_gmsh: elements of second and higher order are unsupported, or read by their corners") {
  const std::string text = head2 + "$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 .5 0 0\n5 .5 .5 0\n6 0 .5 0\n7 9 9 9\n$EndNodes\n$Elements\n2\n1 8 2 0 1 1 2 4\n2 9 2 0 1 1 2 3 4 5 6\n$EndElements\n";
  CHECK(refuses<trimesh>(text) == "t.msh: $Elements has 1 second-order elements, with nodes on edges, the first of type 9, a triangle of 6 nodes; "
                                  "load with {.corners_only = true} to read only the corners");
  load_report r;
  const auto m = gmsh<trimesh>(text, {.report = &r, .corners_only = true});
  CHECK(num_verts(m) == 4);
  CHECK(num_polys(m) == 1);
  CHECK(r.skipped == list{"3 points, the nodes of 2 elements of second or higher order: only corners were read"});
  std::string third = text;
  third.replace(third.find("2 9 2"), 21, "2 20 2 0 1 1 2 3 4 5 6 4 5 6");
  CHECK(refuses<trimesh>(third).find("1 higher-order elements, with nodes on edges, the first of type 20, a triangle of 9 nodes") != std::string::npos);
  gmsh<trimesh>(head2 + text.substr(head2.size(), text.find("$Elements") - head2.size()) + "$Elements\n2\n1 8 2 0 1 1 2 4\n2 2 2 0 1 1 2 3\n$EndElements\n", {.report = &r});
  CHECK(r.skipped == list{"1 lines of second or higher order"});
}

TEST_CASE("read_gmsh: volumes, surfaces and other kinds of mesh") {
  CHECK(refuses<trimesh>(tets4) == "t.msh: holds a volume of 2 polyhedra, but a surface mesh was requested; load it as polyhedralmesh or with load_any");
  CHECK(refuses<tetmesh>(triangles) == "t.msh: holds a surface of 2 polygons, but a volume mesh was requested; load it as polygonmesh or with load_any");
  CHECK(says<hexmesh>(tets4) == "45: a hex (polyhedralmesh and load_any take any cell) | a tet of 4 faces");
  CHECK(says<quadmesh>(triangles) == "14: a quad (polygonmesh and load_any take any polygon) | a polygon of 3 corners");
  CHECK(num_polys(gmsh<polyhedralmesh>(tets4)) == 2);
  const std::string no_elements = head2 + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n0\n$EndElements\n";
  CHECK(gmsh<trimesh>(no_elements).points().size() == 1);
  CHECK(gmsh<tetmesh>(no_elements).points().size() == 1);
  const auto collapsed = gmsh<polygonmesh>(head2 + nodes + "$Elements\n3\n1 3 2 4 4 10 20 7 7\n2 2 2 5 5 10 20 20\n3 1 2 5 5 7 7\n$EndElements\n", {.repeated_verts = repeated_verts::collapse});
  CHECK(num_polys(collapsed) == 1);
  CHECK(find_poly_property<int>(collapsed, "label")[poly_id{0}] == 4);
}

TEST_CASE("read_gmsh: errors name the line") {
  CHECK(says("") == "1: $MeshFormat | an empty file");
  CHECK(says("MeshFormat") == "1: the name of a section, such as $Nodes | 'MeshFormat'");
  CHECK(says("$Nodes\n") == "1: $MeshFormat | '$Nodes'");
  CHECK(says("$MeshFormat\n2.2 2 8\n") == "2: 0 for text or 1 for binary numbers | '2'");
  CHECK(says("$MeshFormat\n2.2 0 4\n") == "2: the size of numbers, 8 | '4'");
  CHECK(says("$MeshFormat\n2.2 0 8\nx") == "3: $EndMeshFormat | 'x'");
  CHECK(says("$MeshFormat\n2.2 1 8\n" + std::string("\2\0\0\0\n", 5)) == "2: the number 1 | 2 at byte 20");
  for (const char* version : {"1.0", "3", "4", "4.0", "4.2"})
    CHECK(refuses<trimesh>("$MeshFormat\n" + std::string(version) + " 0 8\n$EndMeshFormat\n") ==
          "t.msh: version " + std::string(version) + " of the format of Gmsh is not supported; let Gmsh write version 4.1: gmsh FILE -0 -format msh41 -o NEW_FILE");
  CHECK(refuses<trimesh>("$NOD\n1\n").find("version 1 ") != std::string::npos);
  CHECK(refuses<trimesh>(head2 + "$ParametricNodes\n").find("$ParametricNodes") != std::string::npos);
  CHECK(says(head2) == "3: $Nodes | the end of the file");
  CHECK(says(head2 + nodes) == "11: $Elements | the end of the file");
  CHECK(says(head2 + "$Elements\n0\n$EndElements\n") == "4: $Nodes before $Elements | the end of the line");
  CHECK(says(head2 + "$Nodes\n3\n1 0 0 0\n") == "5: a count that fits into the file | 3, and 9 bytes are left,");
  CHECK(says(head2 + "$Nodes\n2\n1 0 0 0\n1 0 0 1\n$EndNodes\n") == "4: nodes of different tags | tag 1 twice");
  CHECK(says(head2 + "$Nodes\n1\n1 0 inf 0\n") == "6: a coordinate of a node, a finite number | 'inf'");
  CHECK(says(head2 + "$Nodes\n1\n-1 0 0 0\n") == "6: the tag of a node | '-1'");
  CHECK(says(head2 + "$Nodes\n1\n1 0 0 0\n2 0 0 0\n") == "7: $EndNodes | '2'");
  const auto element = [](const std::string& e) { return says(head2 + nodes + "$Elements\n1\n" + e + "\n$EndElements\n"); };
  CHECK(element("1 2 2 0 0 10 20 8") == "14: the tag of a node in $Nodes | 8");
  CHECK(says<surface_arrays>(head2 + nodes + "$Elements\n1\n1 2 2 0 0 10 20 20\n$EndElements\n").starts_with("14: different verts in an element"));
  CHECK(element("1 1 2 0 0 10 10") == "14: different verts in an element (or set options.repeated_verts) | vert 1 twice");
  CHECK(element("1 2 2 x 0 10 20 7") == "14: a tag of an element | 'x'");
  CHECK(element("1 2 9999 0 0 10 20 7") == "14: a number of tags that fits into the file | 9999");
  CHECK(element("1 2 2 0 99999999999 10 20 7") == "14: a tag of an element of 32 bits | '99999999999'");
  CHECK(refuses<trimesh>(head2 + nodes + "$Elements\n1\n1 34 2 0 0 4 10 20 7 3\n") == "t.msh: elements of type 34 (polygons), the first on line 14, are not supported: "
                                                                                      "points, lines, triangles, quads, tets, hexes, prisms and pyramids are");
  const auto in4 = [](const std::string& from, const std::string& to) {
    std::string text = tets4;
    text.replace(text.find(from), from.size(), to);
    return says(text);
  };
  CHECK(in4("3 5 3 1000000", "3 6 3 1000000") == "19: the number of nodes, 5 | 6");
  CHECK(in4("3 5 3 1000000", "3 3 3 1000000") == "23: at most 2 nodes, as the section has 3 | 3");
  CHECK(in4("5 6 1 90", "5 7 1 90") == "35: the number of elements, 6 | 7");
  CHECK(in4("5 6 1 90", "5 5 1 90") == "44: at most 1 elements, as the section has 5 | 2");
  CHECK(in4("3 7 4 2", "2 7 4 2") == "44: dimension 3, that of elements of type 4 | 2");
  CHECK(in4("1 1 2 1\n4", "1 1 2 999999999\n4").find("a count that fits into the file") != std::string::npos);
  CHECK(in4("2 5 \"wall\"", "4 5 \"wall\"") == "7: the dimension of a group, 0 to 3 | '4'");
  const auto data = [](const std::string& d) { return says(tets4 + "$NodeData\n" + d); };
  CHECK(data("1\n\"x\"\n0\n2\n0 1\n") == "52: the number of integer tags, at least 3 | '2'");
  CHECK(data("1\n\"x\"\n0\n3\n0 0 1\n") == "53: the number of components | '0'");
  CHECK(data("1\n\"x\"\n0\n3\n0 1 9\n1 2\n").starts_with("53: a count that fits into the file"));
  CHECK(data("1\n\"x\"\n0\n3\n0 1 1\n1 x\n") == "54: a value | 'x'");
  CHECK(data("1\n$EndNodeData") == "50: a text | '$EndNodeData'");
  CHECK(says(head2 + "$Comments\nnever ended") == "5: $EndComments | the end of the file");
}
