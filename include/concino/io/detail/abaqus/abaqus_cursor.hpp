// A position in an Abaqus file: keyword lines, which begin with *, and data lines of fields with commas between them.
#pragma once

#include <concino/io/text_cursor.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// The text in upper case.
inline std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - ('a' - 'A'));
  return upper;
}

/// A keyword line: *ELEMENT, TYPE=C3D4, ELSET=wall.
struct abaqus_keyword {
  struct parameter {
    std::string name, value;  // the value is empty if there is none
  };

  const char* at = nullptr;
  std::string name;  // in upper case, without blanks
  std::vector<parameter> parameters = {};

  /// The value of a parameter, or null if the line has none of that name.
  const std::string* find(std::string_view wanted) const {
    for (const parameter& p : parameters)
      if (std::string_view(p.name) == wanted) return &p.value;
    return nullptr;
  }
};

class abaqus_cursor : public text_cursor {
 public:
  abaqus_cursor(std::string_view text, std::string_view name, const concino::progress* on_progress)
      : text_cursor(text_without_padding(text), name, on_progress) {}

  /// Moves to the first word of the next line that is neither blank nor a comment. Returns false if there is none.
  bool next_line() {
    report_progress();
    for (;;) {
      skip_space();
      if (at_end()) return false;
      if (*at != '*' || left() < 2 || at[1] != '*') return true;
      skip_line();
    }
  }
  /// Moves to the next data line. Returns false if a keyword or the end of the file comes first.
  bool next_data_line() { return next_line() && *at != '*'; }

  /// Reads a keyword line, and the lines that continue it. Needs: next_line(), and that the line begins with *.
  abaqus_keyword read_keyword() {
    abaqus_keyword k{at, {}};
    ++at;
    std::string value;
    bool is_first = true, goes_on = true;
    while (goes_on) {
      std::string word = keyword_part(value);
      goes_on = !at_end() && *at == ',';
      if (goes_on) ++at;
      if (is_first) k.name = upper_case(word);
      else if (!word.empty()) k.parameters.push_back({upper_case(word), std::move(value)});
      is_first = false;
      while (!at_end() && is_blank(*at)) ++at;
      if (goes_on && (at_end() || is_line_end(*at))) goes_on = next_data_line();  // a comma at the end of the line
    }
    return k;
  }

  /// Moves to the next field of the data line. Returns false if there is none.
  bool has_field() {
    while (!at_end() && is_blank(*at)) ++at;
    return !at_end() && !is_line_end(*at);
  }
  /// Reads a field, without blanks around it, and moves behind its comma.
  std::string_view field() {
    while (!at_end() && is_blank(*at)) ++at;
    const char* const from = at;
    while (!at_end() && *at != ',' && !is_line_end(*at)) ++at;
    const char* to = at;
    while (to != from && is_blank(to[-1])) --to;
    if (!at_end() && *at == ',') ++at;
    return {from, static_cast<std::size_t>(to - from)};
  }
  std::int64_t integer_field(const char* expected) {
    const std::string_view text = field();
    std::int64_t i = 0;
    if (!is_integer(text, i)) fail(text.data(), expected);
    return i;
  }
  /// A real number; 0 if the field is empty.
  double real_field(const char* expected) {
    const std::string_view text = field();
    if (text.empty()) return 0;
    double x = 0;
    if (parse_real(text.data(), text.data() + text.size(), x) != text.data() + text.size()) fail(text.data(), expected);
    if (!std::isfinite(x)) fail(text.data(), {expected, ", a finite number"});
    return x;
  }
  static bool is_integer(std::string_view text, std::int64_t& i) {
    return !text.empty() && parse_integer(text.data(), text.data() + text.size(), i) == text.data() + text.size();
  }

 private:
  /// Reads a keyword, or a parameter and its value, up to a comma or the end of the line. Blanks are left out, but
  /// those in quotation marks, which are left out themselves.
  std::string keyword_part(std::string& value) {
    std::string word;
    value.clear();
    std::string* to = &word;
    bool quoted = false;
    for (; !at_end() && !is_line_end(*at) && (quoted || *at != ','); ++at) {
      if (*at == '"') quoted = !quoted;
      else if (!quoted && to == &word && *at == '=') to = &value;
      else if (quoted || !is_blank(*at)) *to += *at;
    }
    return word;
  }
};

}  // namespace concino::detail
