// Every file of the corpus in the formats of the library agrees with its row of INDEX.tsv or bad/EXPECTED.md.
#include <concino/io.hpp>

#include <support/corpus.hpp>
#include <support/formats.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <map>
#include <optional>
#include <sstream>

using namespace concino;
using namespace concino::testing;

namespace {

struct figures {
  std::size_t verts = 0, used = 0, edges = 0, faces = 0, cells = 0;
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

bool is_known(const std::string& file) {
  return (" " + extensions_of(standard_formats) + ",").find(' ' + std::filesystem::path(file).extension().string() + ',') != std::string::npos;
}

}  // namespace

TEST_CASE("corpus: counts, Euler characteristic, area and volume of every file match the index") {
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
    if (!is_known(path) || path.starts_with("bad/") || at("n_verts").empty()) continue;
    const auto file = corpus(path);
    if (file.empty()) continue;
    ++files;
    CAPTURE(path);
    if (path == "tet/quarter_crown_binary.vtu") {  // tests/adapters/zlib_test.cpp reads it
      CHECK_THROWS_AS(load_any(file), unsupported);
      continue;
    }
    const any_mesh m = load_any(file);
    const figures f = std::visit([](const auto& mesh) { return measure(mesh); }, m);
    CHECK(f.verts == number("n_verts"));
    CHECK(f.used == number("n_verts_used"));
    CHECK(f.edges == number("n_edges"));
    CHECK(f.faces == number("n_faces"));
    CHECK(f.cells == number("n_cells"));
    CHECK(static_cast<long>(f.used + f.faces) - static_cast<long>(f.edges + f.cells) == std::stol(at("euler_chi")));
    CHECK(f.area == doctest::Approx(std::stod(at("area_vec"))).epsilon(1e-9));
    if (!at("volume_ctr").empty()) CHECK(std::abs(f.volume) == doctest::Approx(std::stod(at("volume_ctr"))).epsilon(1e-9));
  }
  CHECK(files >= 30);
}

TEST_CASE("corpus: files with a signature are read as what they are, whatever their extension") {
  if (corpus_dir().empty()) return skip("no corpus");
  const temporary_folder dir;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus_dir())) {
    const std::string extension = entry.path().extension().string();
    const bool has_signature = extension == ".off" || extension == ".mesh" || extension == ".vtk" || extension == ".vtu";
    if (!entry.is_regular_file() || !has_signature || entry.file_size() > 200'000) continue;
    CAPTURE(entry.path().string());
    const std::string copy = dir / (extension == ".off" ? "copy.hedra" : "copy.obj");
    std::filesystem::copy_file(entry.path(), copy, std::filesystem::copy_options::overwrite_existing);
    const auto counts = [](const std::string& path, load_report& report) -> std::string {
      try {
        return std::visit([](const auto& m) { return core::joined({num_verts(m), " ", num_edges(m), " ", num_polys(m)}); }, load_any(path, {.report = &report}));
      } catch (const parse_error& e) {
        return core::joined({"line ", e.line, ": ", e.expected});
      } catch (const unsupported&) {
        return "unsupported";
      }
    };
    load_report as_it_is, under_another_name;
    const std::string expected = counts(entry.path().string(), as_it_is), found = counts(copy, under_another_name);
    if (expected.starts_with("line 1:")) continue;  // the signature is damaged
    ++files;
    CHECK(found == expected);
    if (found[0] >= '0' && found[0] <= '9') CHECK(under_another_name.notes.size() == as_it_is.notes.size() + 1);
  }
  CHECK(files >= 15);
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

TEST_CASE("corpus: every bad file causes the expected error in the expected line") {
  CONCINO_CORPUS_OR_SKIP(expected, "bad/EXPECTED.md");
  std::ifstream in(expected);
  std::size_t errors = 0, valid = 0;
  for (std::string line; std::getline(in, line);) {
    const auto cells = split(line, '|');
    if (cells.size() < 4) continue;
    const std::string file = cells[1].substr(1, cells[1].size() - 2), outcome = cells[2].substr(1);
    if (!is_known(file)) continue;
    CAPTURE(file);
    const auto path = corpus("bad/" + file);
    REQUIRE(!path.empty());
    if (outcome.starts_with("valid")) {
      ++valid;
      const figures f = std::visit([](const auto& mesh) { return measure(mesh); }, load_any(path));
      // "V 4, E 6, F 4", but also "V 6 of which", "V 4 (1 isolated)" and "readers do not merge: V 6"
      for (const auto& [letter, count] : {std::pair{"V ", f.verts}, {"E ", f.edges}, {"F ", f.faces}, {"C ", f.cells}})
        if (const auto k = cells[3].find(letter); k != std::string::npos && (k == 0 || cells[3][k - 1] == ' '))
          CHECK(count == std::stoul(cells[3].substr(k + 2)));
      if (cells[3].find("volume 1/6") != std::string::npos) CHECK(f.volume == doctest::Approx(1.0 / 6).epsilon(1e-12));
      if (cells[3].find("2.36602540378") != std::string::npos) CHECK(f.area == doctest::Approx(2.36602540378).epsilon(1e-11));
    } else {
      ++errors;
      const auto k = outcome.find("line ");
      const std::size_t on = k == std::string::npos ? 1 : std::stoul(outcome.substr(k + 5));
      try {
        load_any(path);
        FAIL_CHECK("loaded");
      } catch (const parse_error& e) {
        CHECK(e.line == on);
        CHECK(e.file == path);
      }
    }
  }
  CHECK(errors == 21);
  CHECK(valid == 16);
}

TEST_CASE("corpus: every mesh is the same after saving and loading") {
  const temporary_folder dir;
  std::size_t files = 0;
  for (const char* name :
       {"tri/spot_textured.obj", "quad/bamboo_pen_genus8.obj", "polygon/dodecahedron.obj", "polygon/lion_vase_poly.off", "tri/cactus.off",
        "hex/hollow_sphere.mesh", "tet/quarter_crown.mesh", "polyhedral/voronoi_cube_250.hedra", "polyhedral/voronoi_cube_250.hybrid", "polyhedral/agglomerated_crown.hedra"}) {
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
