#include <concino/io/atomic_file.hpp>

#include <concino/io/load.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/save.hpp>
#include <concino/io/field.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <functional>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace concino;
using namespace concino::testing;
using concino::atomic_file;
using concino::atomic_file_options;
namespace fs = std::filesystem;

namespace {

void write(const atomic_file& file, const std::string& text) {
  REQUIRE(::write(file.descriptor(), text.data(), text.size()) == static_cast<::ssize_t>(text.size()));
}
void replace(const std::string& path, const std::string& text, const atomic_file_options& options = {}) {
  atomic_file file(path, options);
  write(file, text);
  file.commit();
}

/// Calls f in a process that then ends at once, without destructors.
void in_a_process_that_dies(const std::function<void()>& f) {
  const ::pid_t child = ::fork();
  if (child == 0) {
    f();
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(status == 0);
}

const trimesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});

}  // namespace

TEST_CASE("atomic_file: only commit replaces the target") {
  for (const bool unnamed : {true, false}) {
    const temporary_folder dir;
    write_file(dir / "f", "old");
    {
      atomic_file file(dir / "f", {.unnamed = unnamed});
      write(file, "new");
      CHECK(read_file(dir / "f") == "old");
      CHECK(dir.num_files() == (unnamed ? 1 : 2));
    }
    CHECK(read_file(dir / "f") == "old");
    CHECK(dir.num_files() == 1);
    {
      // of two writers at a time, the last to commit replaces the whole file
      atomic_file a(dir / "f", {.unnamed = unnamed}), b(dir / "f", {.unnamed = unnamed});
      write(a, "aaa");
      write(b, "bbbbbb");
      b.commit();
      CHECK(read_file(dir / "f") == "bbbbbb");
      a.commit();
    }
    CHECK(read_file(dir / "f") == "aaa");
    replace(dir / "g", "new", {.sync = true, .unnamed = unnamed});
    replace(dir / "g", "newer", {.sync = true, .unnamed = unnamed});
    CHECK(read_file(dir / "g") == "newer");
    CHECK(dir.num_files() == 2);
  }
}

TEST_CASE("atomic_file: a killed process leaves nothing, or a file that the next one removes") {
  const temporary_folder dir;
  write_file(dir / "f", "old");
  in_a_process_that_dies([&] { write(*new atomic_file(dir / "f"), "new"); });
  CHECK(dir.num_files() == 1);
  for (int i = 0; i < 3; ++i) {
    in_a_process_that_dies([&] { write(*new atomic_file(dir / "f", {.unnamed = false}), "new"); });
    CHECK(dir.num_files() == 2);
  }
  CHECK(read_file(dir / "f") == "old");
  replace(dir / "f", "newer", {.unnamed = false});
  CHECK(read_file(dir / "f") == "newer");
  CHECK(dir.num_files() == 1);

  // what a process leaves that is killed between linking and renaming
  write_file(dir / (atomic_file::temporary_name("f") + ".link"), "left behind");
  replace(dir / "f", "newest");
  CHECK(read_file(dir / "f") == "newest");
  CHECK(dir.num_files() == 1);
}

TEST_CASE("atomic_file: with keep_old, undo puts the old file back, and nothing is left behind") {
  for (const bool unnamed : {true, false}) {
    const temporary_folder dir;
    write_file(dir / "f", "old");
    {
      atomic_file file(dir / "f", {.unnamed = unnamed, .keep_old = true}), other(dir / "new", {.unnamed = unnamed, .keep_old = true});
      write(file, "new");
      file.commit();
      other.commit();
      CHECK(read_file(dir / "f") == "new");
      file.undo();
      other.undo();
      CHECK(read_file(dir / "f") == "old");
    }
    CHECK(dir.num_files() == 1);
    in_a_process_that_dies([&] {
      atomic_file file(dir / "f", {.unnamed = unnamed, .keep_old = true});
      file.commit();
    });
    CHECK(read_file(dir / "f") == "");
    for (const std::string text : {"newer", "newest"}) {
      replace(dir / "f", text, {.unnamed = unnamed, .keep_old = true});  // also removes what the process left
      CHECK(read_file(dir / "f") == text);
      CHECK(dir.num_files() == 1);
    }
  }
}

TEST_CASE("atomic_file: with keep_old, a folder that takes the place of the target stays") {
  for (const bool unnamed : {true, false}) {
    const temporary_folder dir;
    {
      atomic_file file(dir / "f", {.unnamed = unnamed, .keep_old = true});
      std::filesystem::create_directory(dir / "f");
      CHECK_THROWS_AS(file.commit(), io_error);
    }
    CHECK(std::filesystem::is_directory(dir / "f"));
    CHECK(dir.num_files() == 1);
  }
}

TEST_CASE("atomic_file: with must_be_new no file is replaced") {
  for (const bool unnamed : {true, false}) {
    const temporary_folder dir;
    atomic_file late(dir / "f", {.must_be_new = true, .unnamed = unnamed});
    write(late, "late");
    replace(dir / "f", "first", {.must_be_new = true, .unnamed = unnamed});
    CHECK_THROWS_WITH_AS(late.commit(), ((dir / "f") + ": cannot be created: File exists").c_str(), io_error);
    CHECK(read_file(dir / "f") == "first");
    atomic_file undone(dir / "g", {.must_be_new = true, .unnamed = unnamed});
    undone.commit();
    CHECK(fs::exists(dir / "g"));
    undone.undo();
    CHECK(!fs::exists(dir / "g"));
  }
}

TEST_CASE("atomic_file: a symbolic link is kept, whatever it refers to") {
  const temporary_folder dir;
  fs::create_directory(dir / "sub");
  fs::create_symlink("sub/b.obj", dir / "dangling.obj");
  fs::create_symlink("dangling.obj", dir / "to_link.obj");
  fs::create_symlink("../c.obj", dir / "sub/up.obj");
  fs::create_symlink(dir / "d.obj", dir / "absolute.obj");
  const std::pair<const char*, const char*> links[] = {
      {"dangling.obj", "sub/b.obj"}, {"to_link.obj", "sub/b.obj"}, {"sub/up.obj", "c.obj"}, {"absolute.obj", "d.obj"}};
  for (const auto& [link, target] : links) {
    for (int round = 0; round < 2; ++round) {  // in the second round the file exists
      save(triangle, dir / link);
      CHECK(fs::is_symlink(dir / link));
      CHECK(fs::is_regular_file(fs::symlink_status(dir / target)));
      CHECK(num_polys(load<trimesh>(dir / target)) == 1);
    }
  }
  fs::create_symlink("loop.obj", dir / "loop.obj");
  CHECK_THROWS_AS(save(triangle, dir / "loop.obj"), io_error);
  fs::create_symlink("none/x.obj", dir / "nowhere.obj");
  CHECK_THROWS_AS(save(triangle, dir / "nowhere.obj"), io_error);
  CHECK(fs::is_symlink(dir / "nowhere.obj"));
}

TEST_CASE("atomic_file: names may be as long as the system allows") {
  const temporary_folder dir;
  for (const std::size_t length : {240u, 241u, 250u, 255u}) {
    const std::string path = dir / (std::string(length - 4, 'n') + ".obj");
    save(triangle, path);
    save(triangle, path);
    CHECK(num_polys(load<trimesh>(path)) == 1);
    replace(path, "x", {.unnamed = false});
    CHECK(read_file(path) == "x");
  }
  CHECK(dir.num_files() == 4);
  CHECK_THROWS_WITH_AS(replace(dir / std::string(256, 'n'), "x"), ((dir / std::string(256, 'n')) + ": cannot be written: File name too long").c_str(),
                       io_error);
}

TEST_CASE("atomic_file: a path with a null character is an io_error") {
  const temporary_folder dir;
  const auto with_zero = [&](const std::string& rest) { return dir / (std::string("a\0", 2) + rest); };
  const std::string message = (dir / "a\\0.obj") + ": a path cannot contain a null character";
  CHECK_THROWS_WITH_AS(save(triangle, with_zero(".obj")), message.c_str(), io_error);
  CHECK_THROWS_WITH_AS(load<trimesh>(with_zero(".obj")), message.c_str(), io_error);
  CHECK_THROWS_WITH_AS(load_any(with_zero(".obj")), message.c_str(), io_error);
  for (const std::string extension : {".obj", ".off", ".mesh", ".hedra"}) {
    CHECK_THROWS_AS(save(triangle, with_zero(extension)), io_error);
    CHECK_THROWS_AS(load<trimesh>(with_zero(extension)), io_error);
  }
  for (const format_id format : standard_formats.ids()) {
    CHECK_THROWS_AS(save(triangle, with_zero(""), {.format = format}), io_error);
    CHECK_THROWS_AS(load<trimesh>(with_zero(""), {.format = format}), io_error);
  }
  const auto u = make_vert_map<double>(triangle);
  CHECK_THROWS_AS(save_field(u, triangle, with_zero(".txt")), io_error);
  CHECK_THROWS_AS(load_vert_field<double>(triangle, with_zero(".txt")), io_error);
  CHECK_THROWS_AS(replace(with_zero(""), "x"), io_error);
  CHECK(dir.num_files() == 0);
}

TEST_CASE("atomic_file: a target that cannot be replaced is an io_error, and no file is left behind") {
  const temporary_folder dir;
  const auto said = [&](const std::string& path) -> std::string {
    try {
      replace(path, "x");
    } catch (const io_error& e) {
      return std::string(e.what()).substr(path.size());
    }
    return "nothing";
  };
  fs::create_directory(dir / "d");
  CHECK(said("") == ": cannot be written: No such file or directory");
  CHECK(said(dir / "d") == ": cannot be written: Is a directory");
  CHECK(said(dir / "d/") == ": cannot be written: Is a directory");
  CHECK(said(dir / "new/") == ": cannot be written: Is a directory");
  CHECK(said(dir / "none/f") == ": cannot be written: No such file or directory");
  REQUIRE(::mkfifo((dir / "pipe").c_str(), 0600) == 0);  // not a device, as a failing test would destroy those of the machine
  CHECK(said(dir / "pipe") == ": is not a regular file");
  fs::remove(dir / "pipe");
  write_file(dir / "f", "old");
  CHECK(said(dir / "f/g") == ": cannot be written: Not a directory");
  CHECK(read_file(dir / "f") == "old");
  CHECK(dir.num_files() == 2);
}

TEST_CASE("atomic_file: every function that writes files has the option sync") {
  const temporary_folder dir;
  save(triangle, dir / "a.obj", {.sync = true});
  CHECK(num_polys(load<trimesh>(dir / "a.obj")) == 1);
  save_field(make_vert_map<double>(triangle), triangle, dir / "u.txt", {.sync = true});
  CHECK(load_vert_field<double>(triangle, dir / "u.txt")[vert_id{0}] == 0);
}
