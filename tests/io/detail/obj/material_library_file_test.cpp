#include <concino/io/detail/obj/material_library_file.hpp>

#include <concino/convert.hpp>
#include <concino/edit.hpp>
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/materials.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <ctime>
#include <functional>
#include <map>
#include <random>

using namespace concino;
using namespace concino::testing;
namespace fs = std::filesystem;

namespace {

using list = std::vector<std::string>;

const std::string geometry = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string wood =
    "# Exported from elsewhere\n\nnewmtl wood\n  Ka 0.1 0.1 0.1\n  Kd 0.5 0.25 0\n  Ks 0.5 0.5 0.5\n  Ke 0 0 0\n  Tr 0.25\n  d 0.75\n  illum 2\n  Ns 96.078431\n"
    "  Ni 1.45\n  map_Kd -s 2 2 1 planks of oak.png\n  Pr 0.3\n  # by hand\n  my_program a  b\n\nnewmtl unused\nKd 0.125 0 0\nillum 0\n";
const std::string glass = "newmtl glass\nKd 0 0 1\nd 0.5\nNi 1.5\n";
const std::string uses = geometry + "usemtl wood\nf 1 2 3\nusemtl glass\nf 2 4 3\n";

list files_in(const temporary_folder& dir) {
  list all;
  for (const auto& entry : fs::directory_iterator(dir.path())) all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}
std::map<std::string, std::string> contents_of(const temporary_folder& dir) {
  std::map<std::string, std::string> all;
  for (const std::string& name : files_in(dir)) all[name] = fs::is_regular_file(dir / name) ? read_file(dir / name) : "";
  return all;
}

/// Writes a surface and the libraries wood.mtl and glass.mtl that it names. It names a third one, which does not exist.
void write_scene(const temporary_folder& dir, const std::string& name) {
  write_file(dir / "wood.mtl", wood);
  write_file(dir / "glass.mtl", glass);
  write_file(dir / name, "mtllib wood.mtl glass.mtl\nmtllib gone.mtl\n" + uses);
}

}  // namespace

TEST_CASE("library_file: saving a mesh over its own file changes no library") {
  const temporary_folder dir;
  write_scene(dir, "a.obj");
  const auto m = load<trimesh>(dir / "a.obj");
  const auto before = contents_of(dir);
  save_report r;
  save(m, dir / "a.obj", {.report = &r});
  CHECK(r.lost.empty());
  CHECK(r.notes.empty());
  auto after = contents_of(dir);
  CHECK(after["a.obj"].find("mtllib wood.mtl\nmtllib glass.mtl\nmtllib gone.mtl\n") != std::string::npos);
  after["a.obj"] = before.at("a.obj");
  CHECK(before == after);
  CHECK(said_in(dir / "a.obj") == said_of(m));
  CHECK(said_of(m).materials.size() == 3);
  CHECK(said_of(m).materials[2].lines.size() == 13);
}

TEST_CASE("library_file: saving to another folder merges all libraries into one, with all lines") {
  const temporary_folder dir, other;
  write_scene(dir, "a.obj");
  const auto m = load<trimesh>(dir / "a.obj");
  save_report r;
  save(m, other / "b.obj", {.report = &r});
  CHECK(r.lost.empty());
  CHECK(r.notes == list{"the textures of materials (map_Kd and the like) are not copied"});
  CHECK(files_in(other) == list{"b.mtl", "b.obj"});
  CHECK(said_in(other / "b.obj") == said_of(m));
  CHECK(read_file(other / "b.obj").find("mtllib b.mtl\nmtllib gone.mtl\n") != std::string::npos);
  CHECK(find_mesh_property<material_table>(load<trimesh>(other / "b.obj"), "materials")->head == list{"# Exported from elsewhere"});
  for (const char* const line : {"Ka 0.1 0.1 0.1", "Ke 0 0 0", "Tr 0.25", "my_program a  b", "# by hand", "newmtl unused"})
    CHECK(read_file(other / "b.mtl").find(std::string("\n") + line + "\n") != std::string::npos);

  // materials are the same after edits, copies and conversions
  auto edited = load<trimesh>(other / "b.obj");
  remove_poly(edited, poly_id{1});
  add_poly(edited, {vert_id{1}, vert_id{2}, vert_id{3}});
  const auto polygons = convert<polygonmesh>(edited);
  save(polygons, other / "c.obj", {.report = &r});
  CHECK(r.lost.empty());
  CHECK(said_in(other / "c.obj").materials == said_of(m).materials);
  CHECK(said_in(other / "c.obj").names == list{"wood", ""});
}

TEST_CASE("library_file: libraries of other files are not changed, and the report names the new library") {
  const temporary_folder dir;
  write_file(dir / "a.mtl", wood);
  save_report r;
  save(colored(0.5f), dir / "a.obj", {.report = &r});
  CHECK(r.notes == list{"the materials are in a_1.mtl: a.mtl holds other materials and is unchanged"});
  CHECK(read_file(dir / "a.mtl") == wood);
  CHECK(said_in(dir / "a.obj") == said_of(colored(0.5f)));
  // a library that has exactly the needed materials is named and not written
  write_file(dir / "b.mtl", "newmtl color_2\nKd 0 0.5 0\n# more\nnewmtl color_3\nKd 0 0.25 0\nnewmtl color_1\nKd 0.5 0 0\n");
  save(colored(0.5f), dir / "b.obj", {.report = &r});
  CHECK(r.notes == list{"the materials are in b_1.mtl: b.mtl holds other materials and is unchanged"});  // it has a comment more
  write_file(dir / "c.mtl", "newmtl color_2\nKd 0 0.5 0\nnewmtl color_3\nKd 0 0.25 0\nnewmtl color_1\nKd 0.5 0 0\n");
  const auto before = contents_of(dir);
  save(colored(0.5f), dir / "c.obj", {.report = &r});
  CHECK(r.notes.empty());
  auto after = contents_of(dir);
  CHECK(after.erase("c.obj") == 1);
  CHECK(before == after);
  CHECK(said_in(dir / "c.obj").colors == said_of(colored(0.5f)).colors);
}

TEST_CASE("library_file: saving removes the previous library of the file, unless it was changed since") {
  const temporary_folder dir;
  save_report r;
  for (int i = 1; i <= 5; ++i) {
    const trimesh m = colored(static_cast<float>(i) / 8);
    save(m, dir / "a.obj", {.report = &r});
    CHECK(files_in(dir) == (i % 2 ? list{"a.mtl", "a.obj"} : list{"a.obj", "a_1.mtl"}));
    CHECK(r.notes.size() == (i > 1 ? 1 : 0));
    CHECK(said_in(dir / "a.obj") == said_of(m));
    const auto before = contents_of(dir);
    save(m, dir / "a.obj", {.report = &r});
    CHECK(before == contents_of(dir));
    CHECK(r.notes.empty());
  }
  CHECK(files_in(dir) == list{"a.mtl", "a.obj"});
  write_file(dir / "a.mtl", read_file(dir / "a.mtl") + "Ks 1 1 1\n");
  save(colored(1), dir / "a.obj", {.report = &r});
  CHECK(r.notes == list{"the materials are in a_1.mtl: a.mtl holds other materials and is unchanged"});
  CHECK(files_in(dir) == list{"a.mtl", "a.obj", "a_1.mtl"});
  save(colored(0.5f), dir / "a.obj");
  CHECK(files_in(dir) == list{"a.mtl", "a.obj", "a_2.mtl"});
  save(colored(0.25f), dir / "a.obj");
  CHECK(files_in(dir) == list{"a.mtl", "a.obj", "a_1.mtl"});
  // a library that was written for another file is kept
  fs::rename(dir / "a_1.mtl", dir / "b.mtl");
  save(colored(0.5f), dir / "b.obj");
  CHECK(fs::exists(dir / "b.mtl"));
  CHECK(fs::exists(dir / "b_1.mtl"));
}

TEST_CASE("library_file: saving changes both files or neither, whatever fails") {
  const temporary_folder dir;
  save(colored(0.5f), dir / "a.obj");
  const auto before = contents_of(dir);
  const auto stop_at_the_end = [](double f, const char*) { return f < 1; };
  CHECK_THROWS_AS(save(colored(1), dir / "a.obj", {.progress = stop_at_the_end}), cancelled);
  CHECK(before == contents_of(dir));

  // another program creates the library at the same time
  const auto make_library = [&](double f, const char*) {
    if (f == 1) write_file(dir / "a_1.mtl", "mine");
    return true;
  };
  CHECK_THROWS_WITH_AS(save(colored(1), dir / "a.obj", {.progress = make_library}), ((dir / "a_1.mtl") + ": cannot be created: File exists").c_str(), io_error);
  CHECK(read_file(dir / "a_1.mtl") == "mine");
  fs::remove(dir / "a_1.mtl");
  CHECK(before == contents_of(dir));

  // the library gets its new name, but renaming the mesh fails
  const auto make_folder = [&](double f, const char*) {
    if (f == 1) {
      fs::remove(dir / "a.obj");
      fs::create_directory(dir / "a.obj");
    }
    return true;
  };
  CHECK_THROWS_AS(save(colored(1), dir / "a.obj", {.progress = make_folder}), io_error);
  CHECK(files_in(dir) == list{"a.mtl", "a.obj"});
  fs::remove(dir / "a.obj");
  write_file(dir / "a.obj", before.at("a.obj"));
  CHECK(before == contents_of(dir));

  // the disk is full while the library, or the mesh, is written
  trimesh large = colored(1);
  for (int i = 0; i < 2000; ++i) mesh_property<material_table>(large, "materials")->materials.push_back({"m" + std::to_string(i), {"Kd 1 0 0"}});
  struct ::rlimit was {};
  ::getrlimit(RLIMIT_FSIZE, &was);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t size : {rlim_t{16}, rlim_t{8192}}) {
    const struct ::rlimit little { size, was.rlim_max };
    ::setrlimit(RLIMIT_FSIZE, &little);
    CHECK_THROWS_AS(save(large, dir / "a.obj"), io_error);
    CHECK_THROWS_AS(save(colored(1), dir / (std::string(240, 'n') + ".obj"), {.progress = [](double f, const char*) { return f < 1; }}), error);
    ::setrlimit(RLIMIT_FSIZE, &was);
    CHECK(before == contents_of(dir));
  }
  std::signal(SIGXFSZ, handler);
}

TEST_CASE("library_file: at every step of saving the .obj file finds its own materials") {
  // every state of a save: the new library is there, then the new mesh, then the outdated library is removed
  const auto steps = [](const std::function<void(const temporary_folder&)>& prepare, const trimesh& m) {
    const temporary_folder dir;
    prepare(dir);
    const auto before = contents_of(dir);
    const said_materials old = said_in(dir / "a.obj");
    save(m, dir / "a.obj");
    const auto after = contents_of(dir);
    CHECK(said_in(dir / "a.obj") == said_of(m));
    for (const auto& [name, text] : before) write_file(dir / name, text);  // the new library is there, and nothing else has changed
    for (const auto& [name, text] : before)
      if (after.contains(name) && name != "a.obj") CHECK(after.at(name) == text);
    CHECK(said_in(dir / "a.obj") == old);
    write_file(dir / "a.obj", after.at("a.obj"));
    CHECK(said_in(dir / "a.obj") == said_of(m));
    save(m, dir / "a.obj");
    CHECK(said_in(dir / "a.obj") == said_of(m));
  };
  steps([](const auto& dir) { save(colored(0.5f), dir / "a.obj"); }, colored(0.25f));
  steps([](const auto& dir) { write_scene(dir, "a.obj"); }, colored(0.25f));
  steps(
      [](const auto& dir) {
        write_file(dir / "a.mtl", wood);
        write_file(dir / "a.obj", "mtllib a.mtl\n" + uses);
      },
      colored(0.25f));
  // the old file names a library that does not exist
  steps([](const auto& dir) { write_file(dir / "a.obj", "mtllib ./a.mtl\n" + geometry + "usemtl color_1\nf 1 2 3\n"); }, colored(0.25f));
  trimesh recolored = [] {
    const temporary_folder dir;
    write_scene(dir, "a.obj");
    return load<trimesh>(dir / "a.obj");
  }();
  poly_property<rgba>(recolored, "color")[poly_id{0}] = {0, 1, 0, 0.75f};
  const temporary_folder dir;
  write_scene(dir, "a.obj");
  save(recolored, dir / "a.obj");
  CHECK(said_in(dir / "a.obj").colors == said_of(recolored).colors);
  CHECK(read_file(dir / "wood.mtl") == wood);
}

TEST_CASE("library_file: after a killed save both files on disk are of the same save") {
  const temporary_folder dir;
  const trimesh a = colored(0.5f), b = colored(0.25f);
  save(a, dir / "a.obj");
  std::size_t wrong = 0, num_a = 0;
  for (int round = 0; round < 60; ++round) {
    const ::pid_t child = ::fork();
    if (child == 0) {
      for (int i = 0;; ++i) save(i % 2 ? a : b, dir / "a.obj");
    }
    const ::timespec some{0, 300000 + 61000 * round};
    ::nanosleep(&some, nullptr);
    ::kill(child, SIGKILL);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    const said_materials now = said_in(dir / "a.obj");
    wrong += now != said_of(a) && now != said_of(b);
    num_a += now == said_of(a);
    wrong += dir.num_files() > 4;  // the mesh, its library, an outdated or new one, and one between being linked and being renamed
  }
  CHECK(wrong == 0);
  CHECK(num_a > 0);
  save(a, dir / "a.obj");
  save(b, dir / "a.obj");
  CHECK(dir.num_files() == 2);
}

TEST_CASE("library_file: names of libraries are no longer than the system allows") {
  const temporary_folder dir;
  const std::string umlauts = [] {
    std::string s = "x";
    while (s.size() < 251) s += "\xC3\xA4";
    return s;
  }();
  for (const std::string& stem : {std::string(251, 'n'), umlauts}) {
    const std::string path = dir / (stem + ".obj");
    for (const float r : {0.5f, 0.25f, 0.125f}) {
      save(colored(r), path);
      CHECK(said_in(path) == said_of(colored(r)));
    }
  }
  CHECK(dir.num_files() == 4);
  CHECK(fs::exists(dir / (umlauts + ".mtl")));
  save(colored(1), dir / (umlauts + ".obj"));
  CHECK(fs::exists(dir / (umlauts.substr(0, 249) + "_1.mtl")));
  save(colored(1), dir / "no_extension", {.format = file_format::obj});
  CHECK(fs::exists(dir / "no_extension.mtl"));
  save(colored(0.5f), dir / "mesh.mtl", {.format = file_format::obj});
  CHECK(said_of(load<trimesh>(dir / "mesh.mtl", {.format = file_format::obj})) == said_of(colored(0.5f)));
  CHECK(fs::exists(dir / "mesh_1.mtl"));
  save(colored(1), dir / "a #1 \\ b.obj");
  CHECK(said_of(load<trimesh>(dir / "a #1 \\ b.obj")) == said_of(colored(1)));
}

TEST_CASE("library_file: follows symbolic links, with and without sync") {
  const temporary_folder other;
  fs::create_directory(other / "real");
  fs::create_symlink("real/mesh.obj", other / "link.obj");
  save(colored(0.5f), other / "link.obj");
  CHECK(fs::is_symlink(other / "link.obj"));
  CHECK(fs::exists(other / "real/mesh.mtl"));
  CHECK(said_in(other / "link.obj") == said_of(colored(0.5f)));
  CHECK(said_in(other / "real/mesh.obj") == said_of(colored(0.5f)));
  write_file(other / "mesh.mtl", "newmtl color_1\nKd 1 1 0\n");  // beside the link, where it is looked for first
  CHECK(said_in(other / "link.obj").colors[0] == rgba{1, 1, 0});
  CHECK(said_in(other / "real/mesh.obj") == said_of(colored(0.5f)));

  const temporary_folder dir;
  fs::create_symlink("b.mtl", dir / "a.mtl");
  save(colored(1), dir / "a.obj", {.sync = true});
  CHECK(fs::is_symlink(dir / "a.mtl"));
  CHECK(fs::is_regular_file(fs::symlink_status(dir / "b.mtl")));
  CHECK(said_in(dir / "a.obj") == said_of(colored(1)));
  save(colored(0.5f), dir / "a.obj", {.sync = true});
  CHECK(fs::is_symlink(dir / "a.mtl"));
  CHECK(files_in(dir) == list{"a.mtl", "a.obj", "a_1.mtl", "b.mtl"});
}

TEST_CASE("library_line: replaces line breaks, and leaves out empty lines and newmtl") {
  using concino::detail::library_line;
  CHECK(library_line(" \tKd 1\n0\r0 # c \v") == "Kd 1 0 0 # c");
  CHECK(library_line("a\x01\\") == "a\x01\\");
  CHECK(library_line("newmtls x") == "newmtls x");
  for (const char* const none : {"", " \n ", "newmtl", " newmtl x", "newmtl\tx"}) CHECK(library_line(none).empty());
}

TEST_CASE("library_lines: finds all mtllib lines, reading in pieces of any size") {
  using concino::detail::library_lines;
  const temporary_folder dir;
  write_file(dir / "a.obj", "mtllib one.mtl\r\nv 0 0 0\n mtllib\ttwo words.mtl three.mtl\rusemtl mtl\nmtllib\n# " + std::string(100, 'c') + "\nmtllib last.mtl");
  const list expected = {" one.mtl", "\ttwo words.mtl three.mtl", "", " last.mtl"};
  for (std::size_t piece = 1; piece < 200; ++piece) CHECK(library_lines(dir / "a.obj", piece) == expected);
  CHECK(library_lines(dir / "a.obj") == expected);
  CHECK(library_lines(dir / "none.obj").empty());
  write_file(dir / "empty.obj", "");
  CHECK(library_lines(dir / "empty.obj").empty());
  CHECK_THROWS_AS(library_lines(dir.path()), io_error);
}

TEST_CASE("library_file: throws if 1,000 other libraries have the name") {
  const temporary_folder dir;
  for (int i = 0; i < 1000; ++i) write_file(dir / (i ? "a_" + std::to_string(i) + ".mtl" : "a.mtl"), "newmtl color_1\n");
  CHECK_THROWS_WITH_AS(save(colored(1), dir / "a.obj"), ((dir / "a.obj") + ": 1000 material libraries of this name exist and hold other materials; remove them or save under another name").c_str(), io_error);
  CHECK(dir.num_files() == 1000);
}

TEST_CASE("library_file: randomly changed libraries have the same materials after saving elsewhere") {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return n ? static_cast<std::size_t>(random()) % n : 0; };
  const temporary_folder dir, other;
  const std::string likely("0123456789.-e# \n\r\t\\\0\x01Kdnewmtl", 29);
  std::size_t wrong = 0, compared = 0;
  for (int round = 0; round < 200; ++round) {
    std::string text = wood + glass;
    for (std::size_t k = below(8); k > 0; --k) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0: text[at] = likely[below(likely.size())]; break;
        case 1: text.erase(at, below(20)); break;
        case 2: text.insert(at, text.substr(below(text.size()), below(40))); break;
        default: text.insert(at, 1, likely[below(likely.size())]);
      }
    }
    write_file(dir / "a.mtl", text);
    write_file(dir / "a.obj", "mtllib a.mtl\n" + uses);
    const auto m = load<trimesh>(dir / "a.obj");
    save_report r;
    save(m, other / "b.obj", {.report = &r});
    if (!r.lost.empty()) continue;  // a name cannot be written on one line
    ++compared;
    if (said_in(other / "b.obj") != said_of(m)) {
      ++wrong;
      FAIL_CHECK(text);
    }
    save(m, dir / "a.obj");
    wrong += read_file(dir / "a.mtl") != text;
    wrong += said_in(dir / "a.obj") != said_of(m);
    for (const std::string& name : files_in(dir))
      if (name.starts_with("a_")) fs::remove(dir / name);
  }
  CHECK(wrong == 0);
  CHECK(compared > 100);
  CHECK(other.num_files() == 2);
}
