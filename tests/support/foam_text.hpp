// A polyMesh folder as one text, so that its files can be read and written in memory: each file follows a line @@<name>.
#pragma once

#include <concino/io/detail/openfoam/read_openfoam.hpp>
#include <concino/io/detail/openfoam/write_openfoam.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::testing {

/// The names and texts of files, in order.
using foam_files = std::vector<std::pair<std::string, std::string>>;

inline std::string joined_foam_files(const foam_files& files) {
  std::string text;
  for (const auto& [name, file] : files) text += "@@" + name + "\n" + file;
  return text;
}

/// The files that begin at lines @@<name> with a name of one of OpenFOAM's.
inline foam_files split_foam_files(std::string_view text) {
  foam_files files;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = text.find("@@", at);
    std::string found;
    if (next != text.npos)
      for (const char* const name : {"points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones", "pointZones"})
        if (text.substr(next + 2).starts_with(std::string(name) + "\n")) found = name;
    const std::size_t end = next == text.npos ? text.size() : found.empty() ? next + 2 : next;
    if (!files.empty()) files.back().second += text.substr(at, end - at);
    if (!found.empty()) files.emplace_back(found, "");
    at = found.empty() ? end : next + 3 + found.size();
  }
  return files;
}

/// The format openfoam with a text in place of a folder. Messages call a file <name of the text>/<name of the file>.
struct foam_text_format {
  static constexpr std::string_view name = "foam_text";
  static constexpr std::string_view extensions[] = {".foam_text"};
  static constexpr bool holds_surfaces = false, holds_volumes = true, has_binary = true, holds_faces = true;

  template<std::same_as<volume_contents> Contents>
  static void read(const read_context& in, Contents& out) {
    const foam_files files = split_foam_files(in.text);
    const auto source = [&](std::string_view file, bool is_needed, const auto& use) {
      for (const auto& [key, text] : files)
        if (key == file) {
          const std::unique_ptr<char[]> exact(new char[text.size()]);  // the memory ends at the end of the text
          std::copy(text.begin(), text.end(), exact.get());
          return use(std::string_view(exact.get(), text.size()), std::string_view(std::string(in.name) + "/" + key));
        }
      if (is_needed) core::throw_joined<unsupported>({in.name, "/", file, ": is missing"});
    };
    concino::detail::read_openfoam_files(source, in, out);
  }

  static void write(write_context& out, flat_mesh& m) {
    struct memory final : folder_sink {
      std::vector<std::pair<std::string, std::unique_ptr<text_sink>>> files;
      text_sink& file(std::string_view file_name) override {
        files.emplace_back(file_name, std::make_unique<text_sink>());
        return *files.back().second;
      }
      bool remove(std::string_view) override { return false; }
    } folder;
    out.folder = &folder;
    concino::detail::openfoam_writer(out, m).write();
    for (auto& [file_name, sink] : folder.files) out.out << "@@" << file_name << '\n' << std::move(*sink).release();
  }
};
static_assert(Format<foam_text_format>);

}  // namespace concino::testing
