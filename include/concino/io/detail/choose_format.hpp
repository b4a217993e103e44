// Which of the formats that a call knows a file is in.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/paths.hpp>
#include <concino/io/format.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace concino::detail {

/// What is chosen by.
struct format_row {
  std::string_view name;
  const std::string_view* extensions;
  std::size_t num_extensions;
  bool (*has_signature)(std::string_view text);  // null: nothing tells
  bool has_binary;
};

template<class F>
struct format_facts {
  // of any type that converts to texts
  static constexpr auto extensions = [] {
    std::array<std::string_view, std::size(F::extensions)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::begin(F::extensions)[i];
    return all;
  }();
  static constexpr format_row row() {
    format_row r{F::name, extensions.data(), extensions.size(), nullptr, false};
    if constexpr (requires { F::has_signature; }) r.has_signature = &F::has_signature;
    if constexpr (requires { F::has_binary; }) r.has_binary = F::has_binary;
    return r;
  }
};

struct format_rows {
  const format_row* rows;
  std::size_t size;
};
template<class... F>
struct all_format_rows {
  static constexpr std::array<format_row, sizeof...(F)> rows = {format_facts<F>::row()...};
};
template<class... F>
constexpr format_rows rows_of(format_list<F...>) { return {all_format_rows<F...>::rows.data(), sizeof...(F)}; }

/// Upper and lower case mean the same; `extension` is in lower case.
inline bool has_extension(std::string_view path, std::string_view extension) {
  if (path.size() <= extension.size()) return false;
  const std::string_view tail = path.substr(path.size() - extension.size());
  for (std::size_t i = 0; i < tail.size(); ++i)
    if ((tail[i] >= 'A' && tail[i] <= 'Z' ? static_cast<char>(tail[i] + ('a' - 'A')) : tail[i]) != extension[i]) return false;
  return true;
}

/// A bit for each format that has the extension of a path, or for the one that is asked for.
/// Errors: as check_path; unsupported if there is none, naming those that are known.
[[gnu::noinline, gnu::cold]] inline std::uint64_t formats_for(std::string_view path, format_id asked, format_rows known) {
  check_path(path);
  std::uint64_t found = 0;
  std::string all;
  const bool by_extension = asked == format_id();
  for (std::size_t i = 0; i < known.size; ++i) {
    const format_row& row = known.rows[i];
    if (!by_extension) {
      if (row.name == asked.name()) found |= std::uint64_t{1} << i;
      all = core::joined({all, all.empty() ? "" : ", ", row.name});
    } else {
      for (std::size_t k = 0; k < row.num_extensions; ++k) {
        if (has_extension(path, row.extensions[k])) found |= std::uint64_t{1} << i;
        all = core::joined({all, all.empty() ? "" : ", ", row.extensions[k]});
      }
    }
  }
  if (found != 0) return found;
  if (by_extension) core::throw_joined<unsupported>({path, ": the extension names no format known here; known are ", all});
  core::throw_joined<unsupported>({path, ": this call does not know the format ", asked.name(), "; known are ", all});
}

/// Of formats for one extension: the last whose signature the text has, else the last that has none, else the last. Without a text: the last.
[[gnu::noinline, gnu::cold]] inline std::size_t choose_format(std::uint64_t candidates, format_rows known, const std::string_view* text) {
  const auto last = static_cast<std::size_t>(63 - std::countl_zero(candidates));
  if (!text || (candidates & (candidates - 1)) == 0) return last;
  for (std::size_t i = last + 1; i-- > 0;)
    if ((candidates >> i & 1) != 0 && known.rows[i].has_signature && known.rows[i].has_signature(*text)) return i;
  for (std::size_t i = last + 1; i-- > 0;)
    if ((candidates >> i & 1) != 0 && !known.rows[i].has_signature) return i;
  return last;
}

/// The formats that come into question for a path, of those that a call knows.
template<Formats F>
std::uint64_t candidates_for(std::string_view path, F formats, format_id asked) {
  if constexpr (Format<F>) {
    if (asked == format_id()) asked = formats;
  }
  return formats_for(path, asked, rows_of(list_of(formats)));
}

/// The one of them that is written.
template<Formats F>
std::size_t chosen_for(std::string_view path, F formats, format_id asked) {
  return choose_format(candidates_for(path, formats, asked), rows_of(list_of(formats)), nullptr);
}

/// Calls f(format) for the chosen one.
template<class... F, class Function>
void with_format(format_list<F...>, [[maybe_unused]] std::size_t chosen, [[maybe_unused]] const Function& f) {
  [[maybe_unused]] std::size_t i = 0;
  ((i++ == chosen ? f(F{}) : void()), ...);
}

}  // namespace concino::detail
