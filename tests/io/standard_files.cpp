// Files by the standard library alone, as where the system is not POSIX. This program is built without the macro by which POSIX systems are known, so that
// it tests the plain version here too; and as it is on Windows.
#include <concino/io/atomic_file.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/obj.hpp>
#include <concino/io/openfoam.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/mesh.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <type_traits>

#include <support/temporary.hpp>

using namespace concino;

static_assert(std::is_same_v<concino::detail::file_handle, std::FILE*>);

namespace {

void write(const atomic_file& file, const std::string& path, const std::string& text) {
  text_sink out(file.descriptor(), path);
  out << text;
  out.flush();
}

void replace(const std::string& path, const std::string& text, const atomic_file_options& options = {}) {
  atomic_file file(path, options);
  write(file, path, text);
  file.commit();
}

}  // namespace

TEST_CASE("standard files: are read, mapping or not") {
  const testing::temporary_folder dir;
  std::string large(3'000'000, '\0');
  for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<char>(i * 2'654'435'761u >> 13);  // among others the end of a text in Windows
  testing::write_file(dir / "large", large);
  testing::write_file(dir / "empty", "");
  for (const bool map : {false, true}) {
    file_text text(dir / "large", {.map = map});
    CHECK((text.text() == large));
    text.close("large");
    CHECK(text.text().empty());
    CHECK(file_text(dir / "empty", {.map = map}).text().empty());
  }
  CHECK_THROWS_WITH_AS(file_text(dir / "none"), ((dir / "none") + ": cannot be opened: No such file or directory").c_str(), io_error);
  CHECK_THROWS_WITH_AS(file_text(dir.path()), (dir.path() + ": cannot be opened: Is a directory").c_str(), io_error);
  CHECK_THROWS_AS(file_text(""), io_error);
}

TEST_CASE("standard files: only commit replaces the target, and nothing is left behind") {
  const testing::temporary_folder dir;
  for (const char* name : {"f", "\xc3\xa4 \xe4\xb8\xad"}) {  // the second one is not ASCII
    const std::string path = dir / name;
    replace(path, "old");
    CHECK(file_text(path).text() == "old");
    {
      atomic_file file(path);
      write(file, path, "new");
      file.finish();
      CHECK(file_text(path).text() == "old");
    }
    CHECK(file_text(path).text() == "old");
    {
      atomic_file a(path), b(path);
      write(a, path, "a");
      write(b, path, "b");
      b.commit();
      CHECK(b.is_committed());
      a.commit();
    }
    CHECK(file_text(path).text() == "a");
  }
  CHECK(dir.num_files() == 2);
}

TEST_CASE("standard files: with keep_old, undo puts the old file back") {
  const testing::temporary_folder dir;
  replace(dir / "f", "old");
  {
    atomic_file file(dir / "f", {.keep_old = true}), other(dir / "new", {.keep_old = true});
    write(file, dir / "f", "new");
    file.commit();
    other.commit();
    CHECK(file_text(dir / "f").text() == "new");
    file.undo();
    other.undo();
    CHECK(file_text(dir / "f").text() == "old");
  }
  replace(dir / "f", "newer", {.keep_old = true});
  CHECK(file_text(dir / "f").text() == "newer");
  CHECK(dir.num_files() == 1);
}

TEST_CASE("standard files: with keep_old, a folder that takes the place of the target stays") {
  const testing::temporary_folder dir;
  {
    atomic_file file(dir / "f", {.keep_old = true});
    std::filesystem::create_directory(dir / "f");
    CHECK_THROWS_AS(file.commit(), io_error);
  }
  CHECK(std::filesystem::is_directory(dir / "f"));
  CHECK(dir.num_files() == 1);
}

TEST_CASE("standard files: with must_be_new no file is replaced, and undo removes") {
  const testing::temporary_folder dir;
  {
    atomic_file late(dir / "f", {.must_be_new = true});
    write(late, dir / "f", "late");
    replace(dir / "f", "early", {.must_be_new = true});
    CHECK_THROWS_WITH_AS(late.commit(), ((dir / "f") + ": cannot be created: File exists").c_str(), io_error);
    CHECK_FALSE(late.is_committed());
  }
  CHECK(file_text(dir / "f").text() == "early");
  {
    atomic_file undone(dir / "g", {.must_be_new = true});
    undone.commit();
    CHECK(dir.num_files() == 2);
    undone.undo();
  }
  CHECK(dir.num_files() == 1);
}

TEST_CASE("standard files: a target that cannot be replaced is an io_error") {
  const testing::temporary_folder dir;
  CHECK_THROWS_AS(atomic_file(dir / "no/f"), io_error);
  CHECK_THROWS_AS(atomic_file(""), io_error);
  std::filesystem::create_directory(dir / "folder");
  CHECK_THROWS_AS(atomic_file(dir / "folder"), io_error);
  CHECK_THROWS_AS(atomic_file((dir / "folder") + "/"), io_error);
  testing::write_file(dir / "kept", "kept");
  std::filesystem::permissions(dir / "kept", std::filesystem::perms::owner_read);
  CHECK_THROWS_AS(atomic_file(dir / "kept"), io_error);
  CHECK(file_text(dir / "kept").text() == "kept");
  std::filesystem::permissions(dir / "kept", std::filesystem::perms::owner_all);
  CHECK(dir.num_files() == 2);
}

#ifndef _WIN32
TEST_CASE("standard files: a symbolic link is kept, whatever it refers to") {
  const testing::temporary_folder dir;
  std::filesystem::create_symlink("f", dir / "link");
  std::filesystem::create_symlink("link", dir / "link_to_link");
  for (const char* text : {"first", "second"}) {  // the link refers to no file, then to one
    replace(dir / "link_to_link", text);
    CHECK(file_text(dir / "f").text() == text);
  }
  CHECK(std::filesystem::is_symlink(dir / "link"));
  std::filesystem::create_symlink("loop", dir / "loop");
  CHECK_THROWS_AS(atomic_file(dir / "loop"), io_error);
}
#endif

TEST_CASE("standard files: colours of an OBJ file are in a library beside it, and outdated ones are removed") {
  const testing::temporary_folder dir;
  trimesh m({vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 1, 0}}, {{0, 1, 2}});
  const auto color = poly_property<rgba>(m, "color");
  for (const float red : {1.0f, 0.5f}) {
    color[poly_id{0}] = {red, 0, 0, 1};
    save_obj(m, dir / "m.obj");
    const auto back = load_obj<trimesh>(dir / "m.obj");
    CHECK(num_polys(back) == 1);
    CHECK(dir.num_files() == 2);
  }
}

TEST_CASE("standard files: the folder of a mesh is created, and replaced as a whole or not at all") {
  const testing::temporary_folder dir;
  const tetmesh one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), none;
  save_openfoam(one, dir / "a/b/polyMesh");
  const auto stop = [](double fraction, const char*) { return fraction < 1; };
  CHECK_THROWS_AS(save_openfoam(none, dir / "a/b/polyMesh", {.progress = stop}), cancelled);
  CHECK(num_polys(load_openfoam<tetmesh>(dir / "a/b/polyMesh")) == 1);
  save_openfoam(none, dir / "a/b/polyMesh");
  CHECK(num_polys(load_openfoam<tetmesh>(dir / "a/b/polyMesh")) == 0);
  CHECK_THROWS_AS(save_openfoam(one, dir / "c/polyMesh", {.progress = stop}), cancelled);
  CHECK(dir.num_files() == 1);
}
