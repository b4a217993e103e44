// Saving over a file and loading into a mesh succeed or change nothing if any allocation fails, and nothing leaks.
#include <concino/io/load.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>

#include <support/failing_allocations.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace cn = concino;
using cn::testing::for_each_failing_allocation;
using cn::testing::read_file;
using cn::testing::whole;

namespace {

/// Checks that the file is the old one or the new one, and that no other file is left.
template<class M>
void saved_or_not(const M& m, const std::string& name, bool binary = false) {
  INFO(name);
  const cn::testing::temporary_folder dir;
  const std::string path = dir / name;
  cn::save(m, path, {.binary = binary});
  const std::string expected = read_file(path);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    cn::testing::write_file(path, "old");
    cn::save_report report;
    const bool failed = attempt([&] { cn::save(m, path, {.report = &report, .binary = binary}); });
    CHECK(read_file(path) == (failed ? "old" : expected));
    CHECK(dir.num_files() == 1);
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
}

/// Checks that a mesh into which a file is loaded is unchanged, or has the contents of the file.
template<class M>
void loaded_or_not(const M& m, const std::string& name) {
  INFO(name);
  const cn::testing::temporary_folder dir;
  const std::string path = dir / name;
  cn::save(m, path);
  const std::vector<double> old = whole(M()), expected = whole(cn::load<M>(path));
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M x;
    cn::load_report report;
    const bool failed = attempt([&] { x = cn::load<M>(path, {.report = &report}); });
    CHECK(whole(x) == (failed ? old : expected));
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
  const auto any = for_each_failing_allocation([&](const auto& attempt) { attempt([&] { cn::load_any(path); }); });
  CHECK(any.leaks == 0);
}

/// A mesh of one or few cells, with properties that the formats can store and others.
template<class M>
M labelled() {
  M m = cn::testing::grid<M>(1);
  const auto label = cn::poly_property<int>(m, "label");
  const auto height = cn::vert_property<double>(m, "height");
  for (const auto p : cn::polys(m)) label[p] = static_cast<int>(p.raw());
  for (const auto v : cn::verts(m)) height[v] = 0.25;
  return m;
}

/// The names and texts of the files of a folder, one after another; empty if there is none.
std::string folder_text(const std::string& path) {
  std::vector<std::string> files;
  if (std::filesystem::exists(path))
    for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path().filename().string() + ":" + read_file(entry.path().generic_string()));
  std::sort(files.begin(), files.end());
  std::string all;
  for (const std::string& file : files) all += file;
  return all;
}

/// The same as saved_or_not for a polyMesh, which is new or replaces another.
template<class M>
void folder_saved_or_not(const M& m, bool is_new, bool binary) {
  const cn::testing::temporary_folder dir;
  const std::string path = dir / "case/polyMesh";
  cn::save(m, path, {.binary = binary});
  const std::string expected = folder_text(path);
  cn::save(cn::tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), dir / "old/polyMesh");
  cn::testing::write_file(dir / "old/polyMesh/faceZones", "old");
  const std::string old = is_new ? "" : folder_text(dir / "old/polyMesh");
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    std::filesystem::remove_all(dir / "case");
    if (!is_new) std::filesystem::create_directory(dir / "case"), std::filesystem::copy(dir / "old/polyMesh", path);
    cn::save_report report;
    const bool failed = attempt([&] { cn::save(m, path, {.report = &report, .binary = binary}); });
    CHECK(folder_text(path) == (failed ? old : expected));
    if (is_new) CHECK(std::filesystem::exists(dir / "case") == !failed);
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
}

}  // namespace

TEST_CASE("saving a folder replaces all its files or none") {
  for (const bool is_new : {false, true})
    for (const bool binary : {false, true}) folder_saved_or_not(labelled<cn::hexmesh>(), is_new, binary);
}

TEST_CASE("saving replaces the file completely or not at all") {
  saved_or_not(labelled<cn::trimesh>(), "a.obj");
  saved_or_not(labelled<cn::trimesh>(), "a.off");
  saved_or_not(labelled<cn::polygonmesh>(), "a.off", true);
  saved_or_not(labelled<cn::polygonmesh>(), "a.obj");
  saved_or_not(labelled<cn::quadmesh>(), "a.mesh");
  saved_or_not(labelled<cn::tetmesh>(), "a.mesh");
  saved_or_not(labelled<cn::hexmesh>(), "a.mesh");
  saved_or_not(labelled<cn::hexmesh>(), "a.meshb");
  saved_or_not(labelled<cn::hexmesh>(), "a.tet");
  saved_or_not(labelled<cn::hexmesh>(), "a.hybrid");
  saved_or_not(labelled<cn::hexmesh>(), "a.hedra");
  saved_or_not(labelled<cn::polyhedralmesh>(), "a.hedra");
  saved_or_not(labelled<cn::polygonmesh>(), "a.smesh");
}

TEST_CASE("saving .ele and the files beside it replaces all of them or none") {
  const cn::testing::temporary_folder dir;
  auto m = labelled<cn::tetmesh>();
  for (const auto f : cn::faces(m)) cn::face_property<int>(m, "label")[f] = 1;
  cn::save(m, dir / "a.ele");
  const std::vector<std::string> names = {"a.ele", "a.node", "a.face"};
  std::vector<std::string> expected;
  for (const std::string& name : names) expected.push_back(read_file(dir / name));
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    for (const std::string& name : names) cn::testing::write_file(dir / name, "old");
    const bool failed = attempt([&] { cn::save(m, dir / "a.ele"); });
    for (std::size_t i = 0; i < names.size(); ++i) CHECK(read_file(dir / names[i]) == (failed ? "old" : expected[i]));
    CHECK(dir.num_files() == 3);
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
}

TEST_CASE("loading into a mesh succeeds or changes nothing") {
  loaded_or_not(labelled<cn::trimesh>(), "a.obj");
  loaded_or_not(labelled<cn::polygonmesh>(), "a.off");
  loaded_or_not(labelled<cn::quadmesh>(), "a.mesh");
  loaded_or_not(labelled<cn::tetmesh>(), "a.mesh");
  loaded_or_not(labelled<cn::tetmesh>(), "a.meshb");
  loaded_or_not(labelled<cn::tetmesh>(), "a.tet");
  loaded_or_not(labelled<cn::tetmesh>(), "a.ele");
  loaded_or_not(labelled<cn::trimesh>(), "a.poly");
  loaded_or_not(labelled<cn::hexmesh>(), "a.hybrid");
  loaded_or_not(labelled<cn::hexmesh>(), "a.hedra");
  loaded_or_not(labelled<cn::polyhedralmesh>(), "a.hedra");
  loaded_or_not(labelled<cn::polyhedralmesh>(), "polyMesh");
  loaded_or_not(labelled<cn::hexmesh>(), "polyMesh");
}
