// Finds the folder of a mesh that is a folder of files.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/choose_format.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace concino::detail {

/// The folder that a format reads at a path: the path itself, if it has the row's file, or the row's folder inside of
/// it. Empty if neither has it.
std::string folder_to_read(const std::string& path, const format_row& row);

/// The folder that a format writes at a path: the row's folder inside of it if the path is that of a case, which is not
/// called as the row's folders are; else the path itself.
std::string folder_to_write(const std::string& path, const format_row& row);

inline constexpr std::size_t no_folder = ~std::size_t{0};

/// The format that reads the folder at a path, the last one among those that can; no_folder if the path is to be read
/// as a file. `folder` becomes the folder of the mesh. Candidates: the formats that the extension or the call names.
std::size_t choose_folder(const std::string& path, std::uint64_t candidates, bool by_extension, format_rows known,
                          std::string& folder);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/mesh_folder.ipp>
#endif
