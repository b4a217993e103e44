// A libFuzzer target for every reader of the library. tests/fuzz/run.sh builds and runs it. The environment variable CONCINO_FUZZ names the reader:
// a format of standard_formats or of skeletons, slices, fields or mtl. What a reader returns is validated, has to keep the laws of its concepts, and
// is saved in every format that can hold it and read back: the second save has to equal the first. Any error that is not typed is a finding.
// With CONCINO_FUZZ_SEEDS=<folder> the program writes a few seeds for the reader to that folder, and ends. CONCINO_FUZZ=list lists the readers.
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/validate.hpp>

#include <concino/adapters/zlib.hpp>

#include <support/foam_text.hpp>

#include <concino/io/detail/obj/read_mtl.hpp>
#include <concino/io/detail/values/read_field.hpp>

#include <support/formats.hpp>
#include <support/temporary.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace concino;
using testing::foam_text_format;

namespace {

/// The formats of texts: a folder of OpenFOAM is fuzzed as one text with all its files.
constexpr auto text_formats = standard_formats + foam_text_format{};

/// Writes a file; a failure ends the program.
void write_seed(const std::string& path, std::string_view text) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (!file || std::fwrite(text.data(), 1, text.size(), file) != text.size()) std::abort();
  std::fclose(file);
}

[[noreturn]] void finding(const std::string& what, std::string_view detail = {}) {
  std::fprintf(stderr, "FINDING: %s\n%.*s\n", what.c_str(), static_cast<int>(std::min<std::size_t>(detail.size(), 4000)), detail.data());
  std::abort();
}

/// Calls f. Result: whether it returned; false if it threw an error of a type that files may cause.
template<class F>
bool succeeds(const F& f) {
  try {
    f();
    return true;
  } catch (const parse_error& e) {
    if (e.line == 0) finding("a parse_error without a line", e.what());
  } catch (const unsupported&) {
  } catch (const invalid_mesh&) {
  }
  return false;
}

/// Checks a mesh that was read, and that every format which can hold it gives the same text for what it reads back. The texts may differ in two cases.
/// MEDIT and VTK list faces with values in the order of the mesh, which from OpenFOAM is any. The reader of OpenFOAM turns cells outward, and which side
/// of a cell that is not closed is outside depends on the order of its faces.
template<class M>
void check_mesh(const M& m, format_id from) {
  for (std::size_t v = 0; v < m.points().size(); ++v)
    if (!is_finite(m.points()[v])) finding("a point that is not finite");
  const auto laws = check_laws(m);
  if (!laws.empty()) finding("a broken law: " + laws[0].law, laws[0].what);
  const bool has_open_cells = validate(m).count(defect_kind::open_cell) > 0;
  for (const format_id f : testing::formats_with_reader(text_formats))
    for (const bool binary : {false, true}) {
      std::string first, second;
      save_report report;
      if (!succeeds([&] { first = save_text(m, text_formats, {.format = f, .report = &report, .binary = binary}); })) continue;
      try {
        const M back = load_text<M>(first, text_formats, {.format = f});
        const bool is_same = num_verts(back) == num_verts(m) && num_polys(back) == num_polys(m);
        if (!is_same && (f != file_format::stl || report.lost.empty())) finding("another number of elements in " + std::string(f.name()), first);
        if constexpr (dimension_v<M> == 3)  // only volumes have faces
          if (report.lost.empty() && num_faces(back) != num_faces(m)) finding("other faces, and nothing is lost, in " + std::string(f.name()), first);
        second = save_text(back, text_formats, {.format = f, .binary = binary});
      } catch (const error& e) {
        finding("a mesh that cannot be read back: " + std::string(f.name()) + ": " + e.what(), first);
      }
      const bool may_differ = f == foam_text_format{} ? has_open_cells && from != f : from == foam_text_format{};
      if (second != first && !may_differ) finding("another second save in " + std::string(f.name()), first + "\n---\n" + second);
    }
}

template<class M>
void read_mesh(std::string_view text, format_id format) {
  succeeds([&] {
    load_report report;
    const auto repeated = static_cast<repeated_verts>(text.empty() ? 0 : static_cast<unsigned char>(text[text.size() / 2]) % 3);
    check_mesh(load_text<M>(text, text_formats, {.format = format, .report = &report, .repeated_verts = repeated, .inflate = zlib_inflate}), format);
  });
}

void fuzz_mesh(std::string_view text, format_id format) {
  read_mesh<polygonmesh>(text, format);
  read_mesh<polyhedralmesh>(text, format);
  succeeds([&] { load_text<surface_arrays>(text, text_formats, {.format = format, .inflate = zlib_inflate}); });
  succeeds([&] { load_text<cell_arrays>(text, text_formats, {.format = format, .inflate = zlib_inflate}); });
}

/// The parts of a text between lines of dashes are the files .node, .ele, .face and .edge.
void fuzz_tetgen(std::string_view text, format_id) {
  static const testing::temporary_folder folder;
  const std::string base = folder / "m";
  for (const char* const extension : {".node", ".ele", ".face", ".edge"}) {
    const std::size_t end = std::min(text.find("--\n"), text.size());
    write_seed(base + extension, text.substr(0, end));
    text.remove_prefix(std::min(end + 3, text.size()));
  }
  succeeds([&] {
    const auto m = load_ele<polyhedralmesh>(base + ".ele", {.repeated_verts = repeated_verts::collapse, .corners_only = true});
    check_mesh(m, file_format::ele);
    save_report report;
    save_ele(m, base + "2.ele", {.report = &report});
    const auto back = load_ele<polyhedralmesh>(base + "2.node");
    if (num_verts(back) != num_verts(m) || num_polys(back) != num_polys(m)) finding("another number of elements in .ele");
  });
}

void fuzz_skeleton(std::string_view text, format_id format) {
  succeeds([&] {
    load_report report;
    const skeleton k = load_skeleton_text(text, {.format = format, .report = &report});
    const auto laws = check_laws(k);
    if (!laws.empty()) finding("a broken law: " + laws[0].law, laws[0].what);
    for (const format_id to : {format_id(file_format::skel), format_id(file_format::cg)}) {
      const std::string first = save_skeleton_text(k, {.format = to});
      const skeleton back = load_skeleton_text(first, {.format = to});
      if (back.points() != k.points() || back.num_edges() != k.num_edges()) finding("another skeleton is read back", first);
      if (save_skeleton_text(back, {.format = to}) != first) finding("another second save", first);
    }
  });
}

void fuzz_slices(std::string_view text, format_id) {
  slices s;
  if (!succeeds([&] { s = load_slices_text(text); })) return;
  for (const bool binary : {false, true}) {
    std::string first;
    if (!succeeds([&] { first = save_slices_text(s, {.binary = binary}); })) continue;  // too large for floats
    const slices back = load_slices_text(first);
    if (!binary && (back.layers != s.layers || back.labels != s.labels)) finding("other slices are read back", first);
    if (save_slices_text(back, {.binary = binary}) != first) finding("another second save", first);
  }
}

void fuzz_fields(std::string_view text, format_id) {
  const auto read = [&](const detail::file_field& wanted) {
    std::uint64_t n = 0;
    const bool is_read = succeeds([&] { detail::read_field(text, "text", wanted, [&](const detail::file_field_value&) { ++n; }); });
    if (n > wanted.count || (is_read && n != wanted.count)) finding("another number of values");
  };
  for (const std::uint64_t count : {0u, 1u, 4u}) {
    read({.count = count});
    read({.count = count, .elements = "polys", .size = 3});
    read({.count = count, .are_integers = true, .low = -128, .high = 127});
    read({.count = count, .max_number = 3e38});
  }
}

void fuzz_mtl(std::string_view text, format_id) {
  detail::material_library library;
  load_report report;
  succeeds([&] { detail::read_mtl(text, "text", library, report); });
}

struct reader {
  std::string name;
  format_id format;
  void (*fuzz)(std::string_view, format_id);
};

std::vector<reader> all_readers() {
  std::vector<reader> all;
  for (const format_id f : testing::formats_with_reader(text_formats))
    if (f != file_format::openfoam) all.push_back({std::string(f.name()), f, f == file_format::ele ? &fuzz_tetgen : &fuzz_mesh});
  for (const format_id f : {format_id(file_format::cg), format_id(file_format::skc), format_id(file_format::skel), format_id(file_format::csv)})
    all.push_back({std::string(f.name()), f, &fuzz_skeleton});
  all.push_back({"slices", {}, &fuzz_slices});
  all.push_back({"fields", {}, &fuzz_fields});
  all.push_back({"mtl", {}, &fuzz_mtl});
  return all;
}

/// Small meshes with what formats may store.
template<class M>
void save_seeds(M m, const std::string& prefix, format_id format) {
  auto label = poly_property<int>(m, "label");
  for (const poly_id p : polys(m)) label[p] = static_cast<int>(p.raw() % 3);
  auto heat = vert_property<double>(m, "heat");
  auto normal = vert_property<vec3>(m, "normal");
  for (const vert_id v : verts(m)) heat[v] = 0.1 * v.raw(), normal[v] = {0, 0.6, -0.8};
  for (const bool binary : {false, true})
    succeeds([&] { write_seed(prefix + (binary ? "_binary" : "_text"), save_text(m, text_formats, {.format = format, .binary = binary})); });
}

/// Files of version 4.1 of the format of Gmsh, which is read and not written, and one of version 2.2 with tags of all kinds.
void write_gmsh_seeds(const std::string& prefix) {
  write_seed(prefix + "_4",
             "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 7 \"a b\"\n2 5 \"wall\"\n$EndPhysicalNames\n$Entities\n1 1 1 1\n4 0 0 0 1 5\n"
             "2 0 0 0 1 0 0 1 -8 2 4 -5\n1 0 0 0 1 1 0 2 5 6 1 2\n7 0 0 0 1 1 1 1 7 2 1 2\n$EndEntities\n$PartitionedEntities\n2\n1\n5 1\n0 0 1 0\n3 2 1 1 2 0 0 0 1 1 1 1 9 0\n"
             "$EndPartitionedEntities\n$Nodes\n2 5 3 90\n3 7 0 4\n10\n20\n7\n90\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 1 1 1\n3\n0 0 -1 .5 .25\n$EndNodes\n"
             "$Elements\n5 6 1 90\n0 4 15 1\n1 10\n1 2 1 1\n2 20 10\n2 1 2 1\n90 7 20 10\n2 3 2 1\n5 10 20 90\n3 7 4 2\n8 10 20 7 90\n9 10 7 20 3\n$EndElements\n$Periodic\n0\n"
             "$EndPeriodic\n$NodeData\n1\n\"t\"\n1\n0.5\n3\n0\n3\n2\n10 1 2 3\n3 4 5 6\n$EndNodeData\n$ElementData\n1\n\"e\"\n0\n3\n0\n1\n3\n8 1\n90 2\n2 3\n$EndElementData\n");
  std::string binary = "$MeshFormat\n4.1 1 8\n";
  const auto put = [&](unsigned bytes, std::initializer_list<int> numbers) {
    for (const int x : numbers)
      for (unsigned k = 0; k < bytes; ++k) binary += static_cast<char>(k < 4 ? x >> 8 * k & 0xff : x < 0 ? -1 : 0);
  };
  put(4, {1});
  binary += "\n$EndMeshFormat\n$Entities\n";
  put(8, {0, 0, 1, 0}), put(4, {1}), binary.append(48, '\0'), put(8, {1}), put(4, {3}), put(8, {0});
  binary += "\n$EndEntities\n$Nodes\n";
  put(8, {1, 3, 1, 3}), put(4, {2, 1, 0}), put(8, {3, 1, 2, 3});
  for (const char* const point : {"\0\0\0\0\0\0\0", "\0\0\0\0\0\0\xf0\x3f", "\0\0\0\0\0\0\x08\x40"}) binary.append(point, 8).append(8, '\0').append(point, 8);
  binary += "\n$EndNodes\n$Elements\n";
  put(8, {1, 1, 1, 1}), put(4, {2, 1, 2}), put(8, {1, 5, 1, 2, 3});
  binary += "\n$EndElements\n$ElementData\n1\n\"v\"\n0\n3\n0\n1\n1\n";
  put(4, {5}), binary.append(8, '\0');
  write_seed(prefix + "_4_binary", binary + "\n$EndElementData\n");
  write_seed(prefix + "_2", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n9 0 0 1\n$EndNodes\n$Elements\n5\n1 2 2 4 1 1 2 3\n2 2 2 5 1 1 2 3\n"
                            "3 2 4 6 -2 1 2 1 2 9\n4 1 1 9 1 2\n5 15 0 9\n$EndElements\n");
}

void write_seeds(const reader& r, const std::string& folder) {
  const std::string prefix = folder + "/" + r.name;
  if (r.fuzz == &fuzz_mesh) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.25\nv 0 0 1\nv 1 0 1\nv 1 1 1\n";
    save_seeds(load_text<polygonmesh>(points + "f 1 3 2\nf 1 4 3\n", file_format::obj), prefix + "_triangles", r.format);
    save_seeds(load_text<polygonmesh>(points + "f 1 2 6 5\nf 5 6 7\nf 1 4 3 7 2\n", file_format::obj), prefix + "_polygons", r.format);
    const std::string cube = "MeshVersionFormatted 2 Dimension 3 Vertices 9 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 0 1 0 1 0 1 0 1 1 1 0 0 1 1 0 .5 .5 2 0 ";
    save_seeds(load_text<polyhedralmesh>(cube + "Tetrahedra 2 1 2 3 6 0 1 3 4 8 1 End", file_format::medit), prefix + "_tets", r.format);
    save_seeds(load_text<polyhedralmesh>(cube + "Hexahedra 1 1 2 3 4 5 6 7 8 2 Pyramids 1 5 6 7 8 9 1 Prisms 1 1 2 3 5 6 7 3 End", file_format::medit), prefix + "_cells", r.format);
    save_seeds(load_text<polyhedralmesh>("5 7 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n3 1 2 5\n3 2 3 5\n3 1 3 5\n4 1 2 3 4\n4 -1 5 6 -7\n",
                                         file_format::hedra),
               prefix + "_polyhedra", r.format);
    if (r.name == "foam_text") {
      const std::string head = "FoamFile { version 2.0; format ascii; class ";
      write_seed(prefix + "_words", "@@points\n/* c */ " + head + "vectorField; }\n4((0 0 0) (1 0 0) (0 1 0) (0 0 1)) // c\n@@faces\n" + head +
                                        "faceList; }\n4(3(0 2 1) 3(0 1 3) 3(1 2 3) 3(2 0 3))\n@@owner\n" + head + "labelList; note \"a;b\"; }\n4{0}\n@@neighbour\n" + head +
                                        "labelList; }\n4(-1 -1 -1 -1)\n@@boundary\n" + head + "polyBoundaryMesh; }\n2(a { type wall; inGroups 1(w); d { x (1 2); } nFaces 1; startFace 0; } b { startFace "
                                        "1; nFaces 3; })\n@@cellZones\n" + head + "regIOobject; }\n1(z { type cellZone; cellLabels List<label> 1(0); })\n@@faceZones\n" + head + "regIOobject; }\n1(z{})\n");
    }
    if (r.name == "iv")
      write_seed(prefix, "#Inventor V2.1 ascii\nSeparator { VertexProperty { vertex [ 0 0 0, 1 0 0, 0 1 0, 0 0 1 ] } IndexedFaceSet { coordIndex [ 0, 2, 1, -1, 0, 1, 3, -1 ] "
                         "materialIndex [ 0, 1 ] } Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } IndexedFaceSet { coordIndex [ 0, 1, 2, 3, -1 ] } }\n");
    if (r.name == "gmsh") write_gmsh_seeds(prefix);
    if (r.name == "pvtu")  // the pieces are other files
      write_seed(prefix, "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\">\n<PUnstructuredGrid GhostLevel=\"1\">\n<PPointData GlobalIds=\"i\">\n<PDataArray type=\"Int64\" "
                         "Name=\"i\"/>\n</PPointData>\n<PPoints>\n<PDataArray type=\"Float32\" NumberOfComponents=\"3\"/>\n</PPoints>\n<Piece Source=\"a/b.vtu\"/>\n</PUnstructuredGrid>\n</VTKFile>\n");
    if (r.name == "abaqus") {
      write_seed(prefix + "_cells", "*HEADING\n** a comment\n*PART, NAME=p\n*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n90, .5, .5, 2\n"
                                    "*Element, type=C3D8R, elset=\"a hex\"\n10, 1, 2, 3, 4,\n5, 6, 7, 8\n*ELEMENT, TYPE=C3D5\n20, 5, 6, 7, 8, 90\n*NSET, NSET=n, GENERATE\n1, 8, 2\n*ELSET, ELSET=e\n20, a hex\n"
                                    "*END PART\n*ASSEMBLY\n*INSTANCE, NAME=i, PART=p\n0, 0, 0\n*END INSTANCE\n*NSET, NSET=m, INSTANCE=i\n90,\n*END ASSEMBLY\n");
      write_seed(prefix + "_shells", "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1D0\n4, 0, 1\n*ELEMENT, TYPE=S4R\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=S3, ELSET=t\n2, 1, 2, 3\n");
    }
  } else if (r.fuzz == &fuzz_tetgen) {
    write_seed(prefix, "5 3 1 1\n1 0 0 0 .5 7\n2 1 0 0 -1 0\n3 0 1 0 2 -3\n4 0 0 1 0 0\n5 1 1 1 1e3 2\n--\n2 4 2\n1 1 2 3 4 10 0.5\n2 2 3 4 5 -20 1\n--\n2 1\n1 1 2 3 5\n2 4 3 2 6\n--\n1 1\n1 3 4 9\n");
  } else if (r.fuzz == &fuzz_skeleton) {
    const skeleton k({{0, 0, 0}, {1, 0, 0.5}, {0, 1e-3, 0}}, {{vert_id{0}, vert_id{1}}, {vert_id{2}, vert_id{1}}}, {0.5, 1, 2});
    succeeds([&] { write_seed(prefix, save_skeleton_text(k, {.format = r.format})); });
    if (r.name == "skc") write_seed(prefix, "3 2\n0 0 0\n1 0 0\n0 1 0\n0 1 .5 .25 1 2 17 18\n1 2 0 0 0 0\n");
    if (r.name == "csv") write_seed(prefix, "x,y,z\n0,0,0,1\n1 0 0 2\n1;1;0\n");
  } else if (r.fuzz == &fuzz_slices) {
    slices s;
    s.units = 0.5;
    s.labels = {{3, "a part"}};
    slice_layer& layer = s.layers.emplace_back();
    const slice_point square[] = {{0, 0}, {1, 0}, {1, 1.5}, {0, 1}};
    for (slice_lines* lines : {&layer.outer, &layer.inner, &layer.open, &layer.hatches}) lines->push_back(square, 3);
    s.layers.push_back(layer);
    write_seed(prefix + "_text", save_slices_text(s));
    write_seed(prefix + "_binary", save_slices_text(s, {.binary = true}));
    write_seed(prefix + "_words", "$$HEADERSTART //c// $$ASCII\n$$UNITS/2\n$$VERSION/200\n$$DATE/070493\n$$DIMENSION/0,0,0,1,1,1\n$$LAYERS/1\n$$ALIGN\n$$USERDATA/x,2,ab"
                                  "$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/1\n$$POLYLINE/1,2,1,2,3\n$$END\n");
    std::string aligned = "$$HEADERSTART\n$$BINARY\n$$UNITS/1\n$$ALIGN\n$$HEADEREND";
    aligned += std::string("\x80\0\5\0\x81\0\1\0\1\0\1\0\2\0\3\0\x83\0\1\0\1\0\1\0\2\0\3\0\4\0\0\0", 32);
    write_seed(prefix + "_short", aligned);
  } else if (r.fuzz == &fuzz_fields) {
    write_seed(prefix + "_scalar", "SCALAR_FIELD 4\n1\n-2.5e-3\ninf\nnan\n");
    write_seed(prefix + "_vector", "VECTOR_FIELD 4\n1 2 3\n4 5 6\n7 8 9\n0 0 1\n");
    write_seed(prefix + "_bare", "1\n-128\n127\n3\n");
  } else {
    write_seed(prefix, "# a library\nnewmtl steel\nKd 0.5 0.25 1\nd 0.5\nTr 0.25\nmap_Kd a b.png\nnewmtl glass\nKd spectral x\nKs 1 1 1\n");
  }
}

const reader* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  static const std::vector<reader> all = all_readers();
  const char* const name = std::getenv("CONCINO_FUZZ");
  for (const reader& r : all)
    if (name && r.name == name) chosen = &r;
  if (!chosen) {
    for (const reader& r : all) std::printf("%s\n", r.name.c_str());
    std::exit(name && std::strcmp(name, "list") == 0 ? 0 : 2);
  }
  if (const char* const folder = std::getenv("CONCINO_FUZZ_SEEDS")) {
    write_seeds(*chosen, folder);
    std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->fuzz({reinterpret_cast<const char*>(data), size}, chosen->format);
  return 0;
}
