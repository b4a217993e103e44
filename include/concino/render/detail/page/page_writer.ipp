// Bodies of page_writer.hpp: writes the data of a page: JSON, and arrays of numbers as base64.
#pragma once

#include <concino/render/detail/page/page_writer.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

inline void write_base64(text_sink& out, std::span<const unsigned char> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  char buffer[4096];
  std::size_t used = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) buffer[used++] = k <= n ? digits[group >> (18 - 6 * k) & 63] : '=';
    if (used < sizeof buffer) continue;
    out << std::string_view(buffer, used);
    used = 0;
  }
  out << std::string_view(buffer, used);
}

/// The bytes of numbers, the lowest first.
template<class T>
std::vector<unsigned char> bytes_of_numbers(std::span<const T> numbers) {
  std::vector<unsigned char> bytes(numbers.size_bytes());
  if (bytes.empty()) return bytes;
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  if constexpr (std::endian::native == std::endian::big)
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(T)) std::reverse(&bytes[i], &bytes[i] + sizeof(T));
  return bytes;
}

/// The same numbers as Us.
template<class U, class T>
std::vector<unsigned char> bytes_of_numbers_as(std::span<const T> numbers) {
  std::vector<U> converted(numbers.size());
  std::transform(numbers.begin(), numbers.end(), converted.begin(), [](T x) { return static_cast<U>(x); });
  return bytes_of_numbers(std::span<const U>(converted));
}

CONCINO_INLINE std::size_t page_writer::add_array(std::string_view type, std::size_t length,
                                                  std::span<const unsigned char> bytes) {
  page_ << "<script type=\"text/plain\" data-type=\"" << type << "\" data-length=\"" << length << "\">";
  write_base64(page_, bytes);
  page_ << "</script>\n";
  return num_arrays_++;
}

CONCINO_INLINE void page_writer::separate() {
  if (needs_comma_) json_ << ',';
  needs_comma_ = true;
}
CONCINO_INLINE void page_writer::begin(char bracket) {
  separate();
  json_ << bracket;
  needs_comma_ = false;
}
CONCINO_INLINE void page_writer::begin(std::string_view name, char bracket) {
  add_name(name);
  json_ << bracket;
  needs_comma_ = false;
}
CONCINO_INLINE void page_writer::end(char bracket) {
  json_ << bracket;
  needs_comma_ = true;
}
CONCINO_INLINE void page_writer::add_name(std::string_view name) {
  separate();
  json_ << '"' << name << "\":";
}

CONCINO_INLINE void page_writer::add_string(std::string_view text) {
  static constexpr char digits[] = "0123456789abcdef";
  json_ << '"';
  for (const char c : text) {
    const auto x = static_cast<unsigned char>(c);
    const bool is_special = x < 32 || x == 127 || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&';
    if (is_special) json_ << "\\u00" << digits[x >> 4] << digits[x & 15];
    else json_ << c;
  }
  json_ << '"';
}
CONCINO_INLINE void page_writer::add_text(std::string_view text) {
  separate();
  add_string(text);
}
CONCINO_INLINE void page_writer::add(std::string_view name, std::string_view text) {
  add_name(name);
  add_string(text);
}

CONCINO_INLINE void page_writer::add(double x) {
  separate();
  if (std::isfinite(x)) json_ << x;
  else json_ << "null";
}
CONCINO_INLINE void page_writer::add(std::string_view name, double x) {
  add_name(name);
  needs_comma_ = false;
  add(x);
}
CONCINO_INLINE void page_writer::add(std::string_view name, bool x) {
  add_name(name);
  json_ << (x ? "true" : "false");
}
CONCINO_INLINE void page_writer::add(std::string_view name, const vec3& x) {
  begin(name, '[');
  for (std::size_t k = 0; k < 3; ++k) add(x[k]);
  end(']');
}

CONCINO_INLINE void page_writer::add_bytes(std::string_view name, std::span<const std::uint8_t> numbers) {
  add_name(name);
  json_ << add_array("u1", numbers.size(), bytes_of_numbers(numbers));
}
CONCINO_INLINE void page_writer::add_signed(std::string_view name, std::span<const std::int8_t> numbers) {
  add_name(name);
  json_ << add_array("i1", numbers.size(), bytes_of_numbers(numbers));
}
CONCINO_INLINE void page_writer::add_indices(std::string_view name, std::span<const std::uint32_t> numbers) {
  const bool are_small = std::all_of(numbers.begin(), numbers.end(), [](std::uint32_t i) { return i < 65536; });
  add_name(name);
  json_ << (are_small ? add_array("u2", numbers.size(), bytes_of_numbers_as<std::uint16_t>(numbers))
                      : add_array("u4", numbers.size(), bytes_of_numbers(numbers)));
}
CONCINO_INLINE void page_writer::add_numbers(std::string_view name, std::span<const double> numbers) {
  const bool are_single = std::all_of(numbers.begin(), numbers.end(), [](double x) {
    return !std::isfinite(x) || (std::abs(x) < 3e38 && static_cast<double>(static_cast<float>(x)) == x);
  });
  add_name(name);
  json_ << (are_single ? add_array("f4", numbers.size(), bytes_of_numbers_as<float>(numbers))
                       : add_array("f8", numbers.size(), bytes_of_numbers(numbers)));
}
CONCINO_INLINE void page_writer::add_floats(std::string_view name, std::span<const float> numbers) {
  add_name(name);
  json_ << add_array("f4", numbers.size(), bytes_of_numbers(numbers));
}

CONCINO_INLINE void page_writer::finish() {
  page_ << "<script type=\"application/json\" id=\"scene\">" << std::move(json_).release() << "</script>";
}

CONCINO_INLINE void write_html_text(text_sink& out, std::string_view text) {
  for (const char c : text) {
    if (c == '&') out << "&amp;";
    else if (c == '<') out << "&lt;";
    else if (c == '>') out << "&gt;";
    else if (static_cast<unsigned char>(c) >= 32 && c != 127) out << c;
  }
}

}  // namespace concino::detail
