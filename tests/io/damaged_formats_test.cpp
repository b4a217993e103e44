// Damaged files in the formats of which the corpus has few or no small files: cut off at each tenth and at 100 random bytes, and with 1,000 random bytes
// changed, one at a time. What is read or refused by a typed error takes less than 1 GiB of memory; sanitizers check it too.
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/property.hpp>

#include <support/formats.hpp>
#include <support/memory_limit.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

struct whole_file {
  std::string name;
  std::string text;
  format_id format;
  void (*read)(std::string_view, format_id);
};

void read_surface(std::string_view text, format_id format) { load_text<polygonmesh>(text, format); }
void read_volume(std::string_view text, format_id format) { load_text<polyhedralmesh>(text, format); }
void read_skeleton(std::string_view text, format_id format) { load_skeleton_text(text, {.format = format}); }

/// Adds what a mesh with properties is saved as, in every format that holds it, as text and as binary.
template<class M>
void add_saved(std::vector<whole_file>& all, const std::string& name, M m, void (*read)(std::string_view, format_id)) {
  auto label = poly_property<int>(m, "label");
  auto normal = vert_property<vec3>(m, "normal");
  for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw() % 2);
  for (const auto v : verts(m)) normal[v] = {0, 0.6, -0.8};
  for (const format_id f : formats_with_reader(standard_formats))
    for (const bool binary : {false, true}) {
      try {
        all.push_back({name + "." + std::string(f.name()) + (binary ? " binary" : ""), save_text(m, f, {.binary = binary}), f, read});
      } catch (const unsupported&) {  // the format does not hold such a mesh, or is not binary
      }
    }
}

std::vector<whole_file> whole_files() {
  std::vector<whole_file> all;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.25\nv 0 0 1\nv 1 0 1\nv 1 1 1\n";
  add_saved(all, "triangles", load_text<polygonmesh>(points + "f 1 3 2\nf 1 4 3\n", file_format::obj), read_surface);
  add_saved(all, "polygons", load_text<polygonmesh>(points + "f 1 2 6 5\nf 5 6 7\nf 1 4 3 7 2\n", file_format::obj), read_surface);
  const std::string cube = "MeshVersionFormatted 2 Dimension 3 Vertices 9 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 0 1 0 1 0 1 0 1 1 1 0 0 1 1 0 .5 .5 2 0 ";
  add_saved(all, "tets", load_text<polyhedralmesh>(cube + "Tetrahedra 2 1 2 3 6 0 1 3 4 8 1 End", file_format::medit), read_volume);
  add_saved(all, "cells", load_text<polyhedralmesh>(cube + "Hexahedra 1 1 2 3 4 5 6 7 8 2 Pyramids 1 5 6 7 8 9 1 End", file_format::medit), read_volume);
  add_saved(all, "hexes", load_text<polyhedralmesh>(cube + "Hexahedra 1 1 2 3 4 5 6 7 8 2 End", file_format::medit), read_volume);
  all.push_back({"surface.iv",
                 "#Inventor V2.1 ascii\nSeparator { VertexProperty { vertex [ 0 0 0, 1 0 0, 0 1 0, 0 0 1 ] } IndexedFaceSet { coordIndex [ 0, 2, 1, -1, 0, 1, 3, -1 ] "
                 "materialIndex [ 0, 1 ] } Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } IndexedFaceSet { coordIndex [ 0, 1, 2, 3, -1 ] } }\n",
                 file_format::iv, read_surface});
  all.push_back({"cells.inp",
                 "*HEADING\n** a comment\n*PART, NAME=p\n*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n90, .5, .5, 2\n"
                 "*Element, type=C3D8R, elset=\"a hex\"\n10, 1, 2, 3, 4,\n5, 6, 7, 8\n*ELEMENT, TYPE=C3D5\n20, 5, 6, 7, 8, 90\n*ELEMENT, TYPE=B31\n30, 1, 2\n*NSET, NSET=n, GENERATE\n1, 8, 2\n"
                 "*ELSET, ELSET=e\n20, a hex\n*END PART\n*ASSEMBLY\n*INSTANCE, NAME=i, PART=p\n0, 0, 0\n*END INSTANCE\n*NSET, NSET=m, INSTANCE=i\n90,\n*END ASSEMBLY\n",
                 file_format::abaqus, read_volume});
  all.push_back({"shells.inp", "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1D0\n4, 0, 1\n*ELEMENT, TYPE=S4R\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=S3, ELSET=t\n2, 1, 2, 3\n", file_format::abaqus, read_surface});
  all.push_back({"curve.skc", "3 2\n0 0 0\n1 0 0\n0 1 0\n0 1 .5 .25 1 2 17 18\n1 2 0 0 0 0\n", file_format::skc, read_skeleton});
  all.push_back({"curve.csv", "x,y,z\n0,0,0,1\n1 0 0 2\n1;1;0\n", file_format::csv, read_skeleton});
  return all;
}

/// Whether a text is read, or refused by an error of a documented type. The memory ends at the end of the text.
bool is_read_or_refused_by(const whole_file& file, std::string_view text) {
  const std::unique_ptr<char[]> exact(new char[text.size()]);
  std::copy(text.begin(), text.end(), exact.get());
  try {
    file.read({exact.get(), text.size()}, file.format);
  } catch (const parse_error& e) {
    return e.line >= 1;
  } catch (const unsupported&) {
  } catch (const invalid_mesh&) {
  }
  return true;
}

}  // namespace

TEST_CASE("damaged formats: the whole files are read, and every new format is among them") {
  const auto all = whole_files();
  for (const whole_file& file : all) {
    CAPTURE(file.name);
    CHECK_NOTHROW(file.read(file.text, file.format));
  }
  for (const char* ending : {".vtk", ".vtk binary", ".vtu", ".vtu binary", ".vtp", ".vtp binary", ".ply", ".ply binary", ".stl", ".stl binary", ".ovm", ".smesh", ".poly", ".inp", ".gmsh", ".gmsh binary", ".tet", ".hybrid", ".medit binary", ".iv", ".skc", ".csv"}) {
    CAPTURE(ending);
    CHECK(std::any_of(all.begin(), all.end(), [&](const whole_file& f) { return f.name.ends_with(ending); }));
  }
}

TEST_CASE("damaged formats: files cut off at each tenth and at random bytes") {
  const memory_limit one_gib(std::size_t{1} << 30);
  std::mt19937 random(41);
  for (const whole_file& file : whole_files()) {
    CAPTURE(file.name);
    for (std::size_t k = 0; k < 10; ++k) CHECK(is_read_or_refused_by(file, std::string_view(file.text).substr(0, file.text.size() * k / 10)));
    for (int k = 0; k < 100; ++k) CHECK(is_read_or_refused_by(file, std::string_view(file.text).substr(0, random() % file.text.size())));
  }
  CHECK(!one_gib.was_exceeded());
}

TEST_CASE("damaged formats: files with one changed byte") {
  const memory_limit one_gib(std::size_t{1} << 30);
  std::mt19937 random(42);
  for (const whole_file& file : whole_files()) {
    CAPTURE(file.name);
    std::string text = file.text;
    std::size_t failed = 0;
    for (int k = 0; k < 1000; ++k) {
      char& changed = text[random() % text.size()];
      const char before = changed;
      changed = static_cast<char>(random());
      failed += !is_read_or_refused_by(file, text);
      changed = before;
    }
    CHECK(failed == 0);
  }
  CHECK(!one_gib.was_exceeded());
}
