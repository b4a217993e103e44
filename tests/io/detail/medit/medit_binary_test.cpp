#include <concino/io/detail/medit/medit_binary.hpp>

#include <concino/io/detail/medit/read_medit.hpp>
#include <concino/io/load.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// Writes binary MEDIT files of any version in either byte order.
struct meshb {
  int version = 2;
  bool big = false;
  std::string text = {};

  template<class T>
  void put(T x) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &x, sizeof(T));
    if (big) std::reverse(bytes, bytes + sizeof(T));
    text.append(bytes, sizeof(T));
  }
  void real(double x) { version == 1 ? put(static_cast<float>(x)) : put(x); }
  void integer(std::int64_t x) { version == 4 ? put(x) : put(static_cast<std::int32_t>(x)); }
  void position(std::size_t x) { version < 3 ? put(static_cast<std::int32_t>(x)) : put(static_cast<std::int64_t>(x)); }
  std::size_t position_size() const { return version < 3 ? 4 : 8; }

  void begin(std::int32_t dimension = 3) {
    put(std::int32_t{1}), put(std::int32_t{version});
    put(std::int32_t{3}), position(text.size() + position_size() + 4), put(dimension);
  }
  /// A section with n rows that f writes.
  template<class F>
  void section(std::int32_t code, std::int64_t n, const F& rows, bool is_last = false) {
    put(code);
    meshb inner{version, big};
    rows(inner);
    position(is_last ? 0 : text.size() + position_size() + (version == 4 ? 8 : 4) + inner.text.size());
    integer(n);
    text += inner.text;
  }
  void section(std::int32_t code, std::int64_t n, std::initializer_list<int> numbers, bool is_last = false) {
    section(code, n, [&](meshb& out) { for (const int i : numbers) out.integer(i); }, is_last);
  }
  void vertices(std::initializer_list<vec3> points, int first_label = 0, bool flat = false) {
    section(4, static_cast<std::int64_t>(points.size()), [&](meshb& out) {
      int label = first_label;
      for (const vec3& p : points) {
        out.real(p.x), out.real(p.y);
        if (!flat) out.real(p.z);
        out.integer(label ? label++ : 0);
      }
    });
  }
  void end() { put(std::int32_t{54}), position(0); }
};

const std::initializer_list<vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

meshb one_tet_meshb(int version, bool big) {
  meshb b{version, big};
  b.begin();
  b.vertices(corners, 5);
  b.section(5, 1, {1, 2, 3});
  b.section(6, 2, {1, 2, 3, 8, 1, 2, 4, 9});
  b.section(8, 1, {1, 2, 3, 4, -7});
  b.section(13, 1, {4});
  b.section(16, 1, {1});
  b.section(60, 1, [](meshb& out) { out.real(0), out.real(0), out.real(1); });
  b.section(20, 1, {3, 1});
  b.end();
  return b;
}

std::string meshb_complaint(const std::string& text) {
  try {
    load_alone<cell_arrays>(text, file_format::medit);
  } catch (const parse_error& e) {
    return core::joined({e.line, ": ", e.expected, " | ", e.found});
  }
  return {};
}

/// Whether reading gives a mesh or a typed error. The memory ends at the end of the text.
bool reads_or_fails(const std::string& text) {
  const std::unique_ptr<char[]> exact(new char[text.size()]);
  std::copy(text.begin(), text.end(), exact.get());
  try {
    load_text<polyhedralmesh>({exact.get(), text.size()}, file_format::medit);
  } catch (const parse_error&) {
  } catch (const unsupported&) {
  }
  return true;
}

}  // namespace

TEST_CASE("medit_binary: reads versions 1 to 4 in both byte orders") {
  for (const int version : {1, 2, 3, 4})
    for (const bool big : {false, true}) {
      CAPTURE(version);
      CAPTURE(big);
      load_report r;
      const std::string text = one_tet_meshb(version, big).text;
      CHECK(medit_format::has_signature(text));
      const auto m = load_alone<tetmesh>(text, file_format::medit, {.report = &r});
      CHECK(num_verts(m) == 4);
      CHECK(num_polys(m) == 1);
      CHECK(point(m, vert_id{3}) == vec3{0, 0, 1});
      const auto loaded = load_text<tetmesh>(text, file_format::medit, {.report = &r});
      CHECK(find_vert_property<int>(loaded, "label")[vert_id{3}] == 8);
      CHECK(find_vert_property<int>(loaded, "corner")[vert_id{3}] == 1);
      CHECK(find_vert_property<vec3>(loaded, "normal")[vert_id{2}] == vec3{0, 0, 1});
      CHECK(find_poly_property<int>(loaded, "label")[poly_id{0}] == -7);
      int edge_sum = 0, face_sum = 0;
      for (const auto e : edges(loaded)) edge_sum += find_edge_property<int>(loaded, "label")[e] + 10 * find_edge_property<int>(loaded, "required")[e];
      for (const auto f : faces(loaded)) face_sum += find_face_property<int>(loaded, "label")[f];
      CHECK(edge_sum == 13);
      CHECK(face_sum == 17);
      CHECK(r.notes.empty());
      CHECK(r.skipped.empty());
    }
}

TEST_CASE("medit_binary: reads all shapes of cells, surfaces, and dimension 2") {
  meshb b;
  b.begin();
  b.vertices({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {.5, .5, 2}, {2, 0, 0}, {2, 0, 1}});
  b.section(49, 1, {5, 6, 7, 8, 9, 1});
  b.section(10, 1, {1, 2, 3, 4, 5, 6, 7, 8, 2});
  b.section(9, 1, {2, 10, 3, 6, 11, 7, 3});
  b.section(8, 1, {6, 11, 7, 9, 4}, true);
  load_report r;
  const auto m = load_text<polyhedralmesh>(b.text, file_format::medit, {.report = &r});
  CHECK(num_polys(m) == 4);
  CHECK(num_faces(m) == 16);
  CHECK(r.reoriented_polys == 0);
  CHECK(r.notes == std::vector<std::string>{"the file has no End: it may be cut off"});

  meshb flat{1};
  flat.begin(2);
  flat.vertices({{0, 0, 9}, {1, 0, 9}, {1, 1, 9}, {0, 1, 9}}, 0, true);
  flat.section(6, 1, {1, 2, 3, 0});
  flat.section(7, 1, {1, 2, 3, 4, 6});
  flat.section(18, 1, {1});
  flat.end();
  const auto s = load_text<polygonmesh>(flat.text, file_format::medit, {.report = &r});
  CHECK(point(s, vert_id{2}) == vec3{1, 1, 0});
  CHECK(find_poly_property<int>(s, "required")[poly_id{1}] == 1);
  CHECK(find_poly_property<int>(s, "label")[poly_id{1}] == 6);
}

TEST_CASE("medit_binary: unknown sections are skipped by their position and reported") {
  meshb b;
  b.begin();
  b.section(62, 1, {1, 1, 7, 7, 7});
  b.vertices(corners);
  b.section(8, 1, {1, 2, 3, 4, 0});
  b.section(1234, 0, {});
  b.end();
  load_report r;
  CHECK(num_polys(load_text<tetmesh>(b.text, file_format::medit, {.report = &r})) == 1);
  CHECK(r.skipped == std::vector<std::string>{"section with the code 62, 24 bytes", "section with the code 1234, 4 bytes"});
}

TEST_CASE("medit_binary: errors name the byte") {
  meshb start;
  start.begin();
  const std::size_t n = start.text.size();
  CHECK(n == 20);
  const auto after_start = [&](const auto& add) {
    meshb b = start;
    add(b);
    return meshb_complaint(b.text);
  };
  const std::string tet = one_tet_meshb(2, false).text;
  CHECK(meshb_complaint(tet).empty());
  CHECK(meshb_complaint(tet.substr(0, 14)) == "1: the position of the next keyword | the end of the file at byte 14");
  CHECK(meshb_complaint(tet.substr(0, 8)) == "1: a section Vertices | the end of the file at byte 8");
  CHECK(after_start([](meshb&) {}) == "1: a section Vertices | the end of the file at byte 20");
  CHECK(after_start([](meshb& b) { b.put(std::int32_t{4}), b.put(std::int32_t{19}); }) == "1: the position of the next keyword, from 28 to 28 | 19 at byte 24");
  CHECK(after_start([](meshb& b) { b.put(std::int32_t{4}), b.put(std::int32_t{1000}); }) == "1: the position of the next keyword, from 28 to 28 | 1000 at byte 24");
  CHECK(after_start([](meshb& b) { b.put(std::int32_t{4}), b.put(std::int32_t{0}), b.put(std::int32_t{1000}); }) ==
        "1: the number of rows of the section, at most 0 up to the next one or the end of the file | 1000 at byte 28");
  CHECK(after_start([](meshb& b) { b.section(4, -1, {}); }) ==
        "1: the number of rows of the section, at most 0 up to the next one or the end of the file | -1 at byte 28");
  CHECK(after_start([](meshb& b) { b.vertices(corners), b.section(8, 1, {1, 2, 3, 5, 0}); }) == "1: a vertex index from 1 to 4 | 5 at byte 168");
  CHECK(after_start([](meshb& b) { b.vertices(corners), b.section(8, 1, {1, 2, 3, 3, 0}); }) == "1: different verts in a cell (or set "
      "options.repeated_verts) | vert 3 twice at byte 156");
  CHECK(after_start([](meshb& b) { b.vertices(corners), b.vertices(corners); }).starts_with("1: one section Vertices | another at byte "));
  CHECK(after_start([](meshb& b) { b.vertices({{0, std::nan(""), 0}}); }) == "1: the y of a vertex, a finite number | another value at byte 40");
  CHECK(after_start([](meshb& b) { b.vertices(corners), b.section(14, 1, {1}); }) == "1: the index of an edge, but there is nothing to refer to | 1 at byte 156");
  meshb four{4};
  four.begin();
  four.section(4, 1, [](meshb& out) { out.real(0), out.real(0), out.real(0), out.integer(std::int64_t{1} << 40); });
  CHECK(meshb_complaint(four.text) == "1: the reference of a vertex, an integer of 32 bits | 1099511627776 at byte 68");
  meshb unordered;
  unordered.put(std::int32_t{1}), unordered.put(std::int32_t{2});
  unordered.vertices(corners);
  CHECK(meshb_complaint(unordered.text).starts_with("1: the dimension before the vertices | another value at byte 8"));
  meshb odd;
  odd.begin(4);
  CHECK(meshb_complaint(odd.text) == "1: the dimension, 2 or 3 | another value at byte 16");
  CHECK_THROWS_AS(load_text<trimesh>(tet, file_format::medit), unsupported);
}

TEST_CASE("medit_binary: every truncation and changed byte gives a mesh or an error") {
  std::mt19937 random(7);
  for (const int version : {1, 2, 4}) {
    const std::string text = one_tet_meshb(version, version == 2).text;
    for (std::size_t n = 0; n <= text.size(); ++n) CHECK(reads_or_fails(text.substr(0, n)));
    for (std::size_t i = 0; i < text.size(); ++i)
      for (const int c : {0, 1, 0x7f, 0x80, 0xff, static_cast<int>(random() & 0xff)}) {
        std::string changed = text;
        changed[i] = static_cast<char>(c);
        CHECK(reads_or_fails(changed));
      }
  }
}

TEST_CASE("medit_binary: the extension .meshb or the option binary write binary files, and both are recognised by their content") {
  const temporary_folder dir;
  const auto m = grid<tetmesh>(2);
  const std::string text = save_text(m, file_format::medit), binary = save_text(m, file_format::medit, {.binary = true});
  save(m, dir / "a.mesh");
  save(m, dir / "a.MESHB");
  save(m, dir / "b.mesh", {.binary = true});
  CHECK(read_file(dir / "a.mesh") == text);
  CHECK(read_file(dir / "a.MESHB") == binary);
  CHECK(read_file(dir / "b.mesh") == binary);
  CHECK(text.starts_with("MeshVersionFormatted 2\n"));
  CHECK(binary.substr(0, 8) == std::string("\1\0\0\0\2\0\0\0", 8));
  write_file(dir / "c.obj", binary);
  for (const char* name : {"a.mesh", "a.MESHB", "b.mesh", "c.obj"}) CHECK(save_text(load<tetmesh>(dir / name), file_format::medit) == text);
}

TEST_CASE("medit_binary: corpus files are the same after saving as text or binary, and saved again as the same bytes") {
  std::size_t files = 0;
  for (const char* name : {"tet/quarter_crown.mesh", "hex/hole.mesh", "hex/double_hinge.mesh", "hex/hollow_sphere.mesh", "fields/kuhn_6.mesh"}) {
    const auto file = corpus(name);
    if (file.empty()) continue;
    ++files;
    CAPTURE(name);
    std::visit(
        [](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          const std::string text = save_text(m, file_format::medit), binary = save_text(m, file_format::medit, {.binary = true});
          load_report r;
          const M again = load_text<M>(binary, file_format::medit, {.report = &r});
          CHECK(r.skipped.empty());
          CHECK(r.notes.empty());
          CHECK(r.reoriented_polys == 0);
          CHECK(save_text(again, file_format::medit) == text);
          CHECK(save_text(again, file_format::medit, {.binary = true}) == binary);
          CHECK(save_text(load_text<M>(text, file_format::medit), file_format::medit, {.binary = true}) == binary);
        },
        load_any(file));
  }
  if (files == 0) skip("no corpus");
}

TEST_CASE("medit_binary: second-order elements are read by their corners, if the options say so") {
  for (const int version : {1, 4})
    for (const int ordering : {0, 133}) {
      meshb file{version};
      file.begin();
      file.vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}});
      if (ordering) file.section(ordering, 1, {0, 0, 0, 2});
      file.section(30, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 3});
      file.end();
      CHECK_THROWS_WITH_AS(load_text<tetmesh>(file.text, file_format::medit),
                           "text: section TetrahedraP2 has 1 second-order elements, with nodes on edges; load with {.corners_only = true} to read only the "
                               "corners", unsupported);
      if (ordering) {
        CHECK_THROWS_AS(load_text<tetmesh>(file.text, file_format::medit, {.corners_only = true}), unsupported);
        continue;
      }
      const auto m = load_text<tetmesh>(file.text, file_format::medit, {.corners_only = true});
      CHECK(num_verts(m) == 4);
      CHECK(find_poly_property<int>(m, "label")[poly_id{0}] == 3);
    }
}
