#include <concino/io/text_cursor.hpp>

#include <concino/io/detail/text/characters.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::detail;

TEST_CASE("text_cursor: LF, CRLF and CR end lines, each once") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "a" + end + "b" + end + end + "c";
    const text_cursor in(text, "t");
    CHECK(in.line_of(text.data()) == 1);
    CHECK(in.line_of(text.data() + text.find('b')) == 2);
    CHECK(in.line_of(text.data() + text.find('c')) == 4);
  }
  const std::string mixed = "a\r\n\rb\n\nc";
  CHECK(text_cursor(mixed, "t").line_of(mixed.data() + mixed.size() - 1) == 5);
}

TEST_CASE("text_cursor: the end of the file is on the last line that is not blank") {
  const std::string text = "a\nb\n\n \n";
  CHECK(text_cursor(text, "t").line_of(text.data() + text.size()) == 2);
  CHECK(text_cursor("", "t").line_of(text_cursor("", "t").end()) == 1);
}

TEST_CASE("text_cursor: errors name file, line, what was expected and what was found") {
  const std::string text = "1\n2 x\x01y \n";
  token_cursor in(text, "some.file", nullptr, '#');
  CHECK(in.next_integer("a number") == 1);
  CHECK(in.next_integer("a number") == 2);
  try {
    in.next_integer("a number");
    FAIL("no error");
  } catch (const parse_error& e) {
    CHECK(e.file == "some.file");
    CHECK(e.line == 2);
    CHECK(e.expected == "a number");
    CHECK(e.found == "'x\\x01y'");
    CHECK(std::string(e.what()) == "some.file:2: expected a number, found 'x\\x01y'");
  }
  const std::string long_word(1000, 'w');
  CHECK(text_cursor(long_word, "t").found_at(long_word.data()) == "'" + std::string(40, 'w') + "...'");
  CHECK(text_cursor("", "t").found_at(nullptr) == "an empty file");
}

TEST_CASE("text_cursor: handles comments, byte order marks and numbers followed by letters") {
  token_cursor in("\xEF\xBB\xBF# one\r2 # three\n 4#five\n6x", "t", nullptr, '#');
  CHECK(in.next_integer("i") == 2);
  CHECK(in.next_real("i") == 4);
  CHECK_THROWS_AS(in.next_integer("i"), parse_error);
  token_cursor none("# 2", "t", nullptr, 0);
  CHECK_THROWS_AS(none.next_integer("i"), parse_error);
  token_cursor infinite("inf", "t", nullptr, 0);
  CHECK_THROWS_WITH_AS(infinite.next_real("x"), "t:1: expected x, a finite number, found 'inf'", parse_error);
}

TEST_CASE("token_cursor: counts are limited by the length of the text, and indices by their bound") {
  token_cursor in("1000000000000 -1 3 0", "t", nullptr, 0);
  const auto n = in.next_count("how many", 2);
  CHECK(n == 1000000000000);
  CHECK(in.reservable(n, 2) < 6);
  CHECK_THROWS_AS(in.next_count("how many", 2), parse_error);
  CHECK(in.next_index(3, "an index") == 2);
  CHECK_THROWS_WITH_AS(in.next_index(3, "an index"), "t:1: expected an index from 1 to 3, found '0'", parse_error);
  CHECK(token_cursor("0", "t", nullptr, 0).next_index(1, "an index", 0) == 0);
  CHECK_THROWS_WITH_AS(token_cursor("1", "t", nullptr, 0).next_index(1, "an index", 0), "t:1: expected an index from 0 to 0, found '1'", parse_error);
  CHECK_THROWS_WITH_AS(token_cursor("-1", "t", nullptr, 0).next_index(9, "an index", 0), "t:1: expected an index from 0 to 8, found '-1'", parse_error);
  CHECK_THROWS_WITH_AS(token_cursor("0", "t", nullptr, 0).next_index(0, "an index", 0), "t:1: expected an index, but there is nothing to refer to, found '0'", parse_error);
}

TEST_CASE("text_cursor: progress increases to the end of the text, and can cancel") {
  const std::string text(100000, ' ');
  std::vector<double> told;
  const auto hear = [&](double f, const char* label) {
    CHECK(std::string(label) == "reading");
    told.push_back(f);
    return told.size() < 50;
  };
  const concino::progress p = hear;
  text_cursor in(text, "t", &p);
  const auto read = [&] {
    while (!in.at_end()) {
      in.report_progress();
      ++in.at;
    }
  };
  CHECK_THROWS_AS(read(), cancelled);
  CHECK(told.size() == 50);
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK(told.front() == 0);
  CHECK(told.back() < 0.6);
}

TEST_CASE("text_cursor: classifies blanks, line ends and letters") {
  for (int i = 0; i < 256; ++i) {
    const char c = static_cast<char>(i);
    CHECK(is_blank(c) == (i == ' ' || i == '\t' || i == '\v' || i == '\f'));
    CHECK(is_line_end(c) == (i == '\n' || i == '\r'));
    CHECK(is_space(c) == (is_blank(c) || is_line_end(c)));
    CHECK(is_letter(c) == ((i >= 'a' && i <= 'z') || (i >= 'A' && i <= 'Z')));
  }
}

TEST_CASE("text_cursor: never reads before or beyond the text") {
  const std::string buffer = "\r\n \n#9";
  const text_cursor blank(std::string_view(buffer).substr(1, 3), "t");
  CHECK(blank.line_of(blank.end()) == 1);
  const text_cursor in(std::string_view(buffer).substr(1, 4), "t");
  CHECK(in.line_of(in.end() - 1) == 3);
  CHECK(in.left() == 4);
  CHECK(in.found_at(in.end() - 1) == "'#'");
}

TEST_CASE("text_cursor: errors show unprintable characters by their numbers") {
  const std::string odd = "\x1f~\x7f\x80";
  CHECK(text_cursor(odd, "t").found_at(odd.data()) == "'\\x1f~\\x7f\\x80'");
}

TEST_CASE("text_cursor: a number ends at a blank or a comment, by default #") {
  text_cursor in("1.5#\x01", "t");
  CHECK(in.real("x") == 1.5);
  in.skip_space();
  CHECK(*in.at == '#');
  text_cursor i("7# 8", "t");
  CHECK(i.integer("i") == 7);
  text_cursor odd("\x01 2", "t");
  odd.skip_space();
  CHECK(odd.left() == 3);
  for (const std::string bad : {"1.5x", "1$", "1.5$", "15x"}) {
    CHECK_THROWS_AS(text_cursor(bad, "t").real("x"), parse_error);
    CHECK_THROWS_AS(text_cursor(bad, "t").integer("i"), parse_error);
    CHECK_THROWS_AS(token_cursor(bad, "t", nullptr, 0).next_index(99, "an index"), parse_error);
  }
}

TEST_CASE("token_cursor: reservable limits a count by what fits into the text; the last element needs no line end") {
  CHECK(token_cursor("12345", "t", nullptr, 0).reservable(100, 2) == 3);
  CHECK(token_cursor("123456", "t", nullptr, 0).reservable(100, 2) == 3);
  CHECK(token_cursor("123456", "t", nullptr, 0).reservable(2, 2) == 2);
}

TEST_CASE("text_cursor: progress is reported about a hundred times, if there is a callback") {
  for (const std::size_t size : {50u, 100u, 1000u}) {
    std::vector<double> told;
    const auto hear = [&](double f, const char*) { return told.push_back(f), true; };
    const concino::progress p = hear;
    const std::string text(size, ' ');
    text_cursor in(text, "t", &p);
    for (in.report_progress(); !in.at_end(); in.report_progress()) ++in.at;
    const std::size_t step = size / 100 + 1, times = (size + step - 1) / step;
    REQUIRE(told.size() == times);
    for (std::size_t i = 0; i < times; ++i) CHECK(told[i] == static_cast<double>(i * step) / static_cast<double>(size));
  }
  const concino::progress nobody = nullptr;
  text_cursor deaf("  ", "t", &nobody), alone("  ", "t");
  for (; !deaf.at_end(); ++deaf.at, ++alone.at) {
    deaf.report_progress();
    alone.report_progress();
  }
  deaf.report_progress();
  alone.report_progress();
}

TEST_CASE("text_cursor: finds the lines of positions in any order") {
  const std::string text = "a\nb\r\nc\rd\n\ne";
  const concino::text_cursor in(text, "t");
  const std::size_t lines[] = {1, 1, 2, 2, 3, 3, 3, 4, 4, 5, 6};
  for (std::size_t i = 0; i < text.size(); ++i)
    for (std::size_t j = 0; j < text.size(); ++j) {
      CHECK(in.line_of(text.data() + i) == concino::text_cursor(text, "t").line_of(text.data() + i));
      CHECK(in.line_of(text.data() + j) == lines[j]);
    }
}
