// Bodies of mesh_folder.hpp: finds the folder of a mesh that is a folder of files.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/formats/mesh_folder.hpp>

#include <bit>

namespace concino::detail {

/// A path without slashes at its end.
inline std::string without_slash(const std::string& path) {
  std::string folder = with_slashes(path);
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return folder;
}

/// Whether a folder has the file of the row, perhaps compressed.
inline bool has_folder_file(const std::string& folder, const format_row& row) {
  for (const std::string_view ending : {"", ".gz"})
    if (status_of(core::joined({folder, "/", row.folder_file, ending})).kind == file_kind::regular) return true;
  return false;
}

CONCINO_INLINE std::string folder_to_read(const std::string& path, const format_row& row) {
  std::string folder = without_slash(path);
  if (has_folder_file(folder, row)) return folder;
  folder = core::joined({folder, "/", row.folder_in_case});
  return has_folder_file(folder, row) ? folder : std::string();
}

CONCINO_INLINE std::string folder_to_write(const std::string& path, const format_row& row) {
  std::string folder = without_slash(path);
  if (ends_in_folder(path, row.extensions[0]) || has_folder_file(folder, row)) return folder;
  const std::string_view first = row.folder_in_case.substr(0, row.folder_in_case.find('/'));
  if (first.empty() || status_of(core::joined({folder, "/", first})).kind != file_kind::folder) return folder;
  return core::joined({folder, "/", row.folder_in_case});
}

CONCINO_INLINE std::size_t choose_folder(const std::string& path, std::uint64_t candidates, bool by_extension,
                                         format_rows known, std::string& folder) {
  std::uint64_t folders = 0;
  for (std::size_t i = 0; i < known.size; ++i)
    if (known.rows[i].is_folder) folders |= std::uint64_t{1} << i;
  if (folders == 0) return no_folder;
  const std::uint64_t possible = candidates == 0 && by_extension ? folders : candidates & folders;
  for (std::size_t i = known.size; i-- > 0;)
    if ((possible >> i & 1) != 0 && !(folder = folder_to_read(path, known.rows[i])).empty()) return i;
  if (candidates == 0 || (candidates & ~folders) != 0) return no_folder;
  folder = without_slash(path);  // the reader says which file is missing
  return static_cast<std::size_t>(63 - std::countl_zero(candidates));
}

}  // namespace concino::detail
