#include <concino/io/text_sink.hpp>

#include <concino/io/atomic_file.hpp>

#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <fcntl.h>
#include <unistd.h>

using namespace concino;
using namespace concino::testing;
using concino::atomic_file;
using concino::text_sink;

TEST_CASE("text_sink: keeps characters, texts and numbers") {
  text_sink out;
  out << 'a' << " b " << std::string_view("c\n") << 0.1 << ' ' << -0.0 << ' ' << 1e300 << ' ' << 5e-324 << ' ' << std::size_t{7} << ' ' << -12;
  CHECK(std::move(out).release() == "a b c\n0.1 -0 1e+300 5e-324 7 -12");
  CHECK(text_sink().release().empty());
}

TEST_CASE("text_sink: writes more than its buffer holds, in one piece and in many") {
  const std::string large(700000, 'x');
  text_sink kept;
  kept << 'a' << large;
  for (int i = 0; i < 100000; ++i) kept << i << '\n';
  const std::string text = std::move(kept).release();
  CHECK(text.substr(0, 700001) == "a" + large);
  CHECK(text.ends_with("99998\n99999\n"));

  const temporary_folder dir;
  atomic_file file(dir / "f");
  text_sink written(file.descriptor(), dir / "f");
  written << 'a' << large;
  for (int i = 0; i < 100000; ++i) written << i << '\n';
  written.flush();
  file.commit();
  CHECK(read_file(dir / "f") == text);
}

TEST_CASE("text_sink: a failing write is an io_error with the reason") {
  const temporary_folder dir;
  const int read_only = ::open((dir / "f").c_str(), O_RDONLY | O_CREAT, 0600);
  text_sink refused(read_only, dir / "f");
  refused << "x";
  CHECK_THROWS_WITH_AS(refused.flush(), ((dir / "f") + ": cannot be written: Bad file descriptor").c_str(), io_error);
  ::close(read_only);
}
