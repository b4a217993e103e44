// Reads the numbers of one array of a .vtu or .vtp file: text, base64, or appended; compressed or not.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_xml_bytes.hpp>

#include <bit>

namespace concino::detail {

class vtk_xml_data : public vtk_xml_bytes {
  static constexpr std::size_t largest_part = 1024;  // of an array that is converted

 public:
  explicit vtk_xml_data(const read_context& in) : vtk_xml_bytes(in) {}

 protected:
  /// Checks that an array has n numbers, before any memory is allocated for them. Errors: parse_error if it does not.
  void require_numbers(const vtk_xml_array& a, std::uint64_t n) {
    if (a.type == vtk_number::none) fail(a.at, {"an array of numbers"}, {"another type in the array \"", a.name, "\""});
    if (a.format == "ascii") {
      if (n > (static_cast<std::uint64_t>(a.end - a.begin) + 1) / 2)
        fail_array(a, {n, " numbers"}, {a.end - a.begin, " characters"});
      return;
    }
    const std::uint64_t size = vtk_names_of(a.type).size;
    if (n == 0 && is_empty(a)) return;
    open(a);
    if (n > max_count * 16 || bytes_ != n * size)
      fail_array(a, {n, " numbers of ", size, " bytes"}, {bytes_, " bytes"});
  }
  /// How many numbers an array has; if it is text, how many words. Errors: parse_error for bytes of no whole number.
  std::uint64_t count_numbers(const vtk_xml_array& a) {
    if (a.format == "ascii") return count_words(a);
    if (is_empty(a)) return 0;
    open(a);
    const std::uint64_t size = vtk_names_of(a.type).size;
    if (bytes_ % size != 0) fail_array(a, {"numbers of ", size, " bytes"}, {bytes_, " bytes"});
    return bytes_ / size;
  }

  /// Reads n numbers of the array's own type. Needs: require_numbers(a, n), and room for them.
  void read_array(const vtk_xml_array& a, std::uint64_t n, void* to) {
    if (n == 0) return;
    if (a.format == "ascii") {
      begin_text(a);
      return read_values_of(a.type, to, n);
    }
    read_bytes(a, static_cast<unsigned char*>(to));
    if (encoding_.swapped) swap_bytes(to, n, vtk_names_of(a.type).size);
  }

  /// Calls use(values, count) for parts of the n numbers of an array, converted to T: double or std::int64_t.
  template<class T>
  void for_each_part(const vtk_xml_array& a, std::uint64_t n, function_ref<void(const T*, std::size_t)> use) {
    require_numbers(a, n);
    const std::size_t size = vtk_names_of(a.type).size;
    const bool is_same = std::is_same_v<T, double> ? a.type == vtk_number::float64
                                                   : a.type == vtk_number::int64 || a.type == vtk_number::uint64;
    const auto use_parts = [&](const unsigned char* from, std::uint64_t m) {
      const bool in_place = is_same && reinterpret_cast<std::uintptr_t>(from) % alignof(T) == 0;
      T part[largest_part];
      for (std::uint64_t i = 0; i < m; i += std::size(part)) {
        const std::size_t count = std::min<std::uint64_t>(std::size(part), m - i);
        if (!in_place) convert(a.type, from + i * size, count, part);
        use(in_place ? reinterpret_cast<const T*>(from) + i : part, count);
      }
    };
    if (n && a.format == "ascii") {
      unsigned char part[8 * largest_part];
      begin_text(a);
      for (std::uint64_t count; n > 0; n -= count) {
        count = std::min<std::uint64_t>(largest_part, n);
        read_values_of(a.type, part, count);
        use_parts(part, count);
      }
    } else if (n && encoding_.compressed) {
      for_each_block(a, size, use_parts);
    } else {
      use_parts(bytes_of(a, n), n);
    }
    buffer_.clear();
    if (buffer_.capacity() > std::size_t{1} << 20) std::vector<unsigned char>().swap(buffer_);
  }
  /// The same with integers. Errors: parse_error if the array has reals.
  void for_each_integers(const vtk_xml_array& a, std::uint64_t n,
                         function_ref<void(const std::int64_t*, std::size_t)> use) {
    if (a.type == vtk_number::float32 || a.type == vtk_number::float64)
      fail(a.at, {"integers"}, {"reals in the array \"", a.name, "\""});
    for_each_part<std::int64_t>(a, n, use);
  }

  template<class N, class T>
  static void convert_from(const unsigned char* from, std::size_t n, T* to) {
    for (std::size_t k = 0; k < n; ++k) {
      N x;
      std::memcpy(&x, from + k * sizeof(N), sizeof x);
      to[k] = static_cast<T>(x);
    }
  }
  /// Converts n integers.
  static void convert(vtk_number type, const unsigned char* from, std::size_t n, std::int64_t* to) {
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

 private:
  static std::uint64_t count_words(const vtk_xml_array& a) {
    std::uint64_t n = 0;
    bool in_word = false;
    for (const char* c = a.begin; c != a.end; ++c) {
      n += !is_space(*c) && !in_word;
      in_word = !is_space(*c);
    }
    return n;
  }
  /// Moves to the numbers of an array that is text.
  void begin_text(const vtk_xml_array& a) {
    token_cursor& here = *this;
    here =
        token_cursor(in_.text.substr(0, static_cast<std::size_t>(a.end - in_.text.data())), in_.name, in_.progress, 0);
    at = a.begin;
  }
  /// The n numbers of an array, in the file if they stand there as they are in memory, else in the buffer. Needs: as
  /// read_array; no text.
  const unsigned char* bytes_of(const vtk_xml_array& a, std::uint64_t n) {
    if (n && a.format == "appended" && !encoding_.base64_appended && !encoding_.compressed && !encoding_.swapped) {
      open(a);
      return bytes_in_file(a);
    }
    buffer_.reserve(n * vtk_names_of(a.type).size);
    buffer_.resize(n * vtk_names_of(a.type).size);
    read_array(a, n, buffer_.data());
    return buffer_.data();
  }
  /// Needs: at most `largest_part` numbers.
  static void convert(vtk_number type, const unsigned char* from, std::size_t n, double* to) {
    if (type == vtk_number::float64) return convert_from<double>(from, n, to);
    if (type == vtk_number::float32) return convert_from<float>(from, n, to);
    if (type == vtk_number::uint64) return convert_from<std::uint64_t>(from, n, to);
    std::int64_t integers[largest_part];
    convert(type, from, n, integers);
    for (std::size_t k = 0; k < n; ++k) to[k] = static_cast<double>(integers[k]);
  }
};

}  // namespace concino::detail
