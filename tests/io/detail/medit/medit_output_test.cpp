#include <concino/io/detail/medit/medit_output.hpp>

#include <doctest/doctest.h>

#include <cstring>

using namespace concino;

namespace {

using detail::medit_output;
using detail::medit_section;

const medit_section& medit_section_of(std::string_view keyword) {
  for (const medit_section& s : detail::medit_sections)
    if (s.keyword == keyword) return s;
  throw std::out_of_range("no such section");
}

template<class T>
T number_at(const std::string& bytes, std::size_t at) {
  T x;
  REQUIRE(at + sizeof(T) <= bytes.size());
  std::memcpy(&x, bytes.data() + at, sizeof(T));
  return x;
}

/// The headers of a binary file of so many vertices and tets, without their rows.
std::string medit_headers(std::uint64_t vertices, std::uint64_t tets) {
  text_sink out;
  medit_output medit(out, true);
  medit.add_section(nullptr, vertices);
  medit.add_section(&medit_section_of("Tetrahedra"), tets);
  medit.add_section(&medit_section_of("Edges"), 0);
  medit.begin_file();
  CHECK(medit.begin() == nullptr);
  CHECK(medit.begin() == &medit_section_of("Tetrahedra"));
  CHECK(!medit.has_next());
  medit.end_file();
  return std::move(out).release();
}

}  // namespace

TEST_CASE("medit_output: small files have version 2, with positions of 32 bits") {
  const std::string b = medit_headers(10, 3);
  CHECK(number_at<std::int32_t>(b, 0) == 1);
  CHECK(number_at<std::int32_t>(b, 4) == 2);
  CHECK(number_at<std::int32_t>(b, 8) == 3);
  CHECK(number_at<std::int32_t>(b, 12) == 20);
  CHECK(number_at<std::int32_t>(b, 16) == 3);
  CHECK(number_at<std::int32_t>(b, 20) == 4);
  CHECK(number_at<std::int32_t>(b, 24) == 20 + 12 + 10 * 28);
  CHECK(number_at<std::int32_t>(b, 28) == 10);
  CHECK(number_at<std::int32_t>(b, 32) == 8);
  CHECK(number_at<std::int32_t>(b, 36) == 20 + 12 + 10 * 28 + 12 + 3 * 20);
  CHECK(number_at<std::int32_t>(b, 44) == 54);
  CHECK(b.size() == 52);
}

TEST_CASE("medit_output: files of more than 2 GiB have version 3, with positions of 64 bits") {
  // 64 bytes besides the rows of vertices are before the position of End
  const std::uint64_t last = (2147483647 - 64) / 28;
  CHECK(number_at<std::int32_t>(medit_headers(last, 1), 4) == 2);
  CHECK(number_at<std::int32_t>(medit_headers(last + 1, 1), 4) == 3);
  const std::string b = medit_headers(100'000'000, 5);
  CHECK(number_at<std::int32_t>(b, 4) == 3);
  CHECK(number_at<std::int64_t>(b, 12) == 24);
  CHECK(number_at<std::int32_t>(b, 24) == 4);
  CHECK(number_at<std::int64_t>(b, 28) == 24 + 16 + 100'000'000ll * 28);
  CHECK(number_at<std::int32_t>(b, 36) == 100'000'000);
  CHECK(number_at<std::int64_t>(b, 44) == 24 + 16 + 100'000'000ll * 28 + 16 + 5 * 20);
}

TEST_CASE("medit_output: more than 2^31 - 1 elements take version 4, with all integers of 64 bits") {
  CHECK(number_at<std::int32_t>(medit_headers(2147483647, 1), 4) == 3);
  const std::string b = medit_headers(2147483648, 1);
  CHECK(number_at<std::int32_t>(b, 4) == 4);
  CHECK(number_at<std::int64_t>(b, 28) == 24 + 20 + 2147483648ll * 32);
  CHECK(number_at<std::int64_t>(b, 36) == 2147483648ll);
  CHECK(number_at<std::int64_t>(b, 48) == 24 + 20 + 2147483648ll * 32 + 20 + 40);
  CHECK(number_at<std::int64_t>(b, 56) == 1);
}

TEST_CASE("medit_output: text has one row per line") {
  text_sink out;
  medit_output medit(out, false);
  medit.add_section(&medit_section_of("Edges"), 1);
  medit.begin_file();
  medit.begin();
  medit.index(0), medit.index(7), medit.integer(-3);
  medit.end_row();
  medit.end_file();
  CHECK(std::move(out).release() == "MeshVersionFormatted 2\nDimension 3\nEdges\n1\n1 8 -3\nEnd\n");
}
