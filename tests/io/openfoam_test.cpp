// polyMesh folders: what is saved is what is loaded, in the order that OpenFOAM needs, and a save that fails leaves the folder as it was.
#include <concino/io/openfoam.hpp>

#include <concino/generate.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh.hpp>
#include <concino/validate.hpp>

#include <support/corpus.hpp>
#include <support/foam_text.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;
namespace fs = std::filesystem;

namespace {

std::map<std::string, std::string> contents_of(const std::string& folder) {
  std::map<std::string, std::string> all;
  if (fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder)) all[entry.path().generic_string()] = entry.is_regular_file() ? read_file(entry.path().generic_string()) : "";
  return all;
}

template<class M>
std::vector<std::size_t> verts_of_face(const M& m, poly_t<M> p, face_t<M> f) {
  std::vector<std::size_t> v;
  for (const auto x : adj_f2v(m, f)) v.push_back(index_of(m, x));
  if (!face_is_outward(m, p, f)) std::reverse(v.begin(), v.end());
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  return v;
}

/// Each poly as the list of its faces as seen from outside, sorted: what does not depend on the order of faces.
template<class M>
std::vector<std::vector<std::vector<std::size_t>>> polys_of(const M& m) {
  std::vector<std::vector<std::vector<std::size_t>>> all;
  for (const auto p : polys(m)) {
    all.emplace_back();
    for (const auto f : adj_p2f(m, p)) all.back().push_back(verts_of_face(m, p, f));
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

/// The labels of faces by their verts.
template<class M>
std::multimap<std::vector<std::size_t>, int> labels_of_faces(const M& m) {
  std::multimap<std::vector<std::size_t>, int> all;
  const auto label = find_face_property<int>(m, "label");
  for (const auto f : faces(m)) {
    std::vector<std::size_t> v;
    for (const auto x : adj_f2v(m, f)) v.push_back(index_of(m, x));
    std::sort(v.begin(), v.end());
    if (label && label[f] != 0) all.emplace(v, label[f]);
  }
  return all;
}

/// Checks the laws that OpenFOAM asks of a folder, on what it says.
void check_laws_of(const std::string& folder) {
  load_report r;
  const auto m = load_openfoam<polyhedralmesh>(folder, {.report = &r});
  CHECK(r.reoriented_polys == 0);
  std::array<std::uint32_t, 2> before{};
  bool is_boundary = false;
  int last_label = 0;
  const auto label = find_face_property<int>(m, "label");
  std::size_t wrong = 0;
  for (const face_id f : faces(m)) {
    std::vector<poly_id> around;
    for (const poly_id p : adj_f2p(m, f)) around.push_back(p);
    std::sort(around.begin(), around.end());
    REQUIRE((around.size() == 1 || around.size() == 2));
    wrong += !face_is_outward(m, around[0], f);  // the owner is the smaller number, and the normal points from it
    if (around.size() == 2) {
      wrong += is_boundary;  // inner faces come first
      wrong += label && label[f] != 0;
      const std::array<std::uint32_t, 2> now = {around[0].raw(), around[1].raw()};
      wrong += now < before;  // upper triangular order
      before = now;
    } else {
      is_boundary = true;
      wrong += !label || label[f] < last_label || label[f] == 0;  // patches are contiguous
      if (label) last_label = label[f];
    }
  }
  CHECK(wrong == 0);
}

/// Saves as text and as binary, reads back and saves again.
template<class M>
void check_round_trip(const M& m, const std::string& name) {
  CAPTURE(name);
  const temporary_folder dir;
  const auto expected = polys_of(m);
  const std::size_t defects = validate(m).defects.size();
  for (const bool binary : {false, true}) {
    const std::string first = dir / (binary ? "b/constant/polyMesh" : "a/polyMesh"), second = dir / "c/polyMesh";
    save(m, first, {.binary = binary});
    check_laws_of(first);
    const M back = load<M>(first);
    CHECK(num_verts(back) == num_verts(m));
    bool is_same = num_verts(back) == num_verts(m);
    for (const auto v : verts(m)) is_same = is_same && point(back, v) == point(m, v);
    CHECK(is_same);
    CHECK(polys_of(back) == expected);
    CHECK(validate(back).defects.size() == defects);
    save(back, second, {.binary = binary});
    for (const char* const file : {"points", "faces", "owner", "neighbour", "boundary"}) CHECK(read_file(second + "/" + file) == read_file(first + "/" + file));
    CHECK(fs::exists(second + "/cellZones") == fs::exists(first + "/cellZones"));
    std::visit([&](const auto& any) { CHECK(num_polys(any) == num_polys(m)); }, load_any(first));
  }
}

polyhedralmesh two_cells() {
  return load_text<polyhedralmesh>("5 7 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n3 2 3 5\n3 2 5 4\n3 3 4 5\n4 1 2 3 4\n4 -3 5 6 7\n", file_format::hedra);
}

const char* const all_files[] = {"points", "faces", "owner", "neighbour", "boundary"};

}  // namespace

TEST_CASE("openfoam: every volume of the corpus below 100,000 polys is saved and read back, as text and binary") {
  std::size_t n = 0;
  for (const char* const kind : {"tet", "hex", "polyhedral"}) {
    const auto folder = corpus(kind);
    if (folder.empty()) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string path = entry.path().generic_string();
      if (fs::file_size(path) > 2'000'000 && !long_run()) continue;
      any_mesh m;
      try {
        m = load_any(path);
      } catch (const unsupported&) {
        continue;
      }
      std::visit([&]<class M>(const M& mesh) {
        if constexpr (dimension_v<M> == 3) {  // volumes only
          if (num_polys(mesh) >= 100'000) return;
          bool is_held = true;
          for (const auto f : faces(mesh)) is_held = is_held && num_elements(adj_f2p(mesh, f)) <= 2;
          if (!is_held) return;
          check_round_trip(mesh, path);
          ++n;
        }
      }, m);
    }
  }
  CHECK(n >= 5);
}

TEST_CASE("openfoam: patches and zones keep their names, lines and order, and empty ones stay") {
  polyhedralmesh m = two_cells();
  auto label = face_property<int>(m, "label");
  label[face_id{0}] = 7, label[face_id{1}] = 7, label[face_id{3}] = 9, label[face_id{4}] = -2, label[face_id{5}] = 1;
  auto zone = poly_property<int>(m, "label");
  zone[poly_id{1}] = 4;
  *mesh_property<label_names>(m, "label_names") = {{{element_kind::face, 7, "in let", {"type  wall ; // c", "nFaces 12;", "inGroups 1(wall);"}},
                                                    {element_kind::face, 3, "empty one", {}},
                                                    {element_kind::face, 9, "in_let", {"no entry", "type patch; x;", "value 3;"}},
                                                    {element_kind::face, 7, "again", {}},
                                                    {element_kind::vert, 1, "corner", {}},
                                                    {element_kind::poly, 4, "3 (metal", {"type cellZone;"}},
                                                    {element_kind::poly, 5, "air", {}}}};
  const temporary_folder dir;
  save_report r;
  save(m, dir / "polyMesh", {.report = &r});
  check_laws_of(dir / "polyMesh");
  CHECK(r.lost == std::vector<std::string>{"the line 'no entry' of the patch in_let_2, which is no entry", "the line 'type patch; x;' of the patch in_let_2, which is no entry",
                                           "1 names of labels of neither faces nor polys"});
  CHECK(r.notes == std::vector<std::string>{"the patch \"in let\" is called in_let", "the patch \"empty one\" is called empty_one", "the patch \"in_let\" is called in_let_2",
                                            "1 boundary faces without a label are in the patch defaultFaces",
                                            "the zone \"3 (metal\" is called _3__metal",
                                            "labels of faces are numbered anew when the file is read: 7 as 1, 3 as 2, 9 as 3, -2 as 4, 1 as 5",
                                            "labels of polys are numbered anew when the file is read: 4 as 1, 5 as 2",
                                            "the order of the faces changed, to that of OpenFOAM"});
  const auto back = load<polyhedralmesh>(dir / "polyMesh/");
  const label_names expected{{{element_kind::face, 1, "in_let", {"type wall;", "inGroups 1(wall);"}},
                              {element_kind::face, 2, "empty_one", {"type patch;"}},
                              {element_kind::face, 3, "in_let_2", {"type patch;", "value 3;"}},
                              {element_kind::face, 4, "label_-2", {"type patch;"}},
                              {element_kind::face, 5, "label_1", {"type patch;"}},
                              {element_kind::face, 6, "defaultFaces", {"type patch;"}},
                              {element_kind::poly, 1, "_3__metal", {"type cellZone;"}},
                              {element_kind::poly, 2, "air", {"type cellZone;"}}}};
  CHECK(*find_mesh_property<label_names>(back, "label_names") == expected);
  CHECK(labels_of_faces(back) == std::multimap<std::vector<std::size_t>, int>{{{0, 1, 2}, 1}, {{0, 1, 3}, 1}, {{0, 2, 3}, 3}, {{1, 2, 4}, 4}, {{1, 3, 4}, 5}, {{2, 3, 4}, 6}});
  CHECK(find_poly_property<int>(back, "label")[poly_id{1}] == 1);
  CHECK(find_poly_property<int>(back, "label")[poly_id{0}] == 0);
  // the second save is the same, with nothing to report; so is the way through tets
  save(back, dir / "again/polyMesh", {.report = &r, .strict = true});
  CHECK(r.lost.empty());
  CHECK(r.notes.empty());
  for (const char* const file : {"points", "faces", "owner", "neighbour", "boundary", "cellZones"}) CHECK(read_file(dir / (std::string("again/polyMesh/") + file)) == read_file(dir / (std::string("polyMesh/") + file)));
  const auto tets = load<tetmesh>(dir / "polyMesh");
  CHECK(labels_of_faces(tets) == labels_of_faces(back));
  CHECK(load_any(dir / "polyMesh").index() == 3);
}

TEST_CASE("openfoam: faces that a polyMesh cannot hold are refused or reported") {
  const temporary_folder dir;
  const std::string three = "6 10 3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n1 1 1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n3 1 2 5\n3 2 3 5\n3 1 3 5\n3 1 2 6\n3 2 3 6\n3 1 3 6\n";
  const auto m = load_text<polyhedralmesh>(three + "4 1 2 3 4\n4 -1 5 6 -7\n4 -1 8 9 10\n", file_format::hedra);
  CHECK_THROWS_WITH_AS(save(m, dir / "polyMesh"), ((dir / "polyMesh") + ": polyMesh cannot hold face 0, which has three polys; save it as .hedra").c_str(), unsupported);
  CHECK(!fs::exists(dir / "polyMesh"));
}

TEST_CASE("openfoam: inner faces with labels and faces of no poly are lost") {
  polyhedralmesh m = two_cells();
  face_property<int>(m, "label")[face_id{2}] = 5;
  face_property<double>(m, "heat");
  save_report r;
  save_text(m, foam_text_format{}, {.report = &r});
  CHECK(r.lost == std::vector<std::string>{"labels of 1 faces between two polys, which belong to no patch", "face property \"heat\": .foam_text cannot store it"});
  const temporary_folder dir;
  CHECK_THROWS_AS(save(m, dir / "polyMesh", {.strict = true}), unsupported);
  CHECK(!fs::exists(dir / "polyMesh"));
  const auto alone = load_text<polyhedralmesh>("5 5 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n3 1 2 5\n4 1 2 3 4\n", file_format::hedra);
  save_text(alone, foam_text_format{}, {.report = &r});
  CHECK(r.lost == std::vector<std::string>{"1 faces of no poly"});
}

TEST_CASE("openfoam: the path is the polyMesh folder, any folder with its files, or a case") {
  const temporary_folder dir;
  const polyhedralmesh m = two_cells();
  fs::create_directories(dir / "case/constant");
  save_openfoam(m, dir / "case");
  CHECK(fs::exists(dir / "case/constant/polyMesh/owner"));
  for (const std::string path : {"case", "case/", "case/constant/polyMesh", "case/constant/polyMesh///"}) {
    CHECK(num_polys(load<polyhedralmesh>(dir / path)) == 2);
    CHECK(num_polys(load_openfoam<polyhedralmesh>(dir / path)) == 2);
    CHECK(load_any(dir / path, file_format::openfoam).index() == 3);
    CHECK(num_polys(load<polyhedralmesh>(dir / path, {.format = file_format::openfoam})) == 2);
  }
  save_openfoam(m, dir / "anything/new");
  CHECK(num_polys(load<polyhedralmesh>(dir / "anything/new")) == 2);
  save_openfoam(m, dir / "anything/new", {.binary = true});
  CHECK(read_file(dir / "anything/new/owner").find("binary") != std::string::npos);
  fs::create_directory(dir / "none");
  CHECK_THROWS_WITH_AS(load<polyhedralmesh>(dir / "none"), ((dir / "none") + ": cannot be read: Is a directory").c_str(), io_error);
  CHECK_THROWS_WITH_AS(load_openfoam<polyhedralmesh>(dir / "none"), ((dir / "none/points") + ": cannot be opened: No such file or directory").c_str(), io_error);
  CHECK_THROWS_WITH_AS(load<polyhedralmesh>(dir / "polyMesh"), ((dir / "polyMesh/points") + ": cannot be opened: No such file or directory").c_str(), io_error);
  CHECK_THROWS_WITH_AS(load_text<polyhedralmesh>("", file_format::openfoam), "text: a mesh in the format openfoam is a folder of files, no text; load it by its path", unsupported);
  CHECK_THROWS_WITH_AS(save_text(m, file_format::openfoam), "text: a mesh in the format openfoam is a folder of files, no text; save it to a path", unsupported);
  CHECK_THROWS_WITH_AS(save(trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), dir / "polyMesh"), doctest::Contains("polyMesh cannot hold surfaces; save it as"), unsupported);
  CHECK(!fs::exists(dir / "polyMesh"));
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "case"), doctest::Contains("holds a volume"), unsupported);
  write_file(dir / "file", "");
  CHECK_THROWS_WITH_AS(save(m, dir / "file/polyMesh"), ((dir / "file/polyMesh") + ": cannot be created: Not a directory").c_str(), io_error);
  CHECK_THROWS_WITH_AS(save_openfoam(m, dir / "file"), ((dir / "file") + ": cannot be written: Not a directory").c_str(), io_error);
  // compressed files
  fs::rename(dir / "case/constant/polyMesh/owner", dir / "case/constant/polyMesh/owner.gz");
  CHECK_THROWS_WITH_AS(load<polyhedralmesh>(dir / "case"), doctest::Contains("owner.gz: files compressed by gzip are not read; unpack them with gunzip"), unsupported);
}

TEST_CASE("openfoam: a mesh without cells, and one of a single cell") {
  const temporary_folder dir;
  for (const bool binary : {false, true}) {
    save(polyhedralmesh(), dir / "a/polyMesh", {.binary = binary});
    CHECK(num_polys(load<polyhedralmesh>(dir / "a/polyMesh")) == 0);
    CHECK(num_polys(load<hexmesh>(dir / "a/polyMesh")) == 0);
    const tetmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
    save(tet, dir / "b/polyMesh", {.binary = binary});
    CHECK(num_polys(load<tetmesh>(dir / "b/polyMesh")) == 1);
  }
}

TEST_CASE("openfoam: a save that fails or is stopped leaves the folder as it was; one that succeeds removes old zones") {
  const temporary_folder dir;
  polyhedralmesh m = two_cells();
  poly_property<int>(m, "label")[poly_id{1}] = 1;
  const std::string path = dir / "case/constant/polyMesh";
  const auto stopped = [](double fraction, const char*) { return fraction < 1; };
  CHECK_THROWS_AS(save(m, path, {.progress = stopped}), cancelled);
  CHECK(!fs::exists(dir / "case"));
  save(m, path);
  write_file(path + "/faceZones", "old");
  write_file(path + "/points.gz", "old");
  write_file(path + "/mine", "mine");
  const auto before = contents_of(path);
  CHECK(before.size() == 9);
  const tetmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(save(tet, path, {.progress = stopped}), cancelled);
  CHECK(contents_of(path) == before);
  // the last moment: a file becomes a folder, so that it cannot be replaced
  for (const char* const file : all_files) {
    const std::string blocked = path + "/" + file;
    const auto block = [&](double fraction, const char*) {
      if (fraction == 1) fs::rename(blocked, blocked + ".away"), fs::create_directory(blocked), write_file(blocked + "/x", "");
      return true;
    };
    CHECK_THROWS_AS(save(tet, path, {.progress = block}), io_error);
    fs::remove_all(blocked);
    fs::rename(blocked + ".away", blocked);
    CHECK(contents_of(path) == before);
  }
  save_report r;
  save(tet, path, {.report = &r, .sync = true});
  CHECK(std::find(r.notes.begin(), r.notes.end(), "faceZones, which belongs to the former mesh, is removed") != r.notes.end());
  CHECK(std::find(r.notes.begin(), r.notes.end(), "cellZones, which belongs to the former mesh, is removed") != r.notes.end());
  std::set<std::string> left;
  for (const auto& [name, text] : contents_of(path)) left.insert(fs::path(name).filename().string());
  CHECK(left == std::set<std::string>{"points", "faces", "owner", "neighbour", "boundary", "mine"});
  CHECK(num_polys(load<tetmesh>(path)) == 1);
}

TEST_CASE("openfoam: progress of reading does not decrease, and stops it") {
  const temporary_folder dir;
  save(two_cells(), dir / "polyMesh");
  double last = 0;
  std::size_t calls = 0;
  const auto watch = [&](double fraction, const char*) {
    CHECK(fraction >= last);
    last = fraction;
    return ++calls < 100000;
  };
  load<polyhedralmesh>(dir / "polyMesh", {.progress = watch});
  CHECK(last == 1);
  const auto stop = [](double fraction, const char*) { return fraction < 0.5; };
  CHECK_THROWS_AS(load<polyhedralmesh>(dir / "polyMesh", {.progress = stop}), cancelled);
}

TEST_CASE("openfoam: coupled patches keep the order of their faces in a polyhedralmesh; that of tets is reported") {
  polyhedralmesh m = two_cells();
  auto label = face_property<int>(m, "label");
  label[face_id{6}] = 1, label[face_id{0}] = 1, label[face_id{3}] = 1;
  *mesh_property<label_names>(m, "label_names") = {{{element_kind::face, 1, "left", {"type cyclic;", "neighbourPatch right;"}}}};
  const temporary_folder dir;
  save(m, dir / "polyMesh");
  const auto back = load<polyhedralmesh>(dir / "polyMesh");
  CHECK((*adj_f2v(back, face_id{1}).begin()).raw() == 0);  // face 0, of the file's first patch
  CHECK((*adj_f2p(back, face_id{3}).begin()).raw() == 1);  // face 6
  save_report r;
  save(load<tetmesh>(dir / "polyMesh"), dir / "b/polyMesh", {.report = &r});
  REQUIRE(r.lost.size() == 1);
  CHECK(r.lost[0].starts_with("the order of the faces of the patch left, which is coupled"));
}
