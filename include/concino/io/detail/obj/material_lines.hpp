// Lines of material libraries as they are saved, and of .obj files that name libraries.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/obj/read_mtl.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/io/write_context.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// A name in the form that a line of a file can hold. Sets `changed` if it differs.
inline std::string line_name(std::string name, bool& changed) {
  const auto hide = [&](char& c) {
    c = '_';
    changed = true;
  };
  for (std::size_t i = 0; i < name.size(); ++i)
    if (static_cast<unsigned char>(name[i]) < 32 || name[i] == '\\' ||
        (name[i] == '#' && (i == 0 || name[i - 1] == ' ')))
      hide(name[i]);
  if (!name.empty() && name.front() == ' ') hide(name.front());
  if (!name.empty() && name.back() == ' ') hide(name.back());
  return name;
}

/// A line of a material in the form that a library can hold. It is empty if there is none, because the line is blank or
/// begins another material.
inline std::string library_line(std::string line) {
  for (char& c : line)
    if (is_line_end(c)) c = ' ';
  while (!line.empty() && is_blank(line.back())) line.pop_back();
  const auto first = std::find_if(line.begin(), line.end(), [](char c) { return !is_blank(c); });
  line.erase(line.begin(), first);
  if (std::string_view(line).substr(0, line.find_first_of(" \t\v\f")) == "newmtl") line.clear();
  return line;
}

/// The first line of a library that save writes. By its checksum a later save knows whether the text has been changed.
/// `file` is the .obj file.
inline std::string signature_of(std::string_view file, std::string_view text) {
  return core::joined({signature_begins, file, signature_goes_on, core::hash_text(text), "\n"});
}

/// The lines of an .obj file that name libraries, without the keyword; none if the file does not exist. Reads it in
/// pieces, as it may be large.
/// Errors: io_error.
inline std::vector<std::string> library_lines(const std::string& path, std::size_t piece = 1 << 18) {
  std::vector<std::string> lines;
  const open_file file(open_to_read(path));
  if (!file.is_open() && errno == ENOENT) return lines;
  if (!file.is_open()) throw_io_error(path, "cannot be opened", errno);
  std::string buffer(piece, '\0');
  for (std::size_t kept = 0;;) {
    if (kept == buffer.size()) buffer.resize(2 * kept);
    const std::ptrdiff_t n = read_some(file.handle(), buffer.data() + kept, buffer.size() - kept);
    if (n < 0) throw_io_error(path, "cannot be read", errno);
    const std::string_view text(buffer.data(), kept + static_cast<std::size_t>(n));
    const std::size_t complete = n == 0 ? text.size() : text.find_last_of("\r\n") + 1;  // whole lines
    constexpr std::string_view keyword = "mtllib";
    for (std::size_t at = 0; (at = text.find(keyword, at)) < complete;) {
      at += keyword.size();
      const std::size_t end = std::min(text.find_first_of("\r\n", at), complete);
      lines.push_back(std::string(text.substr(at, end - at)));
      at = end;
    }
    if (n == 0) return lines;
    kept = text.size() - complete;
    std::memmove(buffer.data(), buffer.data() + complete, kept);
  }
}

}  // namespace concino::detail
