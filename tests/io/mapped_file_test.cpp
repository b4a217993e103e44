#include <concino/io/mapped_file.hpp>

#include <doctest/doctest.h>

#include <support/temporary.hpp>

using namespace concino;
using concino::detail::mapped_file;

TEST_CASE("mapped_file: text, empty text, moved") {
  const testing::temporary_folder dir;
  testing::write_file(dir / "a", "hello\n");
  testing::write_file(dir / "empty", "");
  mapped_file a(dir / "a");
  CHECK(a.text() == "hello\n");
  CHECK(mapped_file(dir / "empty").text().empty());
  mapped_file b = std::move(a);
  CHECK(b.text() == "hello\n");
  b = mapped_file();
  CHECK(b.text().empty());
}

TEST_CASE("mapped_file: what cannot be read is an io_error that names the path and why") {
  const testing::temporary_folder dir;
  CHECK_THROWS_WITH_AS(mapped_file(dir / "none"), ((dir / "none") + ": cannot be opened: No such file or directory").c_str(), io_error);
  CHECK_THROWS_WITH_AS(mapped_file(dir.path()), (dir.path() + ": cannot be read: Is a directory").c_str(), io_error);
  CHECK_THROWS_AS(mapped_file("/dev/null"), io_error);
  CHECK_THROWS_AS(mapped_file(""), io_error);
  ::mkfifo((dir / "pipe").c_str(), 0600);
  CHECK_THROWS_AS(mapped_file(dir / "pipe"), io_error);  // and does not wait for a writer
  if (::geteuid() != 0) {
    testing::write_file(dir / "secret", "x");
    ::chmod((dir / "secret").c_str(), 0);
    CHECK_THROWS_AS(mapped_file(dir / "secret"), io_error);
  }
}
