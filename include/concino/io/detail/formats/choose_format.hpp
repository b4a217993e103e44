// Chooses the format of a file among those that a call knows.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/format.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace concino::detail {

/// The data of one format by which it is chosen.
struct format_row {
  std::string_view name;
  const std::string_view* extensions;
  std::size_t num_extensions;
  bool (*has_signature)(std::string_view text);  // null: the format has no signature
  bool has_binary;
  bool is_read_only;
  std::string_view signature = {};  // for messages: what has_signature looks for
  bool is_folder = false;
  std::string_view folder_file = {}, folder_in_case = {};  // of folders, as in the format
  bool is_write_only = false;
};

template<class F>
struct format_facts {
  // extensions of any type that converts to std::string_view
  static constexpr auto extensions = [] {
    std::array<std::string_view, std::size(F::extensions)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::begin(F::extensions)[i];
    return all;
  }();
  static constexpr format_row row() {
    format_row r{F::name, extensions.data(), extensions.size(), nullptr, false, requirement::is_read_only<F>};
    if constexpr (requires { F::has_signature; }) r.has_signature = &F::has_signature;
    if constexpr (requires { F::has_binary; }) r.has_binary = F::has_binary;
    if constexpr (requires { F::signature; }) r.signature = F::signature;
    if constexpr (requirement::is_folder<F>) {
      r.is_folder = true;
      r.folder_file = F::folder_file;
      r.folder_in_case = F::folder_in_case;
    }
    r.is_write_only = requirement::is_write_only<F>;
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
constexpr format_rows format_rows_of(format_list<F...>) { return {all_format_rows<F...>::rows.data(), sizeof...(F)}; }

/// Whether the last folder or file of a path has that name; slashes may follow.
bool ends_in_folder(std::string_view path, std::string_view name);

/// The set of formats with the extension of a path, or with the name `requested`: bit i stands for format i.
/// Errors: as check_path; unsupported if none has the name.
std::uint64_t formats_for(std::string_view path, format_id requested, format_rows known);

/// The format to use among the candidates: the last one whose signature the text has, else the last one that has no
/// signature, else the last one. Without a text: the last one.
std::size_t choose_format(std::uint64_t candidates, format_rows known, const std::string_view* text);

/// The format in which a file is read, if its extension determines it: that of choose_format, unless the text has no
/// signature of the candidates, but that of another known format. A note then says so; else it is empty.
/// Errors: unsupported if there is neither a candidate nor a signature, naming the extensions and signatures that are
///         known.
std::size_t choose_by_text(std::string_view path, std::uint64_t candidates, format_rows known, std::string_view text,
                           std::string& note);

/// The candidates that can be written.
/// Errors: unsupported if there is none, naming the extensions that are known or can be written.
std::uint64_t writable(std::string_view path, std::uint64_t candidates, format_rows known);

/// The candidates that can be read.
/// Errors: unsupported if there are candidates, but none that can be read, naming the extensions that can be.
std::uint64_t readable(std::string_view path, std::uint64_t candidates, format_rows known);

/// The set of formats that a path may have, among those that a call knows.
template<Formats F>
std::uint64_t candidates_for(std::string_view path, F formats, format_id requested) {
  if constexpr (Format<F>) {
    if (requested == format_id()) requested = formats;
  }
  return formats_for(path, requested, format_rows_of(list_of(formats)));
}

/// The format in which a file is written.
template<Formats F>
std::size_t chosen_for(std::string_view path, F formats, format_id requested) {
  constexpr format_rows known = format_rows_of(list_of(F{}));
  return choose_format(writable(path, candidates_for(path, formats, requested), known), known, nullptr);
}

/// Calls f(format) for the chosen format.
template<class... F, class Function>
void with_format(format_list<F...>, [[maybe_unused]] std::size_t chosen, [[maybe_unused]] const Function& f) {
  [[maybe_unused]] std::size_t i = 0;
  ((i++ == chosen ? f(F{}) : void()), ...);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/choose_format.ipp>
#endif
