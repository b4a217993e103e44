// The .mtl file of an .obj file that is saved. An existing library is never changed: a new one gets an unused name, and
// appears before the .obj file that names it. So the .obj file on disk finds its materials at any moment.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/obj/assign_materials.hpp>
#include <concino/io/detail/obj/material_lines.hpp>
#include <concino/io/detail/obj/read_mtl.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/io/write_context.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace concino::detail {

/// Stores the materials of an .obj file that is saved: finds existing libraries, or writes a new one.
class material_library_file final : public companion_files {
  struct old_library {
    std::string path;
    file_status status;
  };
  std::string obj_path_;
  std::string path_;    // the same with all links followed
  std::string folder_;  // with a slash, or empty
  std::string file_name_;
  bool sync_;
  std::optional<atomic_file> file_;
  std::vector<old_library> outdated_;  // written by earlier saves of this very file

  /// The name of a library: for a.obj they are a.mtl, a_1.mtl, a_2.mtl, ...
  std::string name_of(std::size_t attempt) const {
    const std::size_t dot = file_name_.rfind('.');
    const std::string tail = attempt == 0 ? std::string(".mtl") : core::joined({"_", attempt, ".mtl"});
    std::size_t size = std::min(dot == std::string::npos ? file_name_.size() : dot, 255 - tail.size());
    if (size < file_name_.size())
      while (size > 0 && (static_cast<unsigned char>(file_name_[size]) & 0xC0) == 0x80)
        --size;  // does not cut a UTF-8 character
    bool ignored = false;
    return core::joined({line_name(file_name_.substr(0, size), ignored), tail});
  }

  static bool contains_all(const material_library& library, const std::vector<material>& needed) {
    return std::all_of(needed.begin(), needed.end(), [&](const material& m) {
      const std::size_t i = library.all.find(m.name);
      return i != name_table::none && library.table.materials[i].lines == m.lines;
    });
  }

  /// Whether a line contains the name of that library, possibly among others.
  static bool names_library(std::string_view line, std::string_view name) {
    for (std::size_t i = 0; (i = line.find(name, i + 1)) != line.npos;)
      if (is_blank(line[i - 1]) || line[i - 1] == '/' || line[i - 1] == '\\') return true;
    return false;
  }

  bool is_made_by_save(std::string_view text) const {
    if (!text.starts_with(core::joined({signature_begins, file_name_, signature_goes_on}))) return false;
    const std::size_t end = text.find('\n');
    return end != text.npos && text.substr(0, end + 1) == signature_of(file_name_, text.substr(end + 1));
  }

  /// Whether the library of that name was written by an earlier save of this file and not changed since. If so, adds it
  /// to outdated_.
  bool add_if_outdated(std::string_view name) {
    const std::string path = core::joined({folder_, name});
    if (name.find('/') != name.npos || name.find('\0') != name.npos) return false;
    const file_status status = status_of_link(path);
    if (status.kind != file_kind::regular) return false;
    for (const old_library& o : outdated_)
      if (std::string_view(o.path) == path) return true;
    try {
      if (!is_made_by_save(file_text(path).text())) return false;
    } catch (const io_error&) {
      return false;
    }
    outdated_.push_back({path, status});
    return true;
  }

  void write(const std::string& path, const std::vector<std::string>& head, const std::vector<material>& materials) {
    text_sink body;
    for (const std::string& line : head)
      if (const std::string fit = library_line(line); !fit.empty()) body << fit << '\n';
    for (const material& m : materials) {
      body << "newmtl " << m.name << '\n';
      for (const std::string& line : m.lines) body << line << '\n';
    }
    const std::string text = std::move(body).release();
    file_.emplace(path, atomic_file_options{.sync = sync_, .must_be_new = true});
    text_sink out(file_->descriptor(), path);
    out << signature_of(file_name_, text) << text;
    out.flush();
    file_->finish();
  }

  /// Whether the libraries in `table` exist and still define all needed materials, with the same lines.
  bool defines_all(const material_table& table, const std::vector<material>& needed, load_report& unused_report) const {
    const concino::progress silent;
    const read_context beside{{}, obj_path_, {}, &unused_report, &silent, true};
    material_library library;
    read_libraries(beside, table.libraries, library);
    return contains_all(library, needed);
  }

  struct numbered_libraries {
    std::string found;   // the first library that defines all needed materials
    std::string unused;  // the first unused name
    std::string other;   // the first library before both that defines others
  };

  /// Checks name_of(0), name_of(1), ... up to the second unused name, and collects the outdated libraries among them.
  numbered_libraries find_numbered(const std::vector<material>& needed, const std::vector<std::string>& undefined,
                                   const std::vector<std::string>& old_lines, load_report& unused_report) {
    numbered_libraries r;
    for (std::size_t attempt = 0, num_free = 0; num_free < 2; ++attempt) {
      if (attempt == 1000)
        core::throw_joined<io_error>(
            {path_,
             ": 1000 material libraries of this name exist and hold other materials; remove them or save under another name"});
      const std::string name = name_of(attempt), path = core::joined({folder_, name});
      // an OBJ file called .mtl
      if (std::string_view(name) == std::string_view(path_).substr(folder_.size())) continue;
      if (status_of(path).kind == file_kind::none) {
        if (errno != ENOENT) throw_io_error(path, "cannot be written", errno);
        if (std::any_of(old_lines.begin(), old_lines.end(),
                        [&](const std::string& line) { return names_library(line, name); }))
          continue;  // the old .obj file must not find a library that was not written for it
        if (num_free++ == 0) r.unused = name;
        continue;
      }
      const file_text file(path);
      material_library library;
      read_mtl(file.text(), path, library, unused_report);
      const bool is_right = contains_all(library, needed) &&
                            std::none_of(undefined.begin(), undefined.end(),
                                         [&](const std::string& n) { return library.all.find(n) != name_table::none; });
      if (r.found.empty() && is_right) r.found = name;
      else if (!add_if_outdated(name) && r.found.empty() && r.unused.empty() && r.other.empty()) r.other = name;
    }
    return r;
  }

  /// Removes from outdated_ the libraries that the new file names again.
  void keep_named_again(const material_table& table) {
    std::erase_if(outdated_, [&](const old_library& o) {
      return std::find(table.unread.begin(), table.unread.end(), std::string_view(o.path).substr(folder_.size())) !=
             table.unread.end();
    });
  }

  static bool names_pictures(const std::vector<material>& materials) {
    return std::any_of(materials.begin(), materials.end(), [](const material& m) {
      return std::any_of(m.lines.begin(), m.lines.end(),
                         [](const std::string& line) { return line.starts_with("map_"); });
    });
  }

  void add_notes(const std::string& chosen, const std::string& other, bool leaves_pictures, save_report& report) const {
    if (!other.empty())
      report.notes.push_back(
          core::joined({"the materials are in ", chosen, ": ", other, " holds other materials and is unchanged"}));
    for (const old_library& o : outdated_)
      report.notes.push_back(core::joined({std::string_view(o.path).substr(folder_.size()),
                                           ", which an earlier save wrote for this file, is removed"}));
    if (leaves_pictures) report.notes.push_back("the textures of materials (map_Kd and the like) are not copied");
  }

 public:
  /// If the path is a link, a new library is written to the folder of the file that it refers to.
  material_library_file(const std::string& path, bool sync) : obj_path_(path), path_(resolve_links(path)), sync_(sync) {
    folder_ = path_.substr(0, path_.rfind('/') + 1);
    bool ignored = false;
    file_name_ = line_name(path_.substr(folder_.size()), ignored);
  }

  /// Finds libraries that define all `needed` materials with the same lines, or writes a new one, which gets its name
  /// in commit_with(). A library that is not in `table` must not define the materials in `undefined`.
  /// Result: the names for the mtllib lines.      Errors: io_error.
  std::vector<std::string> choose_or_write(const std::vector<material>& needed,
                                           const std::vector<std::string>& undefined,
                                           const material_table* table, save_report& report) {
    load_report unused_report;
    if (table && defines_all(*table, needed, unused_report)) return table->libraries;
    if (needed.empty()) return {};
    const std::vector<std::string> old_lines = library_lines(path_);
    const numbered_libraries numbered = find_numbered(needed, undefined, old_lines, unused_report);
    for (const std::string_view line : old_lines)
      if (const std::size_t first = line.find_first_not_of(" \t");
          first != line.npos && line.substr(first) != numbered.found)
        add_if_outdated(line.substr(first));
    if (table) keep_named_again(*table);
    const bool is_new = numbered.found.empty();
    const std::string& chosen = is_new ? numbered.unused : numbered.found;
    if (is_new) write(core::joined({folder_, chosen}), table ? table->head : std::vector<std::string>(), needed);
    add_notes(chosen, numbered.other, is_new && names_pictures(needed), report);
    std::vector<std::string> names = {chosen};
    if (table)
      for (const std::string& name : table->unread)
        if (name != chosen) names.push_back(name);
    return names;
  }

  /// Gives the library its name, then the .obj file; or neither. Then removes outdated libraries.
  /// Errors: io_error. Nothing has changed then, unless the only failure was to synchronise a folder with the disk.
  void commit_with(atomic_file& file) override {
    try {
      if (file_) file_->commit();
      file.commit();
    } catch (...) {
      if (file_ && file_->is_committed() && !file.is_committed()) file_->undo();
      throw;
    }
    for (const old_library& o : outdated_)
      if (status_of_link(o.path) == o.status) remove_file(o.path);
  }
};

}  // namespace concino::detail
