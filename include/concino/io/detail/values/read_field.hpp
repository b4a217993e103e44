// The reader of functions on verts or polys as text.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace concino::detail {

/// The values that a file has to hold.
struct file_field {
  std::uint64_t count = 0;
  const char* elements = "verts";  // what has these values
  int size = 1;                    // numbers of a value: 1 or 3
  bool are_integers = false;
  // of integers
  std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();
  double max_number = std::numeric_limits<double>::max();  // of other numbers, unless infinite
};

union file_field_value {
  double numbers[3];
  std::int64_t integer;
};

/// Calls f for each value of a text. Errors: parse_error, unless it holds just these values.
void read_field(std::string_view text, std::string_view name, const file_field& wanted,
                function_ref<void(const file_field_value&)> f);

/// The same for a file. Errors: io_error too.
void read_field_file(const std::string& path, const file_field& wanted, function_ref<void(const file_field_value&)> f);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/values/read_field.ipp>
#endif
