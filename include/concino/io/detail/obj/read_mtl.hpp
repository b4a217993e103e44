// The reader of Wavefront's material libraries, .mtl. A fault in a library is not an error: it becomes a note in the
// report.
#pragma once

#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/text_cursor.hpp>

namespace concino::detail {

/// All libraries of a file, combined into one.
struct material_library {
  material_table table;
  name_table all;                // the names of table.materials
  name_table names;              // the names of the materials that have a colour
  element_values<rgba> colors;     // the colour of each
  std::size_t num_textures = 0;  // map_Kd and the like
  std::size_t num_redefined = 0;
  std::string redefined = {};    // the name of the first of them
};

/// Reads a colour or an opacity from a line; `in` is after the keyword and its blanks.
/// Result: whether the line defines the colour of its material.      Errors: parse_error; the colour is as it was.
inline bool read_color(text_cursor& in, std::string_view keyword, rgba& color) {
  if (in.at_end() || is_letter(*in.at)) return false;  // Kd spectral, Kd xyz: colours in other forms, which are ignored
  if (keyword == "Kd") {
    float x[3];
    for (float& part : x) {
      while (!in.at_end() && is_blank(*in.at)) ++in.at;
      part = static_cast<float>(in.real("three numbers after Kd"));
    }
    color.r = x[0], color.g = x[1], color.b = x[2];
    return true;
  }
  if (keyword == "d" && *in.at != '-') color.a = static_cast<float>(in.real("a number after d"));  // d -halo
  return false;
}

/// The first line of a library written by save; see material_library_file.hpp.
inline constexpr std::string_view signature_begins = "# Materials of ",
                                  signature_goes_on = ", written by concino; checksum ";
inline bool is_signature(std::string_view line) {
  return line.starts_with(signature_begins) && line.find(signature_goes_on) != line.npos;
}

/// Moves to the next line.   Result: the text from `from` to the end of the current line, without trailing blanks.
inline std::string_view rest_of_line(text_cursor& in, const char* from) {
  in.at = from;
  in.skip_line();
  const char* to = in.at;
  while (to != from && is_blank(to[-1])) --to;
  return std::string_view(from, static_cast<std::size_t>(to - from));
}

/// The part of a text before a comment (a # after a blank), without trailing blanks.
inline std::string_view without_comment(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '#' && (i == 0 || is_blank(text[i - 1]))) text = text.substr(0, i);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Adds the materials of a text: newmtl, and all lines up to the next newmtl. Lines Kd and d define a colour. Of
/// materials with the same name, the first is used.
inline void read_mtl(std::string_view text, std::string_view name, material_library& library, load_report& report) {
  text_cursor in(text, name);
  material now;
  rgba color;
  bool has_color = false, is_open = false;
  std::size_t num_bad = 0, num_nameless = 0;
  const auto end_material = [&] {
    if (is_open && now.name.empty()) {
      if (num_nameless++ == 0) report.notes.push_back(core::joined({name, ": a material without a name was skipped"}));
    } else if (is_open) {
      const std::size_t known = library.all.find(now.name);
      if (known == name_table::none) {
        library.all.add(now.name);
        if (has_color) {
          library.names.add(now.name);
          library.colors.push_back(color);
        }
        library.table.materials.push_back(std::move(now));
      } else if (library.table.materials[known].lines != now.lines && library.num_redefined++ == 0) {
        library.redefined = now.name;
      }
    }
    now = {};
    color = {};
    has_color = false;
  };
  for (;;) {
    in.skip_space();
    if (in.at_end()) break;
    const char* const line = in.at;
    const std::string_view word = in.word();
    while (!in.at_end() && is_blank(*in.at)) ++in.at;
    if (word == "newmtl") {
      end_material();
      is_open = true;
      now.name = without_comment(rest_of_line(in, in.at));
      continue;
    }
    try {
      if (read_color(in, word, color)) has_color = true;
      else if (word.starts_with("map_")) ++library.num_textures;
    } catch (const parse_error& e) {
      if (num_bad++ == 0) report.notes.push_back(core::joined({e.what(), "; such lines give no colour"}));
    }
    const std::string_view whole = rest_of_line(in, line);
    if (is_open) now.lines.push_back(std::string(whole));
    else if (!is_signature(whole)) library.table.head.push_back(std::string(whole));
  }
  end_material();
}

}  // namespace concino::detail
