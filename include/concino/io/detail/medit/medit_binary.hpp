// Finds the sections of binary MEDIT files (.meshb of libMeshb, versions 1 to 4, either byte order), and reads their
// numbers.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/medit/medit_sections.hpp>
#include <concino/io/text_cursor.hpp>

#include <bit>
#include <cstring>

namespace concino::detail {

/// The number with the bytes of x in reverse order.
template<class T>
T reverse_bytes(T x) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, &x, sizeof(T));
  std::reverse(bytes, bytes + sizeof(T));
  std::memcpy(&x, bytes, sizeof(T));
  return x;
}

/// Errors name the byte, in the first line, as there are no lines.
class medit_binary : protected text_cursor {
  load_report& report_;
  bool swapped_ = false;  // the byte order of the file is not that of the machine
  int version_ = 0;
  const char* next_ = nullptr;   // the next keyword; null after the last one
  const char* limit_ = nullptr;  // the end of the rows of the section

 protected:
  int dimension_ = 0;
  bool ended_ = false;
  bool has_ordering_ = false;  // a section that lists the order of nodes in elements

  explicit medit_binary(const read_context& c) : text_cursor(c.text, c.name, c.progress), report_(*c.report) {}

  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, core::message expected,
                                                   core::message found) const {
    text_cursor::fail(begin(), expected,
                      {core::joined(found), " at byte ", static_cast<std::uint64_t>(position - begin())});
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, core::message expected) const {
    fail(position, expected, {position == end() ? "the end of the file" : "another value"});
  }

  void begin_file() {
    limit_ = end();
    if (left() < 8) fail(end(), {"the number 1 and the version of the format, 1 to 4"});
    swapped_ = take<std::int32_t>() != 1;
    version_ = take<std::int32_t>();
    if (version_ < 1 || version_ > 4) fail(at - 4, {"the version of the format, 1 to 4"});
    next_ = at;
  }

  /// Finds the next section of the table, or Vertices, and moves to its first row. Returns false if there is none.
  bool next_section(medit_section_header& header) {
    while (next_ && next_ != end()) {
      at = next_;
      limit_ = end();
      const auto code = read_header<std::int32_t>("the code of a keyword");
      if (code == medit_end_code) {
        ended_ = true;
        return false;
      }
      next_position();
      report_progress();
      if (code == medit_dimension_code) {
        dimension_ = read_header<std::int32_t>("the dimension, 2 or 3");
        if (dimension_ != 2 && dimension_ != 3) fail(at - 4, {"the dimension, 2 or 3"});
      } else if (find(code, header)) {
        return true;
      } else {
        report_.skipped.push_back(
            core::joined({"section with the code ", code, ", ", static_cast<std::uint64_t>(limit_ - at), " bytes"}));
      }
    }
    return false;
  }

  void skip_rows() {}

  std::string describe_position(const char* p) const {
    return core::joined({"at byte ", static_cast<std::uint64_t>(p - begin())});
  }
  const char* position() const { return at; }
  std::uint32_t index(std::uint64_t bound, const char* what) {
    const std::int64_t i = integer();
    if (static_cast<std::uint64_t>(i - 1) >= bound) fail_index(i, bound, what);
    return static_cast<std::uint32_t>(i - 1);
  }
  double coordinate(const char* what) {
    const double x = version_ == 1 ? static_cast<double>(take<float>()) : take<double>();
    if (!std::isfinite(x)) fail(at - real_size(), {what, ", a finite number"});
    return x;
  }
  int reference(const char* what) {
    const std::int64_t i = integer();
    if (i != static_cast<int>(i)) fail(at - integer_size(), {what, " of 32 bits"}, {i});
    return static_cast<int>(i);
  }
  // compared with the size of the file
  std::size_t room_for(const medit_section_header& header, std::uint64_t) const {
    return static_cast<std::size_t>(header.count);
  }

  void end_file() {
    if (!ended_) report_.notes.push_back("the file has no End: it may be cut off");
  }
  void report_rounded() {}

  std::size_t real_size() const { return version_ == 1 ? 4 : 8; }
  std::size_t integer_size() const { return version_ == 4 ? 8 : 4; }

 private:
  [[noreturn, gnu::noinline, gnu::cold]] void fail_index(std::int64_t i, std::uint64_t bound, const char* what) const {
    if (bound == 0) fail(at - integer_size(), {what, ", but there is nothing to refer to"}, {i});
    fail(at - integer_size(), {what, " from 1 to ", bound}, {i});
  }

  /// Reads a number of rows, which were compared with the size of the file.
  template<class T>
  T take() {
    T x;
    std::memcpy(&x, at, sizeof(T));
    at += sizeof(T);
    return swapped_ ? reverse_bytes(x) : x;
  }
  std::int64_t integer() { return version_ == 4 ? take<std::int64_t>() : take<std::int32_t>(); }

  template<class T>
  T read_header(const char* expected) {
    if (static_cast<std::size_t>(limit_ - at) < sizeof(T)) fail(limit_, {expected});
    return take<T>();
  }

  /// Reads the position of the next keyword; 0 if there is none.
  void next_position() {
    const char* const from = at;
    const std::int64_t position = version_ < 3 ? read_header<std::int32_t>("the position of the next keyword")
                                               : read_header<std::int64_t>("the position of the next keyword");
    next_ = nullptr;
    if (position == 0) return;
    if (position < at - begin() || position > end() - begin())
      fail(from,
           {"the position of the next keyword, from ", static_cast<std::uint64_t>(at - begin()), " to ",
            static_cast<std::uint64_t>(end() - begin())},
           {position});
    limit_ = next_ = begin() + position;
  }

  bool find(std::int32_t code, medit_section_header& header) {
    header = {};
    const char* const from = at - (version_ < 3 ? 8 : 12);
    std::size_t row = 0;
    if (code == medit_vertices_code) {
      if (dimension_ == 0) fail(from, {"the dimension before the vertices"});
      row = static_cast<std::size_t>(dimension_) * real_size() + integer_size();
    } else {
      header.section = find_medit_section(&medit_section::code, code);
      has_ordering_ = has_ordering_ || is_medit_ordering(code);
      if (!header.section) return false;
      if (header.section->rows == medit_rows::normals && dimension_ == 0)
        fail(from, {"the dimension before the normals"});
      row = header.section->rows == medit_rows::normals
                ? static_cast<std::size_t>(dimension_) * real_size()
                : (header.section->num_indices() + header.section->has_reference()) * integer_size();
    }
    const char* const number = at;
    const std::int64_t n = version_ == 4 ? read_header<std::int64_t>("the number of rows")
                                         : read_header<std::int32_t>("the number of rows");
    const std::uint64_t most = static_cast<std::uint64_t>(limit_ - at) / row;
    if (n < 0 || static_cast<std::uint64_t>(n) > most)
      fail(number, {"the number of rows of the section, at most ", most, " up to the next one or the end of the file"},
           {n});
    header.count = static_cast<std::uint64_t>(n);
    if (header.count > max_ids) fail_to_count("elements of one kind");
    header.at = at;
    return true;
  }
};

}  // namespace concino::detail
