// Estimates how many lines of each kind a text has, from short samples of it, so that arrays can be reserved once.
#pragma once

#include <cstddef>
#include <string_view>

namespace concino::detail {

/// Calls visit(line start, end of the text) for the lines that begin in the samples. Returns the factor by which to
/// multiply their counts, or 0 for a text so short that reserving does not matter.
template<class F>
double sample_lines(std::string_view text, F&& visit) {
  constexpr std::size_t pieces = 512, length = 512;
  if (text.size() < 4 * pieces * length) return 0;
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < pieces; ++i) {
    const char* at = text.data() + (text.size() - length - 1) / pieces * i;
    for (const char* const last = at + length; at != last; ++at)
      if (*at == '\n') visit(at + 1, end);
  }
  return static_cast<double>(text.size()) / (pieces * length);
}

/// The number of words of the line that begins at `at`.
inline std::size_t words_of_line(const char* at, const char* end) {
  std::size_t n = 0;
  for (bool in_word = false; at != end && *at != '\n' && *at != '\r'; ++at) {
    const bool blank = *at == ' ' || *at == '\t';
    n += !blank && !in_word;
    in_word = !blank;
  }
  return n;
}

/// A capacity for about n values: a little larger, so that the last few values do not cause a reallocation.
inline std::size_t with_margin(double n) { return static_cast<std::size_t>(n * 1.01) + 16; }

}  // namespace concino::detail
