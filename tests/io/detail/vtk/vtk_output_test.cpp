// What .vtk, .vtu and .vtp store: meshes of all kinds with properties are the same after saving and loading, and saved again byte for byte.
#include <concino/concepts/facets.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstring>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// A mesh with properties of many types, also of faces.
template<class M>
M annotated() {
  M m(jittered(grid_arrays<M>(2), 0.05, dimension_v<M> == 3));
  const auto height = vert_property<double>(m, "a height, in %");
  const auto velocity = vert_property<vec3>(m, "velocity");
  const auto rank = vert_property<std::uint64_t>(m, "rank");
  const auto marked = vert_property<std::int8_t>(m, "METADATA");
  double x = 0.1;
  for (const auto v : verts(m)) {
    height[v] = x *= -1.3;
    velocity[v] = {x / 3, -0.0, 5e-324};
    rank[v] = ~std::uint64_t{0} - index_of(m, v);
    marked[v] = static_cast<std::int8_t>(-5 + static_cast<int>(index_of(m, v) % 9));
  }
  height[*verts(m).begin()] = -std::numeric_limits<double>::infinity();
  const auto label = poly_property<int>(m, "label");
  const auto color = poly_property<rgba>(m, "color");
  const auto stress = poly_property<std::array<float, 6>>(m, "stress");
  for (const auto p : polys(m)) {
    label[p] = 7 - 3 * static_cast<int>(index_of(m, p));
    color[p] = {0.1f, 1.0f / 3, 2, 0};
    stress[p] = {1.0f / 3, 1e-40f, -3e38f, 0, 5, 0.1f};
  }
  *mesh_property<double>(m, "time") = 0.3;
  if constexpr (dimension_v<M> == 3) {
    const auto flux = face_property<double>(m, "flux");
    const auto boundary = face_property<int>(m, "label");
    for (const auto f : faces(m)) {
      if (index_of(m, f) % 3 == 0) flux[f] = 1.0 / static_cast<double>(index_of(m, f) + 3);
      if (is_boundary(m, f)) boundary[f] = 4;
    }
  }
  return m;
}

template<class T>
std::vector<unsigned char> bytes_of_values(const T& x) {
  std::vector<unsigned char> r(sizeof x);
  std::memcpy(r.data(), &x, sizeof x);
  return r;
}

/// Whether the property of that name has the same values, to the last bit. Both meshes have the same indices.
template<class T, class A, class B>
bool same_vert_values(const A& a, const B& b, const char* name) {
  const auto x = find_vert_property<T>(a, name), y = find_vert_property<T>(b, name);
  if (!x || !y) return false;
  for (const auto v : verts(a))
    if (bytes_of_values(x[v]) != bytes_of_values(y[v])) return false;
  return true;
}
template<class T, class A, class B>
bool same_poly_values(const A& a, const B& b, const char* name) {
  const auto x = find_poly_property<T>(a, name), y = find_poly_property<T>(b, name);
  if (!x || !y) return false;
  for (const auto p : polys(a))
    if (bytes_of_values(x[p]) != bytes_of_values(y[p])) return false;
  return true;
}

/// The values of faces by their sorted verts.
template<class T, class M>
std::vector<std::pair<std::vector<std::size_t>, T>> face_values(const M& m, const char* name) {
  std::vector<std::pair<std::vector<std::size_t>, T>> all;
  const auto u = find_face_property<T>(m, name);
  for (const auto f : faces(m)) {
    std::vector<std::size_t> ids;
    for (const auto v : adj_f2v(m, f)) ids.push_back(index_of(m, v));
    std::sort(ids.begin(), ids.end());
    all.emplace_back(ids, u ? u[f] : T{});
  }
  std::sort(all.begin(), all.end());
  return all;
}

template<class M>
std::vector<std::vector<std::size_t>> sorted_polys(const M& m) {
  std::vector<std::vector<std::size_t>> all;
  for (const auto p : polys(m)) {
    all.emplace_back();
    for (const auto v : adj_p2v(m, p)) all.back().push_back(index_of(m, v));
    if (arity_v<M> == 0 && dimension_v<M> == 3) std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

/// The kind, name and type of each property, sorted.
template<class M>
std::vector<std::string> properties_of(const M& m) {
  std::vector<std::string> all;
  for (const property_info& p : property_list(m)) all.push_back(core::joined({to_string(p.kind), " ", p.name, " ", p.type->name()}));
  std::sort(all.begin(), all.end());
  return all;
}

struct vtk_variant {
  format_id format;
  bool binary;
};

template<class M>
std::vector<vtk_variant> vtk_variants() {
  std::vector<vtk_variant> all = {{file_format::vtk, false}, {file_format::vtk, true}, {file_format::vtu, false}, {file_format::vtu, true}};
  if (dimension_v<M> == 2) {
    all.push_back({file_format::vtp, false});
    all.push_back({file_format::vtp, true});
  }
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("vtk_output: a mesh with properties is the same after saving and loading, and saved again byte for byte", M, CONCINO_ALL_KINDS) {
  const M m = annotated<M>();
  for (const vtk_variant& variant : vtk_variants<M>()) {
    CAPTURE(variant.format.name());
    CAPTURE(variant.binary);
    const std::string text = save_text(m, variant.format, {.binary = variant.binary, .strict = true});
    load_report r;
    const M again = load_text<M>(text, variant.format, {.report = &r});
    CHECK(r.skipped.empty());
    CHECK(r.reoriented_polys == 0);
    CHECK(num_verts(again) == num_verts(m));
    std::size_t wrong = 0;
    for (const auto v : verts(m)) wrong += bytes_of_values(vec3(point(m, v))) != bytes_of_values(vec3(point(again, v)));
    CHECK(wrong == 0);
    CHECK(sorted_polys(m) == sorted_polys(again));
    CHECK(properties_of(m) == properties_of(again));
    CHECK(same_vert_values<double>(m, again, "a height, in %"));
    CHECK(same_vert_values<vec3>(m, again, "velocity"));
    CHECK(same_vert_values<std::uint64_t>(m, again, "rank"));
    CHECK(same_vert_values<std::int8_t>(m, again, "METADATA"));
    CHECK(same_poly_values<int>(m, again, "label"));
    CHECK(same_poly_values<rgba>(m, again, "color"));
    CHECK(same_poly_values<std::array<float, 6>>(m, again, "stress"));
    CHECK(*find_mesh_property<double>(again, "time") == 0.3);
    if constexpr (dimension_v<M> == 3) {
      CHECK(num_faces(m) == num_faces(again));
      CHECK(face_values<double>(m, "flux") == face_values<double>(again, "flux"));
      CHECK(face_values<int>(m, "label") == face_values<int>(again, "label"));
    }
    CHECK(save_text(again, variant.format, {.binary = variant.binary}) == text);
    CHECK(num_verts(load_text<M>(save_text(M(), variant.format, {.binary = variant.binary}), variant.format)) == 0);
  }
}

TEST_CASE("vtk_output: what a file cannot hold is reported, and refused if the save is strict") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  vert_property<std::string>(m, "name");
  edge_property<int>(m, "sharp");
  poly_property<std::array<double, 5>>(m, "five");
  corner_property<double>(m, "angle");
  save_report r;
  for (const vtk_variant& variant : vtk_variants<trimesh>()) {
    const std::string text = save_text(m, variant.format, {.report = &r, .binary = variant.binary});
    const std::string end = core::joined({"\": .", variant.format.name(), " cannot store it"});
    CHECK(r.lost == std::vector<std::string>{"vert property \"name" + end, "edge property \"sharp" + end, "poly property \"five" + end, "corner property \"angle" + end});
    CHECK_THROWS_AS(save_text(m, variant.format, {.binary = variant.binary, .strict = true}), unsupported);
    CHECK(num_polys(load_text<trimesh>(text, variant.format)) == 1);
  }
}

TEST_CASE("vtk_output: properties of faces or polys with default values only are stored, or reported where a reader will not find them") {
  auto m = grid<hexmesh>(1);
  poly_property<int>(m, "poly only");
  poly_property<int>(m, "both");
  face_property<int>(m, "both");
  face_property<double>(m, "face only");
  const auto flux = face_property<double>(m, "flux");
  poly_property<double>(m, "flux");
  for (const format_id f : {format_id(file_format::vtk), format_id(file_format::vtu)}) {
    save_report r;
    flux[face_id{3}] = 0;
    auto again = load_text<hexmesh>(save_text(m, f, {.report = &r}), f);
    CHECK(properties_of(again) == std::vector<std::string>{"poly both i", "poly flux d", "poly poly only i"});
    const std::string why = "\", which has default values only: a file of VTK lists faces with other values only";
    CHECK(r.lost == std::vector<std::string>{"face property \"both" + why, "face property \"flux" + why, "face property \"face only" + why});
    flux[face_id{3}] = 0.5;
    again = load_text<hexmesh>(save_text(m, f, {.report = &r}), f);
    CHECK(properties_of(again) == std::vector<std::string>{"face flux d", "poly both i", "poly poly only i"});
    CHECK(r.lost == std::vector<std::string>{"face property \"both" + why, "poly property \"flux\", which has default values only: the property of faces of that name takes its place",
                                             "face property \"face only" + why});
    CHECK(find_face_property<double>(again, "flux")[face_id{3}] == 0.5);
    CHECK_THROWS_AS(save_text(m, f, {.strict = true}), unsupported);
  }
}

TEST_CASE("vtk_output: wedges are written in VTK's order, with the base counter-clockwise seen from outside") {
  const std::string start = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 7 double\n0 0 0 0 1 0 1 0 0 0 0 1 0 1 1 1 0 1 0.25 "
      "0.25 2\n";
  const std::string text = start + "CELLS 2 12\n6 0 1 2 3 4 5\n4 3 5 4 6\nCELL_TYPES 2\n13\n10\n";
  load_report r;
  const auto m = load_text<polyhedralmesh>(text, file_format::vtk, {.report = &r});
  CHECK(r.notes.empty());
  CHECK(total_measure(m) == doctest::Approx(2.0 / 3));
  CHECK(save_text(m, file_format::vtk).find("\n6 0 1 2 3 4 5\n4 3 4 6 5\nCELL_TYPES 2\n13\n10\n") != std::string::npos);
  const std::string vtu = save_text(m, file_format::vtu);
  CHECK(vtu.find("Name=\"connectivity\" format=\"ascii\">\n0\n1\n2\n3\n4\n5\n3\n4\n6\n5\n<") != std::string::npos);
  CHECK(total_measure(load_text<polyhedralmesh>(vtu, file_format::vtu, {.report = &r})) == doctest::Approx(2.0 / 3));
  CHECK(r.reoriented_polys == 0);
  // MEDIT has the standard order
  CHECK(save_text(m, file_format::medit).find("Prisms\n1\n1 3 2 4 6 5 0\n") != std::string::npos);
}

TEST_CASE("vtk_output: corpus files of all kinds are the same after saving and loading") {
  const temporary_folder dir;
  std::size_t files = 0;
  for (const char* name : {"fields/half_disk_crossfield.vtk", "hex/cylinder.vtk", "polyhedral/mixed_types.vtk", "tet/capsule_cavity.vtk", "tet/cube_tet.vtk", "polyhedral/voronoi_cube_250.hedra",
                           "polyhedral/agglomerated_crown.hedra", "polygon/lion_vase_poly.off", "quad/hole_capsule.off"}) {
    const auto file = corpus(name);
    if (file.empty()) continue;
    ++files;
    CAPTURE(std::string(name));
    const any_mesh m = load_any(file);
    std::visit(
        [&]<class M>(const M& mesh) {
          for (const vtk_variant& variant : vtk_variants<M>()) {
            const std::string text = save_text(mesh, variant.format, {.binary = variant.binary, .strict = true});
            const M again = load_text<M>(text, variant.format);
            CHECK(num_edges(again) == num_edges(mesh));
            CHECK(sorted_polys(mesh) == sorted_polys(again));
            std::size_t wrong = 0;
            for (const auto v : verts(mesh)) wrong += !(point(mesh, v) == point(again, v));
            CHECK(wrong == 0);
            CHECK(property_list(again).size() == property_list(mesh).size());
            CHECK((save_text(again, variant.format, {.binary = variant.binary}) == text));
          }
        },
        m);
  }
  if (files == 0) skip("no corpus");
}

TEST_CASE("vtk_output: a polyhedron with two faces of the same verts is refused, as it could not be read back") {
  // a tet with a pillow of two more triangles on one of its faces
  const auto m = load_text<polyhedralmesh>("4 6 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n3 1 2 3\n3 3 2 1\n6 1 2 3 4 5 6\n", file_format::hedra);
  for (const format_id f : {format_id(file_format::vtk), format_id(file_format::vtu)})
    CHECK_THROWS_WITH_AS(save_text(m, f), "text: VTK cannot hold poly 0, which has two faces with the same verts; save it as .hedra", unsupported);
  CHECK(num_faces(load_text<polyhedralmesh>(save_text(m, file_format::hedra), file_format::hedra)) == 6);
}

TEST_CASE("vtk_output: corpus files are read under a wrong extension and by the functions of one format, and their truncations are errors") {
  const temporary_folder dir;
  std::size_t files = 0;
  for (const char* name : {"hex/cylinder.vtk", "polyhedral/mixed_types.vtk", "tet/cube_tet.vtk", "tet/quarter_crown_ascii.vtu"}) {
    const auto file = corpus(name);
    if (file.empty()) continue;
    ++files;
    CAPTURE(std::string(name));
    const auto m = load<polyhedralmesh>(file);
    const std::string text = read_file(file.string()), other = dir / "a.mesh";
    write_file(other, text);
    load_report r;
    CHECK(num_faces(load<polyhedralmesh>(other, {.report = &r})) == num_faces(m));
    REQUIRE(!r.notes.empty());
    CHECK(r.notes.back().find("the extension is not .vt") == 0);
    const bool is_xml = std::string(name).ends_with(".vtu");
    CHECK(num_faces(is_xml ? load_vtu<polyhedralmesh>(other) : load_vtk<polyhedralmesh>(other)) == num_faces(m));
    CHECK_THROWS_AS((is_xml ? load_vtk<polyhedralmesh>(other) : load_vtu<polyhedralmesh>(other)), parse_error);
    for (std::size_t i = 0; i < 10; ++i) {
      try {
        load_text<polyhedralmesh>(std::string_view(text).substr(0, text.size() * i / 10), is_xml ? format_id(file_format::vtu) : format_id(file_format::vtk));
      } catch (const error& e) {
        CHECK(std::string(e.what()).starts_with("text:"));
      }
    }
  }
  if (files == 0) skip("no corpus");
}
