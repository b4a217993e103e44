#include <concino/io/file_text.hpp>

#include <doctest/doctest.h>

#include <atomic>
#include <fstream>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <support/temporary.hpp>

using namespace concino;
using concino::file_access;
using concino::file_text;

TEST_CASE("file_text: has the text of files, read or mapped, also after a move") {
  const testing::temporary_folder dir;
  testing::write_file(dir / "a", "hello\n");
  testing::write_file(dir / "empty", "");
  testing::write_file(dir / "one", "x");
  const std::string large(3'000'000, 'x');
  testing::write_file(dir / "large", large);
  for (const bool map : {false, true}) {
    file_text a(dir / "a", {.map = map});
    CHECK(a.text() == "hello\n");
    CHECK(file_text(dir / "empty", {.map = map}).text().empty());
    CHECK(file_text(dir / "one", {.map = map}).text() == "x");
    CHECK(file_text(dir / "large", {.map = map}).text() == large);
    file_text b = std::move(a);
    CHECK(b.text() == "hello\n");
    CHECK(a.text().empty());
    b.close("a");
    CHECK(b.text().empty());
  }
  CHECK(file_text("/proc/self/stat").text().size() > 10);  // its reported size is 0
}

// Files of this size are read in parts, by several threads.
TEST_CASE("file_text: reads large files in parts, from the current position of an open file") {
  const testing::temporary_folder dir;
  std::string text(21'000'003, '\0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * 2'654'435'761u >> 13);
  testing::write_file(dir / "a", text);
  CHECK((file_text(dir / "a").text() == text));

  const int file = ::open((dir / "a").c_str(), O_RDONLY);
  REQUIRE(::lseek(file, 1000, SEEK_SET) == 1000);
  CHECK((file_text(file, "a", text.size() - 1000).text() == std::string_view(text).substr(1000)));
  REQUIRE(::lseek(file, 1000, SEEK_SET) == 1000);
  CHECK_THROWS_AS(file_text(file, "a", text.size() - 999), io_error);    // the file is shorter than the given size
  REQUIRE(::lseek(file, 1000, SEEK_SET) == 1000);
  CHECK_THROWS_AS(file_text(file, "a", text.size() - 1001), io_error);   // the file is longer than the given size
  REQUIRE(::lseek(file, 1000, SEEK_SET) == 1000);
  CHECK_THROWS_AS(file_text(file, "a", text.size() + 5'000'000), io_error);
  ::close(file);
}

TEST_CASE("file_text: the text does not change when the file changes later") {
  const testing::temporary_folder dir;
  testing::write_file(dir / "a", "hello\n");
  const file_text a(dir / "a");
  testing::write_file(dir / "a", "");
  CHECK(a.text() == "hello\n");
}

// Descriptor 0 is then the descriptor of the file. This is no error; it is closed, and other programs do not inherit it.
TEST_CASE("file_text: works in a program without a standard input") {
  const testing::temporary_folder dir;
  testing::write_file(dir / "a", "hello\n");
  const int input = ::dup(0);
  ::close(0);
  for (const bool map : {false, true}) {
    {
      file_text a(dir / "a", {.map = map});
      CHECK(a.text() == "hello\n");
      CHECK(::fcntl(0, F_GETFD) == (map ? FD_CLOEXEC : -1));
    }
    CHECK(::fcntl(0, F_GETFD) == -1);
  }
  file_text changed(dir / "a", {.map = true});
  std::ofstream(dir / "a", std::ios::app) << "more";
  CHECK_THROWS_AS(changed.close("a"), io_error);
  CHECK(::fcntl(0, F_GETFD) == -1);
  if (input >= 0) {
    ::dup2(input, 0);
    ::close(input);
  }
}

TEST_CASE("file_text: the io_error of a file that cannot be read names path and reason") {
  const testing::temporary_folder dir;
  CHECK_THROWS_WITH_AS(file_text(dir / "none"), ((dir / "none") + ": cannot be opened: No such file or directory").c_str(), io_error);
  for (const bool pipes : {false, true}) {
    CHECK_THROWS_WITH_AS(file_text(dir.path(), {.pipes = pipes}), (dir.path() + ": cannot be read: Is a directory").c_str(), io_error);
    CHECK_THROWS_WITH_AS(file_text("/dev/zero", {.pipes = pipes}), "/dev/zero: is not a regular file", io_error);
    CHECK_THROWS_AS(file_text("", {.pipes = pipes}), io_error);
  }
  ::mkfifo((dir / "pipe").c_str(), 0600);
  CHECK_THROWS_AS(file_text(dir / "pipe"), io_error);  // does not wait for a writer
  if (::geteuid() != 0) {
    testing::write_file(dir / "secret", "x");
    ::chmod((dir / "secret").c_str(), 0);
    CHECK_THROWS_AS(file_text(dir / "secret"), io_error);
  }
}

TEST_CASE("file_text: pipes are read to their end if the option allows them") {
  const testing::temporary_folder dir;
  ::mkfifo((dir / "pipe").c_str(), 0600);
  CHECK(file_text(dir / "pipe", {.pipes = true}).text().empty());  // no process writes to it

  for (const bool map : {false, true}) {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const std::string sent(500'000, 'y');  // more than the buffer of a pipe
    std::thread writer([&] {
      for (std::size_t done = 0; done < sent.size();) done += static_cast<std::size_t>(::write(ends[1], sent.data() + done, sent.size() - done));
      ::close(ends[1]);
    });
    const file_text got("/dev/fd/" + std::to_string(ends[0]), {.map = map, .pipes = true});
    writer.join();
    ::close(ends[0]);
    CHECK(got.text() == sent);
  }
}

TEST_CASE("file_text: a failing read is an io_error, and never writes beyond the buffer") {
  const testing::temporary_folder dir;
  const int fd = ::open((dir / "a").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  CHECK_THROWS_WITH_AS(file_text(fd, "a", 0), "a: cannot be read: Bad file descriptor", io_error);
  ::close(fd);

  // Each read from such a socket takes one message and drops what does not fit: here the reads get 40,000 and then 25,536 bytes.
  int ends[2];
  REQUIRE(::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) == 0);
  const std::string message(40'000, 'm');
  for (int i = 0; i < 2; ++i) REQUIRE(::write(ends[1], message.data(), message.size()) == 40'000);
  ::close(ends[1]);
  CHECK(file_text(ends[0], "a", 0).text() == std::string(65'536, 'm'));
  ::close(ends[0]);
}

TEST_CASE("file_text: a file whose size differs from the reported one is an io_error") {
  const testing::temporary_folder dir;
  testing::write_file(dir / "a", "0123456789");
  const auto open = [&](std::uint64_t size) {
    const int fd = ::open((dir / "a").c_str(), O_RDONLY | O_CLOEXEC);
    try {
      const std::string text(file_text(fd, "a", size).text());
      ::close(fd);
      return text;
    } catch (...) {
      ::close(fd);
      throw;
    }
  };
  CHECK(open(10) == "0123456789");
  CHECK(open(0) == "0123456789");
  CHECK_THROWS_WITH_AS(open(11), "a: shrank while it was read; load it again once it is complete", io_error);
  CHECK_THROWS_WITH_AS(open(9), "a: grew while it was read; load it again once it is complete", io_error);
  CHECK_THROWS_AS(open(~std::uint64_t{0}), std::bad_alloc);

  file_text small(dir / "a", {.map = true}), large(dir / "a", {.map = true});
  std::ofstream(dir / "a", std::ios::app) << "more";
  CHECK_THROWS_WITH_AS(small.close("a"), "a: grew while it was read; load it again once it is complete", io_error);
  CHECK(small.text().empty());
  REQUIRE(::truncate((dir / "a").c_str(), 3) == 0);
  CHECK_THROWS_WITH_AS(large.close("a"), "a: shrank while it was read; load it again once it is complete", io_error);
}

TEST_CASE("file_text: a file whose size keeps changing is read or is an io_error") {
  const testing::temporary_folder dir;
  const std::string path = dir / "a";
  for (const std::size_t large : {4'000'000u, 12'000'000u}) {
    testing::write_file(path, "x");  // the other thread may begin late
    std::atomic<bool> stop = false;
    std::thread other([&] {
      for (bool grow = true; !stop; grow = !grow) ::truncate(path.c_str(), grow ? static_cast<::off_t>(large) : 1);
    });
    for (int i = 0; i < 200; ++i) {
      try {
        const std::size_t size = file_text(path).text().size();
        CHECK((size == 1 || size == large));
      } catch (const io_error&) {
      }
    }
    stop = true;
    other.join();
  }
}
