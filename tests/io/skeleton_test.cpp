#include <concino/io/skeleton.hpp>

#include <concino/core/error.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/graph/spanning_tree.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/corpus.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

double total_length(const skeleton& k) {
  double sum = 0;
  for (const auto& [a, b] : k.edges()) {
    const vec3 d = k.point(a) - k.point(b);
    sum += std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  }
  return sum;
}

std::map<std::size_t, std::size_t> degrees(const skeleton& k) {
  std::map<std::size_t, std::size_t> all;
  for (const vert_id v : verts(k)) ++all[k.neighbours(v).size()];
  return all;
}

skeleton skeleton_of(const std::string& text, format_id format, load_report* report = nullptr) {
  return load_skeleton_text(text, {.format = format, .report = report});
}

std::size_t skeleton_error_line(const std::string& text, format_id format, std::string* message = nullptr) {
  try {
    skeleton_of(text, format);
  } catch (const parse_error& e) {
    if (message) *message = e.what();
    return e.line;
  }
  return 0;
}

/// Whether the text is a skeleton that keeps the laws and can be written and read again, or a parse_error in one of its lines.
bool skeleton_survives(const std::string& text, format_id format) {
  try {
    const skeleton k = skeleton_of(text, format);
    if (!check_laws(k).empty()) return false;
    for (const format_id to : {format_id(file_format::skel), format_id(file_format::cg)}) {
      const std::string first = save_skeleton_text(k, {.format = to});
      const skeleton back = skeleton_of(first, to);
      if (back.points() != k.points() || back.num_edges() != k.num_edges() || save_skeleton_text(back, {.format = to}) != first) return false;
    }
    return true;
  } catch (const parse_error& e) {
    return e.line >= 1 && e.line <= std::size_t{1} + text.size();
  }
}

const std::string small_skel =
    "ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n4\n10 0 0 0 0.5 2 -3 7\n7 1 0 0 0.25 1 10\n-3 0 1 0 0.125 1 10\n8 5 5 5 1e-3 0\n";
const std::string small_cg = "# D:3 NV:4 NE:3\nv 0 0 0 0.5\nv 1 0 0\nv 0 1e0 0 0.25\nv 1 1 1\ne 1 2\ne 3 1\ne 2 3\n";
const std::string small_skc = "4 3\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n0 1 .5 .25 1 2 17 18\n1 2 0 0 0 0\n2 3 1 1 1 1 4\n";
const std::string small_csv = "x,y,z,label\n0,0,0,1\n1 0 0 2\n1;1;0\n\n 2, 2 ,2.5\n";

}  // namespace

TEST_CASE("skeletons: the files of the corpus have the figures of the index, and keep the laws of graphs") {
  struct row {
    const char* file;
    std::size_t verts, edges;
    double length;
    std::map<std::size_t, std::size_t> degrees;
  };
  const row rows[] = {{"skeletons/cactus.skel", 180, 179, 1.5298682112, {{1, 4}, {2, 174}, {3, 2}}},
                      {"skeletons/moebius.cg", 20, 30, 15.0811171004, {{3, 20}}},
                      {"skeletons/stickwoman.cg", 19, 19, 58.5836526704, {{1, 4}, {2, 12}, {3, 2}, {4, 1}}}};
  const temporary_folder folder;
  for (const row& r : rows) {
    const std::string path = corpus(r.file);
    if (path.empty()) return skip(std::string("no corpus file ") + r.file);
    CAPTURE(r.file);
    load_report report;
    const skeleton k = load_skeleton(path, {.report = &report});
    CHECK(report.skipped.empty());
    CHECK(num_verts(k) == r.verts);
    CHECK(num_edges(k) == r.edges);
    CHECK(total_length(k) == doctest::Approx(r.length).epsilon(1e-10));
    CHECK(degrees(k) == r.degrees);
    CHECK(connected_components(k).count == 1);
    CHECK(check_laws(k).empty());
    for (const char* name : {"a.skel", "a.cg"}) {
      save_skeleton(k, folder / name);
      const skeleton back = load_skeleton(folder / name);
      CHECK(back.points() == k.points());
      CHECK(back.num_edges() == k.num_edges());
      for (const vert_id v : verts(k)) {
        CHECK(back.radius(v) == k.radius(v));
        CHECK(std::vector<vert_id>(back.neighbours(v).begin(), back.neighbours(v).end()) == std::vector<vert_id>(k.neighbours(v).begin(), k.neighbours(v).end()));
      }
      const std::string first = read_file(folder / name);
      save_skeleton(back, folder / name);
      CHECK(read_file(folder / name) == first);
    }
    write_file(folder / "wrong.csv", read_file(path));
    CHECK(load_skeleton(folder / "wrong.csv", {.report = &report}) == k);
    CHECK(report.notes.front().starts_with("the extension is not ."));
  }
}

TEST_CASE("skeletons: bad files of the corpus are errors with their lines") {
  CONCINO_CORPUS_OR_SKIP(edge, "bad/cg_edge_out_of_range.cg");
  CONCINO_CORPUS_OR_SKIP(neighbour, "bad/skel_neighbour_out_of_range.skel");
  const auto message_of = [](const std::string& path) {
    try {
      load_skeleton(path);
    } catch (const parse_error& e) {
      return std::to_string(e.line) + " " + e.expected + " | " + e.found;
    }
    return std::string();
  };
  CHECK(message_of(edge) == "4 an edge between verts from 1 to 2 | 'e'");
  CHECK(message_of(neighbour) == "4 a neighbour that is the id of a node | '7'");
}

TEST_CASE("skeletons: .skel has any ids, lists arcs from both ends, and keeps isolated nodes") {
  load_report report;
  const skeleton k = skeleton_of(small_skel, {}, &report);
  CHECK(num_verts(k) == 4);
  CHECK(k.edges() == std::vector<std::array<vert_id, 2>>{{vert_id{0}, vert_id{2}}, {vert_id{0}, vert_id{1}}});
  CHECK(k.radii() == std::vector<double>{0.5, 0.25, 0.125, 1e-3});
  CHECK(k.radius(vert_id{2}) == 0.125);
  CHECK(point(k, vert_id{3}).x == 5);
  CHECK(k.neighbours(vert_id{3}).empty());
  CHECK(report.notes == std::vector<std::string>{"the ids of the nodes are not 0, 1, 2 ...; verts are numbered in the order of the file"});
  CHECK(report.skipped.empty());

  const skeleton odd = skeleton_of("ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n2\n0 0 0 0 1 3 1 0 1\n1 1 0 0 -1 0\nmore\n", {}, &report);
  CHECK(odd.num_edges() == 1);
  CHECK(odd.radius(vert_id{1}) == -1);
  CHECK(report.skipped == std::vector<std::string>{"1 edges from a vert to itself", "1 edges that the file lists again", "what follows the last node, from line 5 on"});
  CHECK(report.notes == std::vector<std::string>{"1 edges are listed by one of their verts only"});
}

TEST_CASE("skeletons: .cg has indices from 0 or 1, and radii or none") {
  load_report report;
  const skeleton k = skeleton_of(small_cg, {}, &report);
  CHECK(k.edges() == std::vector<std::array<vert_id, 2>>{{vert_id{0}, vert_id{1}}, {vert_id{2}, vert_id{0}}, {vert_id{1}, vert_id{2}}});
  CHECK(k.radii() == std::vector<double>{0.5, 0, 0.25, 0});
  CHECK(report.notes == std::vector<std::string>{"2 verts have no radius in the file; it was set to 0", "no edge has the index 0: indices were read as beginning at 1"});
  const skeleton from_0 = skeleton_of("v 0 0 0\r\nv 1 0 0\r\n# NV:1\r\nvn 1 2 3\r\ne 0 1\r\ne 1 0\r\ne 1 1", file_format::cg, &report);
  CHECK(from_0.num_edges() == 1);
  CHECK_FALSE(from_0.has_radii());
  CHECK(report.notes.empty());
  CHECK(report.skipped == std::vector<std::string>{"1 edges from a vert to itself", "1 edges that the file lists again", "1 lines that are neither verts nor edges"});
  CHECK(skeleton_of("# D:3 NV:1 NE:0\nv 1 2 3\nv 4 5 6\n", {}, &report).num_verts() == 2);
  CHECK(report.notes == std::vector<std::string>{"the file states 1 verts and 0 edges, but has 2 and 0"});
  CHECK(skeleton_of("# D:3 NV:0 NE:0\n", {}).num_verts() == 0);
}

TEST_CASE("skeletons: .skc and .csv") {
  load_report report;
  const skeleton k = skeleton_of(small_skc, file_format::skc, &report);
  CHECK(num_verts(k) == 4);
  CHECK(k.edges() == std::vector<std::array<vert_id, 2>>{{vert_id{0}, vert_id{1}}, {vert_id{1}, vert_id{2}}, {vert_id{2}, vert_id{3}}});
  CHECK(report.skipped == std::vector<std::string>{"three numbers and a list of integers of each of 3 edges"});
  const skeleton path = skeleton_of(small_csv, file_format::csv, &report);
  CHECK(path.points() == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 2, 2.5}});
  CHECK(path.num_edges() == 3);
  CHECK(report.skipped == std::vector<std::string>{"the first line, which has no numbers", "a fourth number of 2 points"});
}

TEST_CASE("skeletons: errors name the line") {
  const std::string header = "ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n";
  const auto skel = [&](const std::string& text) { return skeleton_error_line(text, file_format::skel); };
  CHECK(skel("") == 1);
  CHECK(skel("ID Cx Cy\n") == 1);
  CHECK(skel(header + "2\n0 0 0 0 1 0\n") == 3);
  CHECK(skel(header + "-1\n") == 2);
  CHECK(skel(header + "1\n0 0 0 nan 1 0\n") == 3);
  CHECK(skel(header + "1\n0 0 0 0 inf 0\n") == 3);
  CHECK(skel(header + "1\n0 0 0 0 1 -1\n") == 3);
  CHECK(skel(header + "3\n5 0 0 0 1 0\n6 1 1 1 1 0\n5 2 2 2 2 0\n") == 5);
  CHECK(skel(header + "2\n0 0 0 0 1 1 1\n1 0 0 0 1 2 0 2\n") == 4);
  CHECK(skel(header + "2\n4 0 0 0 1 1 1\n1 0 0 0 1 2 0\n2\n") == 4);
  const auto cg = [&](const std::string& text) { return skeleton_error_line(text, file_format::cg); };
  CHECK(cg("") == 1);
  CHECK(cg("# D:3 NV:3 NE:0\nv 0 0 0\nv 1 1 1\n") == 3);
  CHECK(cg("v 0 0\n") == 1);
  CHECK(cg("v 0 0 0 1 2\n") == 1);
  CHECK(cg("v 0 0 x\n") == 1);
  CHECK(cg("v 0 0 inf\n") == 1);
  CHECK(cg("v 0 0 0\nv 1 1 1\ne 1\n") == 3);
  CHECK(cg("v 0 0 0\nv 1 1 1\ne 1 2 3\n") == 3);
  CHECK(cg("v 0 0 0\nv 1 1 1\ne -1 1\n") == 3);
  CHECK(cg("v 0 0 0\nv 1 1 1\ne 0 1\n#\ne 1 2\n") == 5);
  CHECK(cg("# D:3 NV:0 NE:1\ne 1 1\n") == 2);
  CHECK(cg("12\n") == 1);
  const auto skc = [&](const std::string& text) { return skeleton_error_line(text, file_format::skc); };
  CHECK(skc("1 0\n") == 1);
  CHECK(skc("1 1\n0 0 0\n0 1 0 0 0 0\n") == 3);
  CHECK(skc("0 1\n0 0 0 0 0 0\n") == 2);
  CHECK(skc("2 1\n0 0 0\n1 1 1\n0 1 0 0 0 2 1\n") == 4);
  const auto csv = [&](const std::string& text) { return skeleton_error_line(text, file_format::csv); };
  CHECK(csv("") == 1);
  CHECK(csv("x y z\n") == 1);
  CHECK(csv("nan 0 0\n") == 1);
  CHECK(csv("0 0 0\n1 2\n") == 2);
  CHECK(csv("0 0 0\n1 2 3 4 5\n") == 2);
  CHECK(csv("0 0 0\n1 2 3x\n") == 2);
  CHECK_THROWS_AS(load_skeleton("no/such/file.skel"), io_error);
}

TEST_CASE("skeletons: formats that cannot be determined, read or written are unsupported") {
  const temporary_folder folder;
  write_file(folder / "a.xyz", "0 0 0\n");
  CHECK_THROWS_AS(load_skeleton(folder / "a.xyz"), unsupported);
  CHECK(load_skeleton(folder / "a.xyz", {.format = file_format::csv}).num_verts() == 1);
  CHECK_THROWS_AS(load_skeleton_text("0 0 0\n"), unsupported);
  const skeleton k = skeleton_of(small_skel, {});
  for (const char* name : {"a.skc", "a.csv", "a.obj"}) CHECK_THROWS_AS(save_skeleton(k, folder / name), unsupported);
  CHECK_THROWS_AS(save_skeleton(k, folder / "a.skel", {.binary = true}), unsupported);
  CHECK_THROWS_AS(save_skeleton_text(k, {}), unsupported);
  const auto stop = [](double, const char*) { return false; };
  CHECK_THROWS_AS(save_skeleton(k, folder / "a.skel", {.progress = stop}), cancelled);
  CHECK_THROWS_AS(load_skeleton_text(small_skel, {.progress = stop}), cancelled);
  skeleton bad = k;
  bad.set_radius(vert_id{1}, std::numeric_limits<double>::infinity());
  CHECK_THROWS_AS(save_skeleton(bad, folder / "a.skel"), invalid_mesh);
  bad.set_radius(vert_id{1}, 1);
  bad.set_point(vert_id{0}, {0, std::nan(""), 0});
  CHECK_THROWS_AS(save_skeleton(bad, folder / "a.cg"), invalid_mesh);
  CHECK(folder.num_files() == 1);
}

TEST_CASE("skeletons: truncated and changed files are read or are errors") {
  std::vector<std::pair<std::string, format_id>> texts = {
      {small_skel, file_format::skel}, {small_cg, file_format::cg}, {small_skc, file_format::skc}, {small_csv, file_format::csv}};
  for (const char* file : {"skeletons/cactus.skel", "skeletons/moebius.cg", "skeletons/stickwoman.cg"})
    if (const std::string path = corpus(file); !path.empty()) texts.push_back({read_file(path), path.ends_with(".cg") ? format_id(file_format::cg) : format_id(file_format::skel)});
  std::mt19937 random(3);
  for (const auto& [text, format] : texts) {
    for (std::size_t i = 0; i < 10; ++i) CHECK(skeleton_survives(text.substr(0, text.size() * i / 10), format));
    for (int i = 0; i < 100; ++i) CHECK(skeleton_survives(text.substr(0, random() % text.size()), format));
    const int rounds = text.size() < 5000 || long_run() ? 1000 : 100;
    for (int i = 0; i < rounds; ++i) {
      std::string changed = text;
      changed[random() % text.size()] = static_cast<char>(random());
      CHECK(skeleton_survives(changed, format));
    }
  }
}
