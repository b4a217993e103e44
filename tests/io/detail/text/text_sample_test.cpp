// sample_lines estimates the number of lines of a text by samples.
#include <concino/io/detail/text/text_sample.hpp>

#include <doctest/doctest.h>

#include <string>

using namespace concino::detail;

TEST_CASE("sample_lines: estimates the number of lines of a long text to 2 percent") {
  std::string text;
  std::size_t verts = 0, faces = 0;
  for (; verts < 60000; ++verts) text += "v 0." + std::to_string(verts * 7919 % 100000) + " 1.5 2\n";
  for (; faces < 120000; ++faces) text += "f " + std::to_string(faces % 60000 + 1) + " 2 3\n";
  std::size_t v = 0, f = 0, words = 0;
  const double scale = sample_lines(text, [&](const char* line, const char* end) {
    v += *line == 'v';
    f += *line == 'f';
    if (*line == 'f') words += words_of_line(line, end);
  });
  CHECK(scale * static_cast<double>(v) == doctest::Approx(static_cast<double>(verts)).epsilon(0.02));
  CHECK(scale * static_cast<double>(f) == doctest::Approx(static_cast<double>(faces)).epsilon(0.02));
  CHECK(words == 4 * f);
  CHECK(with_margin(1000) >= 1000);
}

TEST_CASE("sample_lines: returns 0 for short texts") {
  CHECK(sample_lines("v 0 0 0\nv 1 1 1\n", [](const char*, const char*) {}) == 0);
  CHECK(sample_lines("", [](const char*, const char*) {}) == 0);
}

TEST_CASE("words_of_line: counts the words up to the end of the line") {
  const auto words = [](const std::string& s) { return words_of_line(s.data(), s.data() + s.size()); };
  CHECK(words("f 1 2 3\nf 1") == 4);
  CHECK(words("  f\t1/2/3  2 \r\n") == 3);
  CHECK(words("") == 0);
}
