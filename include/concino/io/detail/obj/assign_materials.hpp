// Finds the material libraries that a file names, and gives the polys their materials and colours.
#pragma once

#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/obj/read_mtl.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/text_cursor.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Whether a material defines a colour in numbers, and nothing else.
inline bool is_only_color(const material& m) {
  for (const std::string& line : m.lines) {
    const std::size_t keyword = line.starts_with("Kd ") ? 3 : line.starts_with("d ") ? 2 : line.size();
    if (keyword == line.size() || line.find_first_not_of("0123456789+-.eE ", keyword) != line.npos) return false;
  }
  return true;
}

/// The path of the library of that name, if it is in the folder of the file `of` or, if this is a link, of the file it
/// refers to; else empty.
inline std::string library_beside(std::string_view of, std::string name) {
  for (char& c : name)
    if (c == '\\') c = '/';
  // an absolute path, probably of another machine
  if (name.starts_with('/') || (name.size() > 1 && name[1] == ':')) name.erase(0, name.rfind('/') + 1);
  if (name.empty() || name.find('\0') != name.npos) return {};
  const auto beside = [&](std::string_view file) {
    std::string path = core::joined({file.substr(0, file.rfind('/') + 1), name});
    if (status_of(path).kind == file_kind::none) path.clear();
    return path;
  };
  const std::string file = with_slashes(std::string(of));
  std::string path = beside(file);
  if (path.empty())
    if (const std::string real = real_path(file); !real.empty()) path = beside(real);
  return path;
}

/// Reads each library once, even if it is named several times or by several names.
class material_library_reader {
  const read_context& context_;
  material_library& library_;
  name_table seen_;  // identifies a file by the bytes of its device and inode numbers

 public:
  enum class result { absent, unreadable, read };

  material_library_reader(const read_context& c, material_library& l) : context_(c), library_(l) {}

  result operator()(std::string_view name) {
    const std::string path = library_beside(context_.name, std::string(name));
    if (path.empty()) return result::absent;
    if (const file_status status = status_of(path); status.kind != file_kind::none) {
      const std::uint64_t file[] = {status.device, status.number};
      const std::size_t seen = seen_.size();
      if (seen_.add(std::string_view(reinterpret_cast<const char*>(file), sizeof file)) != seen) return result::read;
    }
    try {
      const file_text file(path);
      read_mtl(file.text(), path, library_, *context_.report);
    } catch (const io_error& e) {
      context_.report->notes.push_back(e.what());
      return result::unreadable;
    }
    return result::read;
  }
};

/// Reads the libraries that the lines of a file name. A line names one or more.
inline void read_libraries(const read_context& context, const std::vector<std::string>& lines,
                           material_library& library) {
  load_report& report = *context.report;
  material_library_reader read(context, library);
  name_table seen_lines, seen_names;
  const auto add = [&](const std::string& name, bool is_read) {
    const std::size_t before = seen_names.size();
    if (seen_names.add(name) != before) return;
    library.table.libraries.push_back(name);
    if (!is_read) library.table.unread.push_back(name);
  };
  std::vector<std::string> missing;
  for (const std::string& line : lines) {
    const std::size_t before = seen_lines.size();
    if (seen_lines.add(line) != before || line.empty()) continue;
    if (!context.is_file) {
      report.notes.push_back(core::joined({"material library '", line, "': not read, as text has no folder"}));
      add(line, false);
      continue;
    }
    using result = material_library_reader::result;
    if (const result whole = read(line); whole != result::absent) {
      add(line, whole == result::read);
      continue;
    }
    missing.clear();
    bool any = false;
    for (std::size_t at = 0; at < line.size();) {  // a name may contain blanks, and a line several names
      const std::size_t end = std::min(line.find(' ', at), line.size());
      if (end > at) {
        const std::string name = line.substr(at, end - at);
        const result part = read(name);
        any = any || part != result::absent;
        if (part != result::absent) {
          add(name, part == result::read);
        } else {
          missing.push_back(name);
          report.notes.push_back(
              core::joined({"material library '", name, "': there is no such file beside this one"}));
        }
      }
      at = end + 1;
    }
    if (!any) add(line, false);
    else
      for (const std::string& name : missing) add(name, false);
  }
  if (library.num_redefined)
    report.notes.push_back(
        core::joined({library.num_redefined, " materials have several definitions: the first one is used; '",
                      library.redefined, "'"}));
}

/// Sets the materials and colours of the polys from the libraries that a file names. Materials that a writer has
/// created only for a colour lose their names.
inline void assign_materials(const read_context& context, const std::vector<std::string>& lines, std::size_t polys,
                             file_contents& contents) {
  load_report& report = *context.report;
  material_library library;
  read_libraries(context, lines, library);
  if (library.num_textures)
    report.skipped.push_back(core::joined({library.num_textures, " textures of materials (map_Kd and the like)"}));
  bool any = false;
  name_table missing;  // they are reported in one note
  contents.materials.for_each(polys, [&](std::size_t, std::size_t, std::string_view name) {
    const bool known = library.names.find(name) != name_table::none;
    any = any || known;
    if (!known && !name.empty()) missing.add(name);
  });
  if (any && missing.size() > 0) {
    std::size_t first = 0;  // the alphabetically first
    for (std::size_t i = 1; i < missing.size(); ++i)
      if (std::string_view(missing[i]) < missing[first]) first = i;
    report.notes.push_back(core::joined(
        {missing.size(), " materials have no colour in a library and become white; '", missing[first], "'"}));
  }
  if (any) {
    contents.poly_colors.resize(polys);
    contents.materials.for_each(polys, [&](std::size_t p, std::size_t end, std::string_view name) {
      const std::size_t color = library.names.find(name);
      if (color == name_table::none) return;
      for (; p != end; ++p) contents.poly_colors[p] = library.colors[color];
    });
  }
  std::vector<material>& materials = library.table.materials;
  std::vector<unsigned char> is_color(materials.size());
  int ignored = 0;
  contents.materials.rename([&](std::string_view name) {
    const std::size_t i = library.all.find(name);
    if (i == name_table::none || !is_number(name, "color_", ignored) || !is_only_color(materials[i]))
      return std::string(name);
    is_color[i] = 1;
    return std::string();
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (!is_color[i]) {
      if (kept != i) materials[kept] = std::move(materials[i]);
      ++kept;
    }
  materials.resize(kept);
  if (kept > 0 || !library.table.unread.empty()) contents.table = std::move(library.table);
}

}  // namespace concino::detail
