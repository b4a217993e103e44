// Reads words and numbers of Gmsh files, as text or binary of either byte order.
#pragma once

#include <concino/io/detail/values/typed_number_cursor.hpp>
#include <concino/io/file_contents.hpp>

#include <string>
#include <string_view>

namespace concino::detail {

/// A position in a Gmsh file. The line that errors name in binary files is that of the version of the format.
class gmsh_cursor : protected typed_number_cursor {
 protected:
  load_report& report_;
  bool is_version_4_ = false;
  bool sizes_have_4_bytes_ = false;  // counts and tags of version 4.1, in binary files

  explicit gmsh_cursor(const read_context& c) : typed_number_cursor(c.text, c.name, c.progress, 0), report_(*c.report) {
    swapped_ = false;
  }

  /// Moves to the next number. Returns its position.
  const char* place() {
    if (!binary_) skip();
    return at;
  }

  /// Reads a number that is written as text in binary files too.
  std::int64_t text_number(const char* what) {
    skip();
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    if (!p || !ends_token(p, 0)) reject(at, {what});
    at = p;
    return i;
  }
  std::uint64_t text_count(const char* what) {
    skip();
    const char* const from = at;
    const std::int64_t i = text_number(what);
    if (i < 0) reject(from, {what});
    return static_cast<std::uint64_t>(i);
  }

  /// Reads an integer of 32 bits.
  int take_int(const char* what) {
    if (binary_) return take<std::int32_t>(what);
    const char* const from = place();
    const std::int64_t i = text_number(what);
    if (i != static_cast<int>(i)) reject(from, {what, " of 32 bits"});
    return static_cast<int>(i);
  }
  /// Reads a count or a tag, which are not negative.
  std::uint64_t take_size(const char* what) {
    if (!binary_) return text_count(what);
    if (is_version_4_) return sizes_have_4_bytes_ ? take<std::uint32_t>(what) : take<std::uint64_t>(what);
    const char* const from = at;
    const auto i = take<std::int32_t>(what);
    if (i < 0) reject(from, {what}, {i});
    return static_cast<std::uint64_t>(i);
  }
  std::size_t bytes_of_size() const { return is_version_4_ && !sizes_have_4_bytes_ ? 8 : 4; }

  double take_real(const char* what) {
    if (binary_) return take<double>(what);
    skip();
    double x = 0;
    const char* const p = parse_real(at, end(), x);
    if (!p || !ends_token(p, 0)) reject(at, {what});
    at = p;
    return x;
  }

  /// Checks that the rest of the file can hold n rows of so many numbers, in binary files of so many bytes.
  void check_count(const char* position, std::uint64_t n, std::uint64_t numbers, std::uint64_t bytes) const {
    if (n > (binary_ ? left() / bytes : (left() + 1) / (2 * numbers)))
      reject(position, {"a count that fits into the file"}, {n, ", and ", left(), " bytes are left,"});
  }

  /// Moves behind the end of the line, where the numbers of a binary file begin.
  void begin_numbers() {
    if (!binary_) return;
    skip_line();
    if (left() > 1 && *at == '\r' && at[1] == '\n') ++at;
    if (!at_end()) ++at;
  }

  /// Reads the rest of the line, a text between quotation marks, or a word without them.
  std::string quoted_text() {
    skip();
    const char* const from = at;
    skip_line();
    std::string_view line(from, static_cast<std::size_t>(at - from));
    line = line.substr(0, line.find_last_not_of(" \t") + 1);
    if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    return std::string(line);
  }

  void end_section(std::string_view name) {
    skip();
    const char* const from = at;
    const std::string_view w = word();
    if (!w.starts_with("$End") || w.substr(4) != name) reject(from, {"$End", name});
  }
  void skip_section(std::string_view name) {
    const std::string after = core::joined({"$End", name});
    const std::size_t length = std::string_view(at, left()).find(after);
    if (length == std::string_view::npos) reject(end(), {after});
    at += length + after.size();
  }

  std::string describe_place(const char* p) const {
    return binary_ ? core::joined({"at byte ", static_cast<std::uint64_t>(p - begin())})
                   : core::joined({"on line ", line_of(p)});
  }

 private:
  template<class T>
  T take(const char* what) {
    if (left() < sizeof(T)) reject(end(), {what});
    return value<T>();
  }
};

}  // namespace concino::detail
