// Measures readers of texts in memory. The floor of a text is std::from_chars on each of its words, that of a binary file is a copy.
#pragma once

#include "program.hpp"

#include <charconv>
#include <string>
#include <string_view>

namespace bench {

/// Words that are no numbers are skipped, as is the rest of a word after its first number.
inline double sum_of_numbers(std::string_view text) {
  double sum = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    while (at < end && static_cast<unsigned char>(*at) <= ' ') ++at;
    double x = 0;
    if (at < end) at = std::from_chars(at, end, x).ptr;
    sum += x;
    while (at < end && static_cast<unsigned char>(*at) > ' ') ++at;
  }
  return sum;
}

/// Prints the rows parse.* and parse_speed.* of read(), which reads the text.
template<class Read>
void measure_parse(const program& p, const std::string& name, const std::string& text, bool binary, const Read& read) {
  const auto floor = [&] { return binary ? seconds_of([&] { return text; }) : seconds_of([&] { return sum_of_numbers(text); }); };
  const auto rows = compare("parse." + name, p.rounds, {{"floor", floor}, {"concino", [&] { return seconds_of(read); }}});
  p.print(rows);
  for (const row& r : rows)
    if (r.contender == "concino") p.print({{"parse_speed." + name, "concino", "MB/s", static_cast<double>(text.size()) / 1e6 / r.value, 1}});
}

}  // namespace bench
