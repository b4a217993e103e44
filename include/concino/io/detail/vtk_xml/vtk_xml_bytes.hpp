// Reads the bytes of one array of a .vtu or .vtp file: base64, or appended; compressed or not.
#pragma once

#include <concino/io/detail/vtk/vtk_cursor.hpp>
#include <concino/io/detail/vtk_xml/base64.hpp>
#include <concino/io/file_contents.hpp>

#include <algorithm>
#include <cstring>
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

class vtk_xml_bytes : public vtk_cursor {
  std::uint64_t block_size_ = 0;
  std::vector<std::uint64_t> block_begins_;  // where each compressed block begins, counted from the first one, and
                                             // where the last one ends
  std::uint64_t num_read_ = 0;               // bytes of the file, by all arrays
  bool base64_ = false;
  base64_reader base64_source_{nullptr, nullptr};
  const char* raw_ = nullptr;
  const char* raw_of_blocks_ = nullptr;  // the first compressed block
  std::vector<unsigned char> compressed_;

 protected:
  const read_context& in_;
  vtk_xml_encoding encoding_;
  std::uint64_t bytes_ = 0;  // of the array that is open
  std::vector<unsigned char> buffer_;

  explicit vtk_xml_bytes(const read_context& in) : vtk_cursor(in.text, in.name, in.progress, 0), in_(in) {}

  [[noreturn, gnu::noinline, gnu::cold]] void fail_array(const vtk_xml_array& a, core::message expected,
                                                         core::message found) const {
    fail(a.at, expected, {core::joined(found), " in the array \"", a.name, "\""});
  }

  bool is_empty(const vtk_xml_array& a) const {
    const char* p = a.begin;
    while (p != a.end && is_space(*p)) ++p;
    return a.format == "binary" && p == a.end;
  }

  /// Reads the sizes that precede the data of an array, and compares them with the size of the file.
  void open(const vtk_xml_array& a) {
    const std::uint64_t before = num_read_;
    if (a.format == "appended") {
      if (!encoding_.appended || a.offset > static_cast<std::uint64_t>(text_end() - encoding_.appended))
        fail_array(a, {"an offset into AppendedData"}, {a.offset});
      base64_ = encoding_.base64_appended;
      raw_ = encoding_.appended + a.offset;
      base64_source_ = base64_reader(raw_, text_end());
    } else {
      base64_ = true;
      base64_source_ = base64_reader(a.begin, a.end);
    }
    if (!encoding_.compressed) {
      bytes_ = word(a);
      if (bytes_ > source_left()) fail_array(a, {"no more bytes than the file has"}, {bytes_});
    } else {
      open_compressed(a);
    }
    num_read_ = before;  // what is only looked at does not count
  }
  /// Reads the bytes of an array.
  void read_bytes(const vtk_xml_array& a, unsigned char* to) {
    open(a);
    if (!encoding_.compressed) return take(a, to, bytes_);
    for (std::size_t i = 0; i < num_blocks(); ++i) inflate_block(a, i, to + i * block_size_);
  }
  /// The bytes of the array that is open, in the file. Needs: they are appended as they are.
  const unsigned char* bytes_in_file(const vtk_xml_array& a) {
    count_bytes(a, bytes_);
    return reinterpret_cast<const unsigned char*>(raw_);
  }
  /// Calls use(bytes, count) for the numbers of a compressed array, one block at a time.
  void for_each_block(const vtk_xml_array& a, std::size_t number_size,
                      function_ref<void(const unsigned char*, std::uint64_t)> use) {
    open(a);
    std::uint64_t carried = 0;  // the bytes of a number of which the last block has a part
    for (std::size_t i = 0; i < num_blocks(); ++i) {
      const std::uint64_t size = inflated_size(i), numbers = (carried + size) / number_size,
                          used = numbers * number_size;
      if (buffer_.size() < carried + size) buffer_.resize(carried + size);
      inflate_block(a, i, buffer_.data() + carried);
      if (encoding_.swapped) swap_bytes(buffer_.data(), numbers, number_size);
      use(buffer_.data(), numbers);
      carried += size - used;
      std::memmove(buffer_.data(), buffer_.data() + used, carried);
    }
  }

  /// Appends the bytes of some numbers of an array, in the order of this machine. Of a compressed array only the blocks
  /// that have them are decompressed. Needs: the array is appended as bytes, and has these numbers.
  void append_numbers(const vtk_xml_array& a, std::size_t number_size, std::uint64_t first, std::uint64_t count,
                      std::string& to) {
    if (count == 0) return;
    const std::uint64_t before = num_read_, begin = first * number_size, end = begin + count * number_size;
    const std::size_t old_size = to.size();
    open(a);
    if (!encoding_.compressed) to.append(raw_ + begin, raw_ + end);
    for (std::uint64_t i = encoding_.compressed ? begin / block_size_ : num_blocks(); i < num_blocks(); ++i) {
      const std::uint64_t from = i * block_size_, size = inflated_size(i);
      if (from >= end) break;
      buffer_.resize(std::max<std::size_t>(buffer_.size(), size));
      raw_ = raw_of_blocks_ + block_begins_[i];
      inflate_block(a, i, buffer_.data());
      const auto* const bytes = reinterpret_cast<const char*>(buffer_.data());
      to.append(bytes + (std::max(begin, from) - from), bytes + (std::min(end, from + size) - from));
    }
    num_read_ = before;  // an array may be read in several parts
    if (encoding_.swapped) swap_bytes(to.data() + old_size, count, number_size);
  }

 private:
  std::uint64_t source_left() const {
    return base64_ ? base64_source_.max_left() : static_cast<std::uint64_t>(text_end() - raw_);
  }
  const char* text_end() const { return in_.text.data() + in_.text.size(); }
  void count_bytes(const vtk_xml_array& a, std::uint64_t n) {
    if (n > source_left()) fail_array(a, {n, " more bytes"}, {source_left()});
    num_read_ += n;
    if (num_read_ > in_.text.size())
      fail_array(a, {"arrays that do not share their bytes"}, {"more bytes than the file has"});
  }
  void take(const vtk_xml_array& a, unsigned char* to, std::uint64_t n) {
    count_bytes(a, n);
    if (!base64_) {
      std::memcpy(to, raw_, n);
      raw_ += n;
    } else if (!base64_source_.read(to, n)) {
      fail_array(a, {"base64"},
                 {base64_source_.position() == a.end ? std::string("the end") : found_at(base64_source_.position())});
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

  void open_compressed(const vtk_xml_array& a) {
    if (!in_.inflate)
      core::throw_joined<unsupported>(
          {in_.name,
           ": the arrays are compressed: include <concino/adapters/zlib.hpp> (Debian's zlib1g-dev, link -lz), and load with {.inflate = zlib_inflate}"});
    const std::uint64_t blocks = word(a);
    block_size_ = word(a);
    const std::uint64_t last = word(a);
    if (blocks > source_left() / (encoding_.wide ? 8 : 4))
      fail_array(a, {"no more blocks than the file can hold"}, {blocks});
    if (last > block_size_ || (blocks && block_size_ > ~std::uint64_t{0} / blocks))
      fail_array(a, {"sizes of blocks"}, {block_size_, " and ", last});
    bytes_ = blocks ? block_size_ * (blocks - (last ? 1 : 0)) + last : 0;
    std::uint64_t sum = 0;
    block_begins_.assign(1, 0);
    for (std::uint64_t i = 0; i < blocks; ++i) {
      const std::uint64_t n = word(a);
      if (n > in_.text.size()) fail_array(a, {"blocks no larger than the file"}, {n, " bytes"});
      sum += n;
      block_begins_.push_back(sum);
    }
    raw_of_blocks_ = raw_;
    // zlib shrinks by at most 1032
    if (sum > source_left() || bytes_ / 1040 > sum)
      fail_array(a, {"sizes that zlib data can have"}, {bytes_, " bytes from ", sum});
  }

  std::size_t num_blocks() const { return block_begins_.size() - 1; }
  /// The size of block i when it is decompressed.
  std::uint64_t inflated_size(std::size_t i) const {
    return i + 1 < num_blocks() ? block_size_ : bytes_ - i * block_size_;
  }
  /// Decompresses block i, the next one.
  void inflate_block(const vtk_xml_array& a, std::size_t i, unsigned char* to) {
    const std::uint64_t n = block_begins_[i + 1] - block_begins_[i], size = inflated_size(i);
    const auto* from = reinterpret_cast<const unsigned char*>(raw_);
    if (base64_) {
      compressed_.resize(n);
      take(a, compressed_.data(), n);
      from = compressed_.data();
    } else {
      count_bytes(a, n);
      raw_ += n;
    }
    if (!in_.inflate(from, n, to, size)) fail_array(a, {"zlib data of ", size, " bytes"}, {"other data"});
  }
};

}  // namespace concino::detail
