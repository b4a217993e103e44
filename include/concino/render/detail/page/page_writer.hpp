// Writes the data of a page: JSON, and arrays of numbers as base64.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/text_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace concino::detail {

/// Writes arrays to a page as they come, and keeps the JSON that names them.
class page_writer {
  text_sink& page_;
  text_sink json_;
  std::size_t num_arrays_ = 0;
  bool needs_comma_ = false;

  std::size_t add_array(std::string_view type, std::size_t length, std::span<const unsigned char> bytes);
  void separate();
  void add_string(std::string_view text);

 public:
  explicit page_writer(text_sink& page) : page_(page) {}

  // JSON. Names are of letters, texts of anything.
  void begin(char bracket);
  void begin(std::string_view name, char bracket);
  void end(char bracket);
  void add_name(std::string_view name);
  void add(std::string_view name, std::string_view text);
  void add(std::string_view name, const char* text) { add(name, std::string_view(text)); }
  void add(std::string_view name, double x);
  void add(std::string_view name, bool x);
  void add(std::string_view name, const vec3& x);
  void add(double x);  // null if it is not finite
  void add_text(std::string_view text);

  // Arrays. The JSON has their number.
  void add_bytes(std::string_view name, std::span<const std::uint8_t> numbers);
  void add_signed(std::string_view name, std::span<const std::int8_t> numbers);
  void add_indices(std::string_view name, std::span<const std::uint32_t> numbers);  // of 16 or 32 bits
  void add_numbers(std::string_view name, std::span<const double> numbers);         // of 32 or 64 bits
  void add_floats(std::string_view name, std::span<const float> numbers);

  /// Writes the JSON.
  void finish();
};

/// Text between tags: & < > are escaped, control characters left out.
void write_html_text(text_sink& out, std::string_view text);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/page/page_writer.ipp>
#endif
