// If an allocation fails while a mesh is saved or read, files, links and libraries do not change, and nothing leaks.
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/io/field.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/failing_allocations.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <map>

namespace cn = concino;
using cn::testing::for_each_failing_allocation;

namespace {

using files = std::map<std::string, std::string>;

files files_in(const cn::testing::temporary_folder& dir) {
  files all;
  for (const auto& entry : std::filesystem::directory_iterator(dir.path()))
    all[entry.path().filename().string()] = cn::testing::read_file(entry.path().string());
  return all;
}

void put(const cn::testing::temporary_folder& dir, const files& wanted) {
  for (const auto& [name, text] : files_in(dir))
    if (!wanted.contains(name)) std::filesystem::remove(dir / name);
  for (const auto& [name, text] : wanted) cn::testing::write_file(dir / name, text);
}

const std::string scene =
    "mtllib wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood of an old oak\nf 1 2 3\nf 3 2 1\nusemtl color_1\nf 2 1 3\n";
const std::string wood =
    "# by hand\nnewmtl wood of an old oak\nKa 0.1 0.1 0.1\nKd 0.5 0.25 0\nKs 1 1 1\nmap_Kd a picture of planks.png\nnewmtl color_1\nKd 1 0 0\n";

/// Saves m with each of its allocations failing, and checks that no file changes or all do.
template<class M>
void changes_all_or_nothing(const cn::testing::temporary_folder& dir, const M& m, const std::string& name) {
  const files before = files_in(dir);
  cn::save(m, dir / name);
  const files after = files_in(dir);
  CHECK(after != before);
  put(dir, before);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    const bool failed = attempt([&] { cn::save(m, dir / name); });
    CHECK(files_in(dir) == (failed ? before : after));
    if (!failed) put(dir, before);
  });
  CHECK(result.allocations > 20);
  CHECK(result.failed > 20);
  CHECK(result.leaks == 0);
}

}  // namespace

TEST_CASE("saving with materials changes both files or none") {
  const cn::testing::temporary_folder dir;
  cn::testing::write_file(dir / "wood.mtl", wood);
  cn::testing::write_file(dir / "a.obj", scene);
  auto m = cn::load<cn::trimesh>(dir / "a.obj");
  const auto color = cn::poly_property<cn::rgba>(m, "color");
  color[cn::poly_id{1}] = {0, 1, 0, 0.5f};
  changes_all_or_nothing(dir, m, "a.obj");  // writes a new library
  cn::save(m, dir / "a.obj");
  color[cn::poly_id{1}] = {0, 0, 1};
  changes_all_or_nothing(dir, m, "a.obj");  // also removes an outdated library
  changes_all_or_nothing(dir, cn::load<cn::trimesh>(dir / "a.obj"), "a.obj");  // uses the existing libraries
}

TEST_CASE("loading with materials succeeds or throws std::bad_alloc") {
  const cn::testing::temporary_folder dir;
  cn::testing::write_file(dir / "wood.mtl", wood + "newmtl bad\nKd 1 x 1\nnewmtl bad\nKd 1 1 1\n");
  cn::testing::write_file(dir / "a.obj", "mtllib gone.mtl wood.mtl\n" + scene);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    std::size_t read = 0;
    if (!attempt([&] {
          cn::load_report report;
          const auto m = cn::load<cn::trimesh>(dir / "a.obj", {.report = &report});
          read = cn::find_mesh_property<cn::material_table>(m, "materials")->materials.size() + report.notes.size();
        }))
      CHECK(read == 5);
  });
  CHECK(result.failed > 20);
  CHECK(result.leaks == 0);
}

TEST_CASE("saving a field replaces the old file or keeps it") {
  const cn::testing::temporary_folder dir;
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto u = cn::make_vert_map<double>(m, 7);
  cn::testing::write_file(dir / "u.txt", "old");
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    const bool failed = attempt([&] { cn::save_field(u, m, dir / "u.txt"); });
    CHECK(cn::testing::read_file(dir / "u.txt") == (failed ? "old" : "SCALAR_FIELD 3\n7\n7\n7\n"));
    CHECK(dir.num_files() == 1);
    cn::testing::write_file(dir / "u.txt", "old");
  });
  CHECK(result.failed > 2);
  CHECK(result.leaks == 0);
}
