// Writes the sections of MEDIT files, as text or binary.
#pragma once

#include <concino/io/detail/medit/medit_sections.hpp>
#include <concino/io/text_sink.hpp>

#include <bit>
#include <cstring>
#include <limits>
#include <vector>

namespace concino::detail {

/// Output of MEDIT sections: add_section() all of them, then for each begin() and its rows. Binary files are
/// little-endian.
class medit_output {
  struct entry {
    const medit_section* section;  // null: Vertices
    std::uint64_t count;
  };
  text_sink& out_;
  bool binary_;
  std::vector<entry> plan_;
  std::size_t next_ = 0;  // in plan_
  int version_ = 2;
  std::uint64_t position_ = 0;
  char row_[9 * 8];
  std::size_t used_ = 0;
  bool row_begins_ = true;

  template<class T>
  void put(T x) {
    if constexpr (std::endian::native == std::endian::big) {
      for (std::size_t i = sizeof(T); i-- > 0;) row_[used_++] = reinterpret_cast<const char*>(&x)[i];
    } else {
      std::memcpy(row_ + used_, &x, sizeof(T));
      used_ += sizeof(T);
    }
  }
  void flush() {
    out_ << std::string_view(row_, used_);
    used_ = 0;
  }
  void put_position(std::uint64_t x) {
    if (version_ < 3) put(static_cast<std::int32_t>(x));
    else put(static_cast<std::int64_t>(x));
  }
  void put_integer(std::int64_t x) {
    if (version_ < 4) put(static_cast<std::int32_t>(x));
    else put(x);
  }
  std::uint64_t bytes_of_position() const { return version_ < 3 ? 4 : 8; }
  std::uint64_t bytes_of_integer() const { return version_ < 4 ? 4 : 8; }
  std::uint64_t bytes_of(const entry& e) const {
    std::uint64_t row = 3 * 8;
    if (!e.section) row += bytes_of_integer();
    else if (e.section->rows != medit_rows::normals)
      row = (e.section->arity + e.section->has_reference()) * bytes_of_integer();
    return 4 + bytes_of_position() + bytes_of_integer() + e.count * row;
  }
  std::uint64_t bytes_of_dimension() const { return 8 + bytes_of_position(); }

  /// The oldest version whose numbers can hold all positions and indices.
  void choose_version() {
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    std::uint64_t bytes = 8 + bytes_of_dimension();
    for (const entry& e : plan_) {
      bytes += bytes_of(e);
      if (e.count > most) version_ = 4;
    }
    if (version_ == 2 && bytes > most) version_ = 3;
  }

 public:
  medit_output(text_sink& out, bool binary) : out_(out), binary_(binary) {}

  /// Plans a section, unless it is empty.
  void add_section(const medit_section* section, std::uint64_t count) {
    if (count > 0 || !section) plan_.push_back({section, count});
  }

  void begin_file() {
    if (!binary_) {
      out_ << "MeshVersionFormatted 2\nDimension 3\n";
      return;
    }
    choose_version();
    position_ = 8 + bytes_of_dimension();
    put(std::int32_t{1}), put(std::int32_t{version_});
    put(medit_dimension_code), put_position(position_), put(std::int32_t{3});
    flush();
  }

  /// Begins the next planned section. Returns its table entry; null for Vertices.
  const medit_section* begin() {
    const entry e = plan_[next_++];
    if (binary_) {
      position_ += bytes_of(e);
      put(e.section ? e.section->code : medit_vertices_code), put_position(position_),
          put_integer(static_cast<std::int64_t>(e.count));
      flush();
    } else {
      out_ << (e.section ? e.section->keyword : "Vertices") << '\n' << e.count << '\n';
    }
    return e.section;
  }
  bool has_next() const { return next_ < plan_.size(); }

  void integer(std::int64_t x) {
    if (binary_) return put_integer(x);
    if (!row_begins_) out_ << ' ';
    out_ << x;
    row_begins_ = false;
  }
  /// Writes an index that counts from 0.
  void index(std::uint64_t i) { integer(static_cast<std::int64_t>(i) + 1); }
  void real(double x) {
    if (binary_) return put(x);
    if (!row_begins_) out_ << ' ';
    out_ << x;
    row_begins_ = false;
  }
  void end_row() {
    if (binary_) return flush();
    out_ << '\n';
    row_begins_ = true;
  }

  void end_file() {
    if (!binary_) {
      out_ << "End\n";
      return;
    }
    put(medit_end_code), put_position(0);
    flush();
  }
};

}  // namespace concino::detail
