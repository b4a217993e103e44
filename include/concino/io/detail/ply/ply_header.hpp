// Reads the header of a PLY file: the form of its numbers, its elements and their properties.
#pragma once

#include <concino/io/detail/values/typed_number_cursor.hpp>
#include <concino/io/options.hpp>

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// The names of number types in PLY files: the first of each type is written, both are read. There is no PLY type for
/// integers of 64 bits, but meshio writes them by these names.
struct ply_number_names {
  vtk_number number;
  std::string_view name, sized;
};
inline constexpr ply_number_names ply_numbers[] = {
    {vtk_number::int8, "char", "int8"},        {vtk_number::uint8, "uchar", "uint8"},
    {vtk_number::int16, "short", "int16"},     {vtk_number::uint16, "ushort", "uint16"},
    {vtk_number::int32, "int", "int32"},       {vtk_number::uint32, "uint", "uint32"},
    {vtk_number::float32, "float", "float32"}, {vtk_number::float64, "double", "float64"},
    {vtk_number::int64, "int64", "int64"},     {vtk_number::uint64, "uint64", "uint64"}};

/// The name of a type; empty if PLY has none.
inline std::string_view ply_name_of(vtk_number type) {
  for (std::size_t i = 0; i < 8; ++i)
    if (ply_numbers[i].number == type) return ply_numbers[i].name;
  return {};
}

inline bool is_integer(vtk_number t) { return t != vtk_number::float32 && t != vtk_number::float64; }

struct ply_property {
  std::string_view name;
  vtk_number type = vtk_number::none;         // of the number, or of those of the list
  vtk_number length_type = vtk_number::none;  // of the length of the list; none: a single number

  bool is_list() const { return length_type != vtk_number::none; }
  /// How many bytes an element has for it, at least.
  std::uint64_t min_bytes(bool binary) const {
    return binary ? vtk_names_of(is_list() ? length_type : type).size : 2;
  }
};

struct ply_element {
  std::string_view name;
  std::uint64_t count = 0;
  const char* position = nullptr;
  std::vector<ply_property> properties = {};

  /// The property of one of two names; null if there is none.
  const ply_property* find(std::string_view property, std::string_view or_else = {}) const {
    for (const ply_property& p : properties)
      if (p.name == property || (!or_else.empty() && p.name == or_else)) return &p;
    return nullptr;
  }
};

/// A position in a PLY file. In binary files the line that errors name is that of end_header.
class ply_cursor : public typed_number_cursor {
 protected:
  using typed_number_cursor::typed_number_cursor;

  std::vector<ply_element> elements_;
  std::vector<std::string> textures_;  // the names after "comment TextureFile"

  void header() {
    if (at_end() || next_on_line("ply") != "ply") fail(begin(), "ply");
    blanks();
    if (at_end() || !is_line_end(*at)) fail(at, "the end of the line after ply");
    const bool has_two_line_ends = *at == '\r' && left() > 1 && at[1] == '\n';
    format();
    while (keyword()) {
    }
    binary_line_ = at - 10;  // the length of end_header
    end_of_line();
    if (!binary_) return;
    if (has_two_line_ends && left() > 1 && *at == '\r' && at[1] == '\n') ++at;
    if (!at_end()) ++at;
  }

  /// Errors: parse_error if the rest of the file cannot hold the element.
  void require_room(const ply_element& e) const {
    std::uint64_t bytes = 0;
    for (const ply_property& p : e.properties) bytes += p.min_bytes(binary_);
    if (bytes == 0 || e.count <= (left() + (binary_ ? 0 : 1)) / bytes) return;
    fail(e.position, {"a count that fits into the file"},
         {e.count, " elements \"", e.name, "\", and ", left(), " bytes"});
  }

  /// Reads n numbers of a type. Errors: parse_error if the file ends before.
  void take(vtk_number type, void* to, std::size_t n) {
    if (binary_ && n > left() / vtk_names_of(type).size) reject(end(), {"more numbers"});
    read_values_of(type, to, n);
  }
  /// Reads a number of any type.
  double take_real(vtk_number type) {
    if (!binary_) {
      if (is_integer(type)) return static_cast<double>(take_integer(type));
      report_progress();
      return next_real();
    }
    if (left() < vtk_names_of(type).size) reject(end(), {"more numbers"});
    return with_number_type(type, [&]<class T>(std::type_identity<T>) { return static_cast<double>(value<T>()); });
  }
  /// Needs: a type of integers.
  std::int64_t take_integer(vtk_number type) {
    const std::size_t size = vtk_names_of(type).size;
    if (!binary_) {
      report_progress();
      return static_cast<std::int64_t>(next_integer(is_signed(type), size));
    }
    if (left() < size) reject(end(), {"more numbers"});
    return with_number_type(type,
                            [&]<class T>(std::type_identity<T>) { return static_cast<std::int64_t>(value<T>()); });
  }
  /// Reads the length of a list, and checks that the file can hold the list.
  std::size_t take_length(const ply_property& p) {
    if (!binary_) skip();
    const char* const from = at;
    const std::int64_t n = take_integer(p.length_type);
    if (n < 0) reject(from, {"the length of a list, not negative"});
    typed_number_cursor::require_room(from, static_cast<std::uint64_t>(n), p.type);
    return static_cast<std::size_t>(n);
  }

 private:
  void blanks() {
    while (!at_end() && is_blank(*at)) ++at;
  }
  /// Reads the next word of the line.
  std::string_view next_on_line(const char* expected) {
    blanks();
    if (at_end() || is_line_end(*at)) fail(at, expected);
    return word();
  }
  void end_of_line() {
    blanks();
    if (!at_end() && !is_line_end(*at)) fail(at, "the end of the line");
  }

  void format() {
    for (;;) {
      skip_space();
      const char* const from = at;
      if (const std::string_view w = word(); w == "comment" || w == "obj_info") {
        comment_line();
        continue;
      } else if (w != "format") {
        fail(from, "the word format");
      }
      blanks();
      const char* const form = at;
      const std::string_view w = next_on_line("ascii, binary_little_endian or binary_big_endian");
      if (w != "ascii" && w != "binary_little_endian" && w != "binary_big_endian")
        fail(form, "ascii, binary_little_endian or binary_big_endian");
      binary_ = w != "ascii";
      swapped_ = (w == "binary_little_endian") != (std::endian::native == std::endian::little);
      blanks();
      const char* const version = at;
      if (next_on_line("the version 1.0") != "1.0") fail(version, "the version 1.0");
      return end_of_line();
    }
  }

  void comment_line() {
    const char* const from = at;
    if (next_word_is("TextureFile")) {
      blanks();
      const char* const file = at;
      skip_line();
      textures_.emplace_back(file, at);
    }
    at = from;
    skip_line();
  }
  bool next_word_is(std::string_view w) {
    blanks();
    return word() == w;
  }

  vtk_number type() {
    blanks();
    const char* const from = at;
    const std::string_view w = next_on_line("a type of numbers");
    for (const ply_number_names& n : ply_numbers)
      if (n.name == w || n.sized == w) return n.number;
    fail(from, "a type of numbers: char, uchar, short, ushort, int, uint, float or double");
  }

  /// Reads a line of the header. Result: whether it is another one than end_header.
  bool keyword() {
    skip_space();
    const char* const from = at;
    const std::string_view w = word();
    if (w == "end_header") return false;
    if (w == "comment" || w == "obj_info") {
      comment_line();
    } else if (w == "element") {
      element();
    } else if (w == "property" && !elements_.empty()) {
      property();
    } else {
      fail(from, elements_.empty() ? "element, comment or end_header" : "element, property, comment or end_header");
    }
    return true;
  }

  void element() {
    blanks();
    const char* const from = at;
    const std::string_view named = next_on_line("the name of an element");
    for (const ply_element& e : elements_)
      if (e.name == named) fail(from, "the name of another element");
    blanks();
    const char* const position = at;
    const std::int64_t n = integer("the number of elements", 0);
    if (n < 0) fail(position, "the number of elements, not negative");
    elements_.push_back({named, static_cast<std::uint64_t>(n), position});
    end_of_line();
  }

  void property() {
    ply_property p;
    const char* const back = at;
    if (next_word_is("list")) {
      blanks();
      const char* const from = at;
      p.length_type = type();
      if (!is_integer(p.length_type)) fail(from, "a type of integers, for the length of a list");
    } else {
      at = back;
    }
    p.type = type();
    p.name = next_on_line("the name of a property");
    elements_.back().properties.push_back(p);
    end_of_line();
  }
};

}  // namespace concino::detail
