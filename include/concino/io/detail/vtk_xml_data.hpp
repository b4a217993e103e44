// Reads the numbers of one array of a .vtu or .vtp file: text, base64, or appended; compressed or not.
#pragma once

#include <concino/io/detail/base64.hpp>
#include <concino/io/detail/vtk_cursor.hpp>
#include <concino/io/file_contents.hpp>

#include <algorithm>
#include <bit>
#include <vector>

namespace concino::detail {

/// A DataArray.
struct vtk_xml_array {
  const char* at = nullptr;  // its tag, for errors
  std::string name;
  vtk_number type = vtk_number::none;
  std::uint64_t components = 1, tuples = 0, offset = 0;
  std::string_view format;                          // ascii, binary or appended
  const char *begin = nullptr, *end = nullptr;      // what is between its tags
};

/// What holds for all arrays of a file.
struct vtk_xml_encoding {
  bool swapped = false;    // the byte order is not that of this machine
  bool wide = false;       // header words have 64 bits
  bool compressed = false;
  const char *appended = nullptr;  // behind the _; null if there is none
  bool base64_appended = false;
};

class vtk_xml_data : public vtk_cursor {
 protected:
  const read_context& in_;
  vtk_xml_encoding encoding_;

 private:
  static constexpr std::size_t largest_part = 1024;  // of an array that is converted

  // the array that is open
  bool base64_ = false;
  base64_reader base64_source_{nullptr, nullptr};
  const char *raw_ = nullptr;
  std::uint64_t bytes_ = 0, block_size_ = 0;
  std::vector<std::uint64_t> block_bytes_;  // of the compressed blocks
  std::uint64_t num_read_ = 0;              // bytes of the file, by all arrays
  std::vector<unsigned char> buffer_, compressed_;

 public:
  explicit vtk_xml_data(const read_context& in) : vtk_cursor(in.text, in.name, in.progress, 0), in_(in) {}

 protected:
  [[noreturn, gnu::noinline, gnu::cold]] void fail_array(const vtk_xml_array& a, core::message expected, core::message found) const {
    fail(a.at, expected, {core::joined(found), " in the array \"", a.name, "\""});
  }

  /// Checks that an array has n numbers, before any memory is allocated for them. Errors: parse_error if it does not.
  [[gnu::noinline]] void require_numbers(const vtk_xml_array& a, std::uint64_t n) {
    if (a.type == vtk_number::none) fail(a.at, {"an array of numbers"}, {"another type in the array \"", a.name, "\""});
    if (a.format == "ascii") {
      if (n > (static_cast<std::uint64_t>(a.end - a.begin) + 1) / 2) fail_array(a, {n, " numbers"}, {a.end - a.begin, " characters"});
      return;
    }
    const std::uint64_t size = vtk_names_of(a.type).size;
    if (n == 0 && is_empty(a)) return;
    open(a);
    if (n > max_count * 16 || bytes_ != n * size) fail_array(a, {n, " numbers of ", size, " bytes"}, {bytes_, " bytes"});
  }
  /// How many numbers an array has. Needs: it is not text.
  std::uint64_t count_numbers(const vtk_xml_array& a) {
    if (is_empty(a)) return 0;
    open(a);
    return bytes_ / vtk_names_of(a.type).size;
  }

  /// Reads n numbers of the array's own type. Needs: require_numbers(a, n), and room for them.
  [[gnu::noinline]] void read_array(const vtk_xml_array& a, std::uint64_t n, void* to) {
    if (n == 0) return;
    if (a.format == "ascii") {
      token_cursor& here = *this;
      here = token_cursor(in_.text.substr(0, static_cast<std::size_t>(a.end - in_.text.data())), in_.name, in_.progress, 0);
      at = a.begin;
      read_values_of(a.type, to, n);
      return;
    }
    read_bytes(a, static_cast<unsigned char*>(to));
    if (encoding_.swapped) swap_bytes(to, n, vtk_names_of(a.type).size);
  }

  /// Calls use(values, count) for parts of the n numbers of an array, converted to T.
  template<class T>
  [[gnu::noinline]] void for_each_part(const vtk_xml_array& a, std::uint64_t n, function_ref<void(const T*, std::size_t)> use) {
    require_numbers(a, n);
    const std::size_t size = vtk_names_of(a.type).size;
    const unsigned char* const from = bytes_of(a, n);
    T part[largest_part];
    for (std::uint64_t i = 0; i < n; i += std::size(part)) {
      const std::size_t count = std::min<std::uint64_t>(std::size(part), n - i);
      convert(a.type, from + i * size, count, part);
      use(part, count);
    }
    buffer_.clear();
    if (buffer_.capacity() > std::size_t{1} << 20) std::vector<unsigned char>().swap(buffer_);
  }
  /// The same with integers. Errors: parse_error if the array has reals.
  [[gnu::noinline]] void for_each_integers(const vtk_xml_array& a, std::uint64_t n, function_ref<void(const std::int64_t*, std::size_t)> use) {
    if (a.type == vtk_number::float32 || a.type == vtk_number::float64) fail(a.at, {"integers"}, {"reals in the array \"", a.name, "\""});
    for_each_part<std::int64_t>(a, n, use);
  }
  template<class Use>
  void for_each_integer(const vtk_xml_array& a, std::uint64_t n, const Use& use) {
    for_each_integers(a, n, [&](const std::int64_t* values, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) use(values[i]);
    });
  }

 private:
  /// The n numbers of an array, in the file if they stand there as they are in memory, else in the buffer. Needs: as read_array.
  [[gnu::noinline]] const unsigned char* bytes_of(const vtk_xml_array& a, std::uint64_t n) {
    if (n && a.format == "appended" && !encoding_.base64_appended && !encoding_.compressed && !encoding_.swapped) {
      open(a);
      count_bytes(a, bytes_);
      return reinterpret_cast<const unsigned char*>(raw_);
    }
    core::reserve_large(buffer_, n * vtk_names_of(a.type).size);
    buffer_.resize(n * vtk_names_of(a.type).size);
    read_array(a, n, buffer_.data());
    return buffer_.data();
  }
  template<class N, class T>
  [[gnu::noinline]] static void convert_from(const unsigned char* from, std::size_t n, T* to) {
    for (std::size_t k = 0; k < n; ++k) {
      N x;
      std::memcpy(&x, from + k * sizeof(N), sizeof x);
      to[k] = static_cast<T>(x);
    }
  }
  [[gnu::noinline]] static void convert(vtk_number type, const unsigned char* from, std::size_t n, std::int64_t* to) {
    switch (type) {
      case vtk_number::int8: return convert_from<std::int8_t>(from, n, to);
      case vtk_number::uint8: return convert_from<std::uint8_t>(from, n, to);
      case vtk_number::int16: return convert_from<std::int16_t>(from, n, to);
      case vtk_number::uint16: return convert_from<std::uint16_t>(from, n, to);
      case vtk_number::int32: return convert_from<std::int32_t>(from, n, to);
      case vtk_number::uint32: return convert_from<std::uint32_t>(from, n, to);
      default: return convert_from<std::int64_t>(from, n, to);
    }
  }
  /// Needs: at most `largest_part` numbers.
  [[gnu::noinline]] static void convert(vtk_number type, const unsigned char* from, std::size_t n, double* to) {
    if (type == vtk_number::float64) return convert_from<double>(from, n, to);
    if (type == vtk_number::float32) return convert_from<float>(from, n, to);
    if (type == vtk_number::uint64) return convert_from<std::uint64_t>(from, n, to);
    std::int64_t integers[largest_part];
    convert(type, from, n, integers);
    for (std::size_t k = 0; k < n; ++k) to[k] = static_cast<double>(integers[k]);
  }

  bool is_empty(const vtk_xml_array& a) const {
    return a.format == "binary" && std::all_of(a.begin, a.end, [](char c) { return is_space(c); });
  }

  std::uint64_t source_left() const { return base64_ ? base64_source_.max_left() : static_cast<std::uint64_t>(text_end() - raw_); }
  const char* text_end() const { return in_.text.data() + in_.text.size(); }
  void count_bytes(const vtk_xml_array& a, std::uint64_t n) {
    if (n > source_left()) fail_array(a, {n, " more bytes"}, {source_left()});
    num_read_ += n;
    if (num_read_ > in_.text.size()) fail_array(a, {"arrays that do not share their bytes"}, {"more bytes than the file has"});
  }
  void take(const vtk_xml_array& a, unsigned char* to, std::uint64_t n) {
    count_bytes(a, n);
    if (!base64_) {
      std::memcpy(to, raw_, n);
      raw_ += n;
    } else if (!base64_source_.read(to, n)) {
      fail_array(a, {"base64"}, {base64_source_.position() == a.end ? std::string("the end") : found_at(base64_source_.position())});
    }
  }
  std::uint64_t word(const vtk_xml_array& a) {
    unsigned char bytes[8] = {};
    const std::size_t size = encoding_.wide ? 8 : 4;
    take(a, bytes, size);
    if (encoding_.swapped) swap_bytes(bytes, 1, size);
    std::uint64_t x = 0;
    std::uint32_t low = 0;
    std::memcpy(&x, bytes, 8);
    std::memcpy(&low, bytes, 4);
    return encoding_.wide ? x : low;
  }

  /// Reads the sizes that precede the data of an array, and compares them with the size of the file.
  [[gnu::noinline, gnu::cold]] void open(const vtk_xml_array& a) {
    const std::uint64_t before = num_read_;
    if (a.format == "appended") {
      if (!encoding_.appended || a.offset > static_cast<std::uint64_t>(text_end() - encoding_.appended)) fail_array(a, {"an offset into AppendedData"}, {a.offset});
      base64_ = encoding_.base64_appended;
      raw_ = encoding_.appended + a.offset;
      base64_source_ = base64_reader(raw_, text_end());
    } else {
      base64_ = true;
      base64_source_ = base64_reader(a.begin, a.end);
    }
    block_bytes_.clear();
    if (!encoding_.compressed) {
      bytes_ = word(a);
      if (bytes_ > source_left()) fail_array(a, {"no more bytes than the file has"}, {bytes_});
    } else {
      open_compressed(a);
    }
    num_read_ = before;  // what is only looked at does not count
  }
  [[gnu::noinline, gnu::cold]] void open_compressed(const vtk_xml_array& a) {
    if (!in_.inflate)
      core::throw_joined<unsupported>({in_.name, ": the arrays are compressed: include <concino/adapters/zlib.hpp> (Debian's zlib1g-dev, link -lz), and load with {.inflate = zlib_inflate}"});
    const std::uint64_t blocks = word(a);
    block_size_ = word(a);
    const std::uint64_t last = word(a);
    if (blocks > source_left() / (encoding_.wide ? 8 : 4)) fail_array(a, {"no more blocks than the file can hold"}, {blocks});
    if (last > block_size_ || (blocks && block_size_ > ~std::uint64_t{0} / blocks)) fail_array(a, {"sizes of blocks"}, {block_size_, " and ", last});
    bytes_ = blocks ? block_size_ * (blocks - (last ? 1 : 0)) + last : 0;
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < blocks; ++i) {
      block_bytes_.push_back(word(a));
      if (block_bytes_.back() > in_.text.size()) fail_array(a, {"blocks no larger than the file"}, {block_bytes_.back(), " bytes"});
      sum += block_bytes_.back();
    }
    if (sum > source_left() || bytes_ / 1040 > sum) fail_array(a, {"sizes that zlib data can have"}, {bytes_, " bytes from ", sum});  // zlib shrinks by at most 1032
  }

  /// Reads the bytes of an array.
  [[gnu::noinline]] void read_bytes(const vtk_xml_array& a, unsigned char* to) {
    open(a);
    if (!encoding_.compressed) return take(a, to, bytes_);
    std::uint64_t left_over = bytes_;
    for (const std::uint64_t n : block_bytes_) {
      const std::uint64_t size = std::min(block_size_, left_over);
      compressed_.resize(n);
      take(a, compressed_.data(), n);
      if (!in_.inflate(compressed_.data(), n, to, size)) fail_array(a, {"zlib data of ", size, " bytes"}, {"other data"});
      to += size;
      left_over -= size;
    }
  }
};

}  // namespace concino::detail
