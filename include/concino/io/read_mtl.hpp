// The colours of Wavefront's material libraries, .mtl. Nothing that is wrong with a library is an error: it becomes a note.
#pragma once

#include <concino/io/contents.hpp>
#include <concino/io/mapped_file.hpp>
#include <concino/io/text_cursor.hpp>

namespace concino::detail {

struct material_library {
  name_table names;           // of the materials that have a colour
  given_values<rgba> colors;  // of each
  std::size_t num_textures = 0;  // map_Kd and the like
};

/// Adds what a text says: newmtl, Kd and d; of materials of one name the first counts.
[[gnu::noinline, gnu::cold]] inline void read_mtl(std::string_view text, std::string_view name, material_library& library, load_report& report) {
  text_cursor in(text, name);
  std::string material;
  bool is_new = false;
  rgba color;
  bool has_color = false;
  std::size_t num_bad = 0;
  const auto end_material = [&] {
    if (is_new && has_color) {
      library.names.add(material);
      library.colors.push_back(color);
    }
    has_color = false;
    color = {};
  };
  const auto blanks = [&] {
    while (!in.at_end() && is_blank(*in.at)) ++in.at;
  };
  for (;;) {
    in.skip_space('#');
    if (in.at_end()) break;
    const char* const line = in.at;
    const std::string_view word = in.word();
    blanks();
    try {
      if (word == "newmtl") {
        end_material();
        const char* const from = in.at;
        in.skip_line();
        const char* to = in.at;
        for (const char* p = from; p != to;) {
          if (*p == '#' && (p == from || is_blank(p[-1]))) to = p;
          else ++p;
        }
        while (to != from && is_blank(to[-1])) --to;
        material.assign(from, static_cast<std::size_t>(to - from));
        is_new = library.names.find(material) == name_table::none;
      } else if (word == "Kd" && !in.at_end() && !is_letter(*in.at)) {  // Kd spectral, Kd xyz: other ways to say a colour
        float* const parts[] = {&color.r, &color.g, &color.b};
        for (float* const part : parts) {
          blanks();
          *part = static_cast<float>(in.real("three numbers after Kd"));
        }
        has_color = true;
      } else if (word == "d" && !in.at_end() && !is_letter(*in.at) && *in.at != '-') {  // d -halo
        color.a = static_cast<float>(in.real("a number after d"));
      } else if (word.starts_with("map_")) {
        ++library.num_textures;
      }
    } catch (const parse_error& e) {
      if (num_bad++ == 0) report.notes.push_back(joined({e.what(), "; such lines were skipped"}));
      in.at = line;
    }
    in.skip_line();
  }
  end_material();
}

/// The library of that name beside the file of the context, or null.
[[gnu::noinline, gnu::cold]] inline bool read_library(const read_context& context, std::string name, material_library& library) {
  for (char& c : name)
    if (c == '\\') c = '/';
  if (name.starts_with('/') || (name.size() > 1 && name[1] == ':')) name.erase(0, name.rfind('/') + 1);  // a path of another machine
  const std::size_t slash = context.name.rfind('/');
  const std::string path = joined({context.name.substr(0, slash == std::string_view::npos ? 0 : slash + 1), name});
  if (name.empty() || ::access(path.c_str(), F_OK) != 0) return false;
  try {
    const mapped_file file(path);
    read_mtl(file.text(), path, library, *context.report);
  } catch (const io_error& e) {
    context.report->notes.push_back(e.what());
  }
  return true;
}

/// Colours of the polys from the libraries that a file names, one or more on a line. Materials that writers made up for colours lose their
/// names.
[[gnu::noinline, gnu::cold]] inline void color_polys(const read_context& context, const std::vector<std::string>& lines, std::size_t polys, file_contents& contents) {
  load_report& report = *context.report;
  material_library library;
  for (const std::string& line : lines) {
    if (!context.is_file) {
      report.notes.push_back(joined({"material library '", line, "': not read, the text has no folder"}));
      continue;
    }
    if (read_library(context, line, library)) continue;
    for (std::size_t at = 0; at < line.size();) {  // a name may have blanks, and a line many names
      const std::size_t end = std::min(line.find(' ', at), line.size());
      if (end > at && !read_library(context, line.substr(at, end - at), library))
        report.notes.push_back(joined({"material library '", line.substr(at, end - at), "': there is no such file beside this one"}));
      at = end + 1;
    }
  }
  if (library.num_textures) report.skipped.push_back(joined({library.num_textures, " textures of materials (map_Kd and the like)"}));
  bool any = false;
  name_table missing;  // one note for all
  contents.materials.for_each(polys, [&](std::size_t, std::size_t, std::string_view name) {
    const bool known = library.names.find(name) != name_table::none;
    any = any || known;
    if (!known && !name.empty()) missing.add(name);
  });
  if (!any) return;
  if (missing.size() > 0) {
    std::size_t first = 0;  // of the alphabet
    for (std::size_t i = 1; i < missing.size(); ++i)
      if (std::string_view(missing[i]) < missing[first]) first = i;
    report.notes.push_back(joined({missing.size(), " materials have no colour in a library: white; '", missing[first], "'"}));
  }
  contents.poly_colors.resize(polys);
  contents.materials.for_each(polys, [&](std::size_t p, std::size_t end, std::string_view name) {
    const std::size_t color = library.names.find(name);
    if (color == name_table::none) return;
    for (; p != end; ++p) contents.poly_colors[p] = library.colors[color];
  });
  int ignored = 0;
  contents.materials.rename(
      [&](std::string_view name) { return says_number(name, "color_", ignored) ? std::string() : std::string(name); });
}

}  // namespace concino::detail
