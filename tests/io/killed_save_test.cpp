// Saves that are killed at each call that changes a folder, and the order in which files reach the disk.
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/io/field.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/materials.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <functional>

using namespace concino;
using namespace concino::testing;

namespace {

int calls_left = -1;  // the process ends before this call, counted from 0; negative: it does not end
std::vector<std::string>* synced = nullptr;
std::string watched;  // the path of a file

void before_a_change() {
  if (calls_left >= 0 && calls_left-- == 0) ::_exit(77);
}

}  // namespace

// The program calls these functions instead of those of the system's library.
extern "C" {
int linkat(int from, const char* old, int to, const char* name, int flags) noexcept {
  before_a_change();
  return static_cast<int>(::syscall(SYS_linkat, from, old, to, name, flags));
}
int renameat(int from, const char* old, int to, const char* name) noexcept {
  before_a_change();
  return static_cast<int>(::syscall(SYS_renameat2, from, old, to, name, 0));
}
int unlinkat(int folder, const char* name, int flags) noexcept {
  before_a_change();
  return static_cast<int>(::syscall(SYS_unlinkat, folder, name, flags));
}
int unlink(const char* name) noexcept {
  before_a_change();
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, name, 0));
}
int fsync(int file) {
  if (synced) {
    struct ::stat info {};
    ::fstat(file, &info);
    synced->push_back((S_ISDIR(info.st_mode) ? "folder, " : "file, ") + std::string(std::filesystem::exists(watched) ? read_file(watched) : "none").substr(0, 12));
  }
  return static_cast<int>(::syscall(SYS_fsync, file));
}
}

namespace {

const std::string scene = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl oak\nf 1 2 3\nusemtl color_1\nf 3 2 1\n";

/// Saves m in processes that end before the first, second, ... change of the folder, and checks the files. Returns the number of changes.
int number_of_steps(const std::function<void(const temporary_folder&)>& prepare, const std::function<trimesh(const temporary_folder&)>& make) {
  for (int steps = 0;; ++steps) {
    const temporary_folder dir;
    prepare(dir);
    const std::string path = dir / "a.obj";
    const trimesh m = make(dir);
    const said_materials old = said_in(path), fresh = said_of(m);
    const ::pid_t child = ::fork();
    if (child == 0) {
      calls_left = steps;
      save(m, path);
      ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    const said_materials now = said_in(path);
    if (WEXITSTATUS(status) == 0) {
      CHECK(now == fresh);
      return steps;
    }
    REQUIRE(WEXITSTATUS(status) == 77);
    const bool is_one = now == old || now == fresh;
    CHECK(is_one);
    if (steps == 0) CHECK(now == old);
    // later saves work, and remove all files of this one
    const std::size_t others = std::filesystem::exists(dir / "oak.mtl") ? 1 : 0;
    for (const float r : {0.125f, 0.0625f}) {
      save(colored(r), path);
      CHECK(said_in(path) == said_of(colored(r)));
    }
    std::string left;
    for (const auto& entry : std::filesystem::directory_iterator(dir.path())) left += entry.path().filename().string() + " ";
    INFO(left);
    CHECK(dir.num_files() == 2 + others);
  }
}

}  // namespace

TEST_CASE("killed_save: at every step the files on disk are both old or both new") {
  const auto nothing = [](const temporary_folder&) {};
  const auto earlier = [](const temporary_folder& dir) { save(colored(0.5f), dir / "a.obj"); };
  const auto from_elsewhere = [](const temporary_folder& dir) {
    write_file(dir / "oak.mtl", "newmtl oak\nKa 1 1 1\nKd 0.5 0 0\nillum 2\nnewmtl color_1\nKd 0 1 0\n");
    write_file(dir / "a.obj", "mtllib oak.mtl\n" + scene);
  };
  const auto names_missing = [](const temporary_folder& dir) { write_file(dir / "a.obj", "mtllib a.mtl a_1.mtl\n" + scene); };
  const auto other = [](const temporary_folder&) { return colored(0.25f); };
  const auto loaded = [](const temporary_folder& dir) { return load<trimesh>(dir / "a.obj"); };
  const auto changed = [](const temporary_folder& dir) {
    trimesh m = load<trimesh>(dir / "a.obj");
    poly_property<rgba>(m, "color")[poly_id{1}] = {0, 0, 1};
    return m;
  };
  CHECK(number_of_steps(nothing, other) == 2);           // the new library, the mesh
  CHECK(number_of_steps(earlier, other) == 5);           // the library, three for the mesh, removing the outdated library
  CHECK(number_of_steps(earlier, loaded) == 3);          // the mesh: a link to a name in use, a link to another name, a rename
  CHECK(number_of_steps(from_elsewhere, other) == 4);    // the library, the mesh
  CHECK(number_of_steps(from_elsewhere, loaded) == 3);   // the mesh
  CHECK(number_of_steps(from_elsewhere, changed) == 4);  // the library, the mesh
  CHECK(number_of_steps(names_missing, other) == 4);
}

TEST_CASE("killed_save: a folder is the old or the new one, or a mixture; the next save works and leaves nothing behind") {
  const tetmesh one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}});
  for (int steps = 0, code = 77; code == 77; ++steps) {
    const temporary_folder dir;
    save(one, dir / "polyMesh");
    write_file(dir / "polyMesh/faceZones", "old");
    const ::pid_t child = ::fork();
    if (child == 0) {
      calls_left = steps;
      save(two, dir / "polyMesh");
      ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    code = WEXITSTATUS(status);
    try {
      const std::size_t n = num_polys(load<tetmesh>(dir / "polyMesh"));
      CHECK((n == 1 || n == 2));
      if (steps == 0) CHECK(n == 1);
      if (code == 0) CHECK(n == 2);
    } catch (const parse_error&) {
      CHECK(code == 77);
    }
    save(two, dir / "polyMesh");
    CHECK(num_polys(load<tetmesh>(dir / "polyMesh")) == 2);
    std::size_t n = 0;
    for (const auto& entry : std::filesystem::directory_iterator(dir / "polyMesh")) n += entry.is_regular_file();
    CHECK(n == 5);
  }
}

TEST_CASE("killed_save: with sync the data reaches the disk before the file is replaced, then the folder") {
  const temporary_folder dir;
  const auto order = [&](const std::string& file, const auto& write) {
    std::vector<std::string> all;
    watched = dir / file;
    synced = &all;
    write();
    synced = nullptr;
    return all;
  };
  using list = std::vector<std::string>;
  write_file(dir / "a.obj", "old");
  CHECK(order("a.obj", [&] { save(colored(1), dir / "a.obj", {.sync = true}); }) ==
        list{"file, old", "file, old", "folder, old", "folder, # 4 verts, 2"});
  CHECK(order("b.obj", [&] { save(colored(1), dir / "b.off", {.sync = true}); }) == list{"file, none", "folder, none"});
  CHECK(order("a.obj", [&] { save(colored(0.5f), dir / "a.obj"); }).empty());
  const trimesh m = colored(1);
  const auto u = make_vert_map<double>(m);
  CHECK(order("u.txt", [&] { save_field(u, m, dir / "u.txt", {.sync = true}); }) == list{"file, none", "folder, SCALAR_FIELD"});
  CHECK(order("u.txt", [&] { save_field(u, m, dir / "u.txt"); }).empty());
}
