// Bodies of read_field.hpp: the reader of functions on verts or polys as text.
#pragma once

#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/values/read_field.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/text_cursor.hpp>

#include <charconv>
#include <cmath>

namespace concino::detail {

class field_text_reader : token_cursor {
  const file_field& wanted_;

 public:
  field_text_reader(std::string_view text, std::string_view name, const file_field& wanted)
      : token_cursor(text, name, nullptr, 0), wanted_(wanted) {}

  void read(function_ref<void(const file_field_value&)> f) {
    read_header();
    for (std::uint64_t i = 0; i < wanted_.count; ++i) {
      file_field_value x{};
      if (wanted_.are_integers) x.integer = next_integer_value(i);
      else
        for (int k = 0; k < wanted_.size; ++k) x.numbers[k] = next_number(i);
      f(x);
    }
    skip();
    if (!at_end()) fail_at_more();
  }

 private:
  /// SCALAR_FIELD n or VECTOR_FIELD n, or nothing.
  void read_header() {
    skip();
    double unused = 0;
    if (at_end() || !is_letter(*at) || parse_real(at, end(), unused)) return;
    const char* const from = at;
    const std::string_view keyword = wanted_.size == 3 ? "VECTOR_FIELD" : "SCALAR_FIELD";
    if (word() != keyword) fail(from, {keyword, ", or just the values"});
    skip();
    const char* const count_position = at;
    const std::uint64_t n = next_count("the number of values", 2);
    if (n != wanted_.count) fail_at_count(count_position, n);
  }

  [[noreturn, gnu::cold]] void fail_at_count(const char* position, std::uint64_t n) const {
    fail(position, {"a value for each of the ", wanted_.count, " ", wanted_.elements, " of the mesh"}, {n, " values"});
  }
  /// Errors: parse_error at the place of a value that is not there, with the number of those that are.
  void check_value(std::uint64_t i) {
    skip();
    if (at_end()) fail_at_count(end(), i);
  }
  [[noreturn, gnu::cold]] void fail_at_more() {
    const char* const from = at;
    std::uint64_t num_more = 0;
    const auto size = static_cast<std::uint64_t>(wanted_.size);
    for (; !at_end(); skip(), ++num_more) word();
    if (num_more < size) fail(from, {"the end of the file after ", wanted_.count, " values"});
    fail_at_count(from, wanted_.count + num_more / size);
  }

  double next_number(std::uint64_t i) {
    check_value(i);
    double x = 0;
    const char* const p = parse_real(at, end(), x);
    if (!p || !ends_token(p, 0)) fail(at, "a number");
    if (std::isfinite(x) && std::abs(x) > wanted_.max_number) fail(at, "a number in the range of floats");
    at = p;
    return x;
  }
  std::int64_t next_integer_value(std::uint64_t i) {
    check_value(i);
    const char* const from = at + (*at == '+' ? 1 : 0);
    std::int64_t x = 0;
    const auto [p, wrong] = std::from_chars(from, end(), x);
    if (wrong != std::errc() || !ends_token(p, 0) || x < wanted_.low || x > wanted_.high)
      fail(at, {"an integer from ", wanted_.low, " to ", wanted_.high});
    at = p;
    return x;
  }
};

CONCINO_INLINE void read_field(std::string_view text, std::string_view name, const file_field& wanted,
                               function_ref<void(const file_field_value&)> f) {
  field_text_reader(text, name, wanted).read(f);
}

CONCINO_INLINE void read_field_file(const std::string& path, const file_field& wanted,
                                    function_ref<void(const file_field_value&)> f) {
  check_path(path);
  const file_text file(path, {.pipes = true});
  read_field(file.text(), path, wanted, f);
}

}  // namespace concino::detail
