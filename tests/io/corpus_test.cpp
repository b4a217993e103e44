// Every file of the corpus in the formats of the library agrees with its row of INDEX.tsv or bad/EXPECTED.md. It is read in three ways: by its
// extension, under another extension, and by the header of its format alone (read_alone).
#include <concino/graph/components.hpp>
#include <concino/io.hpp>

#include <support/corpus.hpp>
#include <support/formats.hpp>
#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <map>
#include <sstream>

using namespace concino;
using namespace concino::testing;

namespace {

struct figures {
  std::size_t verts = 0, used = 0, edges = 0, faces = 0, cells = 0, components = 0;  // of which isolated verts are none
  double area = 0, volume = 0;
};

vec3 vector_area(const std::vector<vec3>& p) {
  vec3 sum;
  for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  return 0.5 * sum;
}
double volume_under(const std::vector<vec3>& p) {
  return six_times_volume_under(
             p.size(), [&](std::size_t i) { return p[i]; }, vec3{}) /
         6;
}
template<class M, class R>
std::vector<vec3> points_of(const M& m, const R& around) {
  std::vector<vec3> r;
  for (const auto v : around) r.push_back(point(m, v));
  return r;
}

template<class M>
figures measure(const M& m) {
  figures f;
  f.verts = num_verts(m);
  for (const auto v : verts(m)) f.used += adj_v2p(m, v).begin() != adj_v2p(m, v).end();
  f.edges = num_edges(m);
  f.components = static_cast<std::size_t>(connected_components(m).count) - (f.verts - f.used);
  if constexpr (dimension_v<M> == 2) {
    f.faces = num_polys(m);
    for (const auto p : polys(m)) {
      const auto corners = points_of(m, adj_p2v(m, p));
      f.area += norm(vector_area(corners));
      f.volume += volume_under(corners);
    }
  } else {
    f.faces = num_faces(m);
    f.cells = num_polys(m);
    for (const auto face : faces(m)) {
      std::size_t n = 0;
      for (auto p : adj_f2p(m, face)) n += p == p;
      if (n == 1) f.area += norm(vector_area(points_of(m, adj_f2v(m, face))));
    }
    for (const auto p : polys(m)) {
      double v = 0;
      for (const auto face : adj_p2f(m, p)) v += volume_under(points_of(m, adj_f2v(m, face))) * (face_is_outward(m, p, face) ? 1 : -1);
      f.volume += std::abs(v);
    }
  }
  return f;
}

std::vector<std::string> split(const std::string& line, char at) {
  std::vector<std::string> r;
  std::istringstream in(line);
  for (std::string s; std::getline(in, s, at);) r.push_back(s);
  return r;
}

/// The format with the extension of a file; none if there is no such format.
format_id format_of(const std::filesystem::path& file) {
  format_id found;
  const auto look = [&](auto format) {
    for (const std::string_view extension : format.extensions)
      if (file.extension() == extension) found = format;
  };
  [&]<class... F>(format_list<F...>) { (look(F{}), ...); }(standard_formats);
  return found;
}
bool has_signature(format_id f) {
  for (const format_id other : {format_id(file_format::obj), format_id(file_format::hedra), format_id(file_format::hybrid), format_id(file_format::tet),
                                format_id(file_format::smesh), format_id(file_format::poly), format_id(file_format::abaqus)})
    if (f == other) return false;
  return true;
}

/// Reads a file through the header of its format.
template<class M>
M read_alone(const std::string& path, format_id f, const load_options& options) {
  if constexpr (dimension_v<M> == 2) {  // formats of surfaces and of volumes
    if (f == file_format::obj) return load_obj<M>(path, options);
    if (f == file_format::off) return load_off<M>(path, options);
    if (f == file_format::iv) return load_iv<M>(path, options);
    if (f == file_format::vtp) return load_vtp<M>(path, options);
    if (f == file_format::ply) return load_ply<M>(path, options);
    if (f == file_format::stl) return load_stl<M>(path, options);
    if (f == file_format::smesh) return load_smesh<M>(path, options);
    if (f == file_format::poly) return load_poly<M>(path, options);
  } else {
    if (f == file_format::hedra) return load_hedra<M>(path, options);
    if (f == file_format::hybrid) return load_hybrid<M>(path, options);
    if (f == file_format::tet) return load_tet<M>(path, options);
    if (f == file_format::ovm) return load_ovm<M>(path, options);
    if (f == file_format::ele) return load_ele<M>(path, options);
  }
  if (f == file_format::vtk) return load_vtk<M>(path, options);
  if (f == file_format::vtu) return load_vtu<M>(path, options);
  if (f == file_format::gmsh) return load_gmsh<M>(path, options);
  if (f == file_format::abaqus) return load_abaqus<M>(path, options);
  REQUIRE(f == file_format::medit);
  return load_medit<M>(path, options);
}

/// A link to a file under another extension, beside links to the material libraries of its folder.
class renamed_file {
  temporary_folder folder_;
  std::string path_;

 public:
  renamed_file(const std::filesystem::path& file, const std::string& extension) : path_(folder_ / ("renamed" + extension)) {
    std::filesystem::create_symlink(file, path_);
    for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
      if (entry.path().extension() == ".mtl") std::filesystem::create_symlink(entry.path(), folder_ / entry.path().filename().string());
  }
  const std::string& path() const { return path_; }
};

/// What reading a file leads to: a mesh as a record, or an error as a text, with the line of a parse_error.
struct outcome {
  mesh_record mesh;
  std::string error;
  std::size_t line = 0;
  load_report report;
};
template<class Read>
outcome outcome_of(const std::string& path, const Read& read) {
  outcome r;
  try {
    r.mesh = read(load_options{.report = &r.report});
  } catch (const parse_error& e) {
    r.error = e.expected + ", not " + e.found;
    r.line = e.line;
    CHECK(e.file == path);
  } catch (const unsupported& e) {
    const std::string what = e.what();
    CHECK(what.starts_with(path));
    r.error = what.substr(std::min(path.size(), what.size()));
  }
  return r;
}
mesh_record record_of_any(const any_mesh& m) {
  return std::visit([](const auto& mesh) { return record_of(mesh); }, m);
}

void check_same(const outcome& a, const outcome& expected) {
  CHECK(a.error == expected.error);
  CHECK(a.line == expected.line);
  CHECK((a.mesh == expected.mesh));
  CHECK(a.report.reoriented_polys == expected.report.reoriented_polys);
  CHECK(a.report.skipped == expected.report.skipped);
}

/// Checks that a file is read as under its own name if its extension is another one, and by the header of its format. M is a mesh that can hold it.
/// Small files get more than one other extension.
template<class M>
void check_other_ways(const std::filesystem::path& file, const outcome& expected) {
  const format_id format = format_of(file);
  const bool is_recognised = has_signature(format) && !(expected.line == 1 && !expected.error.empty());  // its signature is not damaged
  const bool is_small = std::filesystem::file_size(file) < 50'000;
  for (const std::string extension : {".renamed", ".hedra", ".vtu"}) {
    if (file.extension() == extension || (extension == ".vtu" && !is_small)) continue;
    CAPTURE(extension);
    const renamed_file renamed(file, extension);
    const auto read = [&](format_id named) {
      return outcome_of(renamed.path(), [&](load_options options) { return options.format = named, record_of_any(load_any(renamed.path(), options)); });
    };
    if (!is_recognised && extension == ".renamed") {
      CHECK(read({}).error.starts_with(": neither the extension nor the first words are those of a known format"));
      check_same(read(format), expected);
    } else if (!is_recognised) {
      CHECK(!read({}).error.empty());
    } else if (extension != ".renamed" || is_small) {
      const outcome by_content = read({});
      check_same(by_content, expected);
      if (expected.error.empty()) CHECK(by_content.report.notes.size() == expected.report.notes.size() + 1);
    }
    if (extension == ".renamed")
      check_same(outcome_of(renamed.path(), [&](const load_options& options) { return record_of(read_alone<M>(renamed.path(), format, options)); }), expected);
  }
}

/// Reads a file by its extension, and in the other ways. Returns the figures of its mesh, if it has no errors.
figures read_in_all_ways(const std::filesystem::path& file, outcome& by_extension) {
  any_mesh m = polygonmesh();
  if (const format_id f = format_of(file); f != file_format::obj && f != file_format::off && f != file_format::ply && f != file_format::stl)
    m = polyhedralmesh();
  by_extension = outcome_of(file.string(), [&](const load_options& options) { return record_of_any(m = load_any(file.string(), options)); });
  return std::visit(
      [&]<class M>(const M& mesh) {
        const bool is_alone = format_of(file) != file_format::ele;  // else the files beside it have to have its name
        if (is_alone && (long_run() || std::filesystem::file_size(file) < 500'000)) check_other_ways<M>(file, by_extension);
        return measure(mesh);
      },
      m);
}

}  // namespace

TEST_CASE("corpus: counts, Euler characteristic, components, area and volume of every file match the index, in whatever way it is read") {
  CONCINO_CORPUS_OR_SKIP(index, "INDEX.tsv");
  std::ifstream in(index);
  std::string line;
  std::getline(in, line);
  std::map<std::string, std::size_t> column;
  for (const std::string& name : split(line, '\t')) column.emplace(name, column.size());
  std::size_t files = 0;
  while (std::getline(in, line)) {
    auto row = split(line, '\t');
    row.resize(column.size());
    const auto at = [&](const char* name) { return row[column.at(name)]; };
    const auto number = [&](const char* name) { return std::stoul(at(name)); };
    const std::string path = at("path");
    if (format_of(path) == format_id() || path.starts_with("bad/") || at("n_verts").empty()) continue;
    const auto file = corpus(path);
    if (file.empty()) continue;
    ++files;
    CAPTURE(path);
    outcome read;
    const figures f = read_in_all_ways(file, read);
    if (path == "tet/quarter_crown_binary.vtu") {  // tests/adapters/zlib_test.cpp reads it
      CHECK(read.error.find("zlib_inflate") != std::string::npos);
      continue;
    }
    CHECK(read.error.empty());
    CHECK(f.verts == number("n_verts"));
    if (!at("n_verts_used").empty()) CHECK(f.used == number("n_verts_used"));
    CHECK(f.edges == number("n_edges"));
    CHECK(f.faces == number("n_faces"));
    CHECK(f.cells == number("n_cells"));
    CHECK(f.components == number("components"));
    CHECK(static_cast<long>(f.used + f.faces) - static_cast<long>(f.edges + f.cells) == std::stol(at("euler_chi")));
    if (!at("area_vec").empty()) CHECK(f.area == doctest::Approx(std::stod(at("area_vec"))).epsilon(1e-9));
    if (!at("volume_ctr").empty()) CHECK(std::abs(f.volume) == doctest::Approx(std::abs(std::stod(at("volume_ctr")))).epsilon(1e-9));
  }
  CHECK(files >= 30);
}

TEST_CASE("corpus: the readers count reoriented polys") {
  CONCINO_CORPUS_OR_SKIP(voronoi, "polyhedral/eight_voronoi.hedra");
  load_report r;
  load<polyhedralmesh>(voronoi, {.report = &r});
  CHECK(r.reoriented_polys >= 2154);
  CONCINO_CORPUS_OR_SKIP(cube, "polyhedral/voronoi_cube_250.hedra");
  load<polyhedralmesh>(cube, {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CONCINO_CORPUS_OR_SKIP(crown, "tet/quarter_crown.mesh");
  load<tetmesh>(crown, {.report = &r});
  CHECK(r.reoriented_polys == 0);
  CHECK(r.skipped.empty());
}

TEST_CASE("corpus: every bad file leads to the expected mesh, or the expected error in the expected line, in whatever way it is read") {
  CONCINO_CORPUS_OR_SKIP(expected, "bad/EXPECTED.md");
  std::ifstream in(expected);
  std::size_t errors = 0, valid = 0;
  for (std::string line; std::getline(in, line);) {
    const auto cells = split(line, '|');
    if (cells.size() < 4) continue;
    const std::string file = cells[1].substr(1, cells[1].size() - 2), expectation = cells[2].substr(1), &facts = cells[3];
    if (format_of(file) == format_id()) continue;
    CAPTURE(file);
    const auto path = corpus("bad/" + file);
    REQUIRE(!path.empty());
    outcome read;
    const figures f = read_in_all_ways(path, read);
    if (!expectation.starts_with("valid")) {
      ++errors;
      const auto k = expectation.find_first_of("0123456789", expectation.find("line "));
      CHECK(!read.error.empty());
      CHECK(read.line == (k == std::string::npos ? 1 : std::stoul(expectation.substr(k))));
      continue;
    }
    ++valid;
    CHECK(read.error.empty());
    // "V 4, E 6, F 4", but also "V 6 of which", "V 4 (1 isolated)" and "readers do not merge: V 6"; what comes after ';' or "merging" is about other meshes
    const auto chi = static_cast<long>(f.used + f.faces) - static_cast<long>(f.edges + f.cells);
    const std::string of_this = facts.substr(0, facts.find("after merging"));
    for (const auto& [letter, count] : {std::pair{"V ", static_cast<long>(f.verts)}, {"E ", static_cast<long>(f.edges)}, {"F ", static_cast<long>(f.faces)},
                                        {"C ", static_cast<long>(f.cells)}, {"chi ", chi}})
      if (const auto k = of_this.find(letter); k != std::string::npos && (k == 0 || of_this[k - 1] == ' ')) CHECK(count == std::stol(of_this.substr(k + std::string(letter).size())));
    if (const auto k = of_this.find(" component"); k != std::string::npos) CHECK(f.components == std::stoul(of_this.substr(k - 1)));
    if (of_this.find("volume 1/6") != std::string::npos) CHECK(f.volume == doctest::Approx(1.0 / 6).epsilon(1e-12));
    if (of_this.find("2.36602540378") != std::string::npos) CHECK(f.area == doctest::Approx(2.36602540378).epsilon(1e-11));
    if (of_this.find("area 1;") != std::string::npos) CHECK(f.area == doctest::Approx(1).epsilon(1e-12));
  }
  CHECK(errors == 23);
  CHECK(valid == 17);
}

TEST_CASE("corpus: every mesh is the same after saving and loading") {
  const temporary_folder dir;
  std::size_t files = 0;
  for (const char* name :
       {"tri/spot_textured.obj", "quad/bamboo_pen_genus8.obj", "polygon/dodecahedron.obj", "polygon/lion_vase_poly.off", "tri/cactus.off",
        "hex/hollow_sphere.mesh", "tet/quarter_crown.mesh", "polyhedral/voronoi_cube_250.hedra", "polyhedral/voronoi_cube_250.hybrid", "polyhedral/voronoi_cube_250.ovm", "polyhedral/agglomerated_crown.hedra"}) {
    const auto file = corpus(name);
    if (file.empty()) continue;
    ++files;
    CAPTURE(name);
    const std::string copy = dir / ("copy" + file.extension().string());
    const any_mesh m = load_any(file);
    std::visit([&](const auto& mesh) { save(mesh, copy); }, m);
    const any_mesh again = load_any(copy);
    REQUIRE(again.index() == m.index());
    std::visit(
        [&]<class M>(const M& mesh) {
          const M& other = std::get<M>(again);
          std::size_t wrong = 0;
          for (const auto v : verts(mesh)) wrong += !(point(mesh, v) == point(other, v));
          for (const auto p : polys(mesh)) {
            const auto a = points_of(mesh, adj_p2v(mesh, p)), b = points_of(other, adj_p2v(other, p));
            wrong += a != b;
          }
          CHECK(wrong == 0);
          CHECK(num_edges(mesh) == num_edges(other));
        },
        m);
  }
  if (files == 0) skip("no corpus");
}
