// Writes the numbers of Gmsh files, version 2.2, as text or binary.
#pragma once

#include <concino/io/text_sink.hpp>

#include <bit>
#include <cstring>
#include <string_view>

namespace concino::detail {

/// Output of rows of numbers in sections. Binary files are little-endian.
class gmsh_output {
  text_sink& out_;
  bool binary_;
  bool row_begins_ = true;

  template<class T>
  void put(T x) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &x, sizeof(T));
    if constexpr (std::endian::native == std::endian::big)
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
    out_ << std::string_view(bytes, sizeof(T));
  }
  void begin_number() {
    if (!row_begins_) out_ << ' ';
    row_begins_ = false;
  }

 public:
  gmsh_output(text_sink& out, bool binary) : out_(out), binary_(binary) {}

  void begin_file() {
    out_ << "$MeshFormat\n2.2 " << (binary_ ? '1' : '0') << " 8\n";
    if (binary_) {
      put(std::int32_t{1});
      out_ << '\n';
    }
    end_section("MeshFormat");
  }

  void begin_section(std::string_view name) { out_ << '$' << name << '\n'; }
  void end_section(std::string_view name) { out_ << "$End" << name << '\n'; }
  /// A line that is text in binary files too.
  void line(std::uint64_t number) { out_ << number << '\n'; }
  void quoted_line(std::string_view text) { out_ << '"' << text << "\"\n"; }
  void group(int dimension, int label, std::string_view name) {
    out_ << dimension << ' ' << label << ' ';
    quoted_line(name);
  }

  void integer(std::int64_t i) {
    if (binary_) return put(static_cast<std::int32_t>(i));
    begin_number();
    out_ << i;
  }
  void real(double x) {
    if (binary_) return put(x);
    begin_number();
    out_ << x;
  }
  void end_row() {
    if (!binary_) out_ << '\n';
    row_begins_ = true;
  }
  /// Ends the rows of a section: its end is on a line of its own.
  void end_rows() {
    if (binary_) out_ << '\n';
  }
};

}  // namespace concino::detail
