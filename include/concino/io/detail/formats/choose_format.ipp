// Bodies of choose_format.hpp: chooses the format of a file among those that a call knows.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/formats/choose_format.hpp>

#include <bit>
#include <string>

namespace concino::detail {

/// Whether a path has an extension, in upper or lower case; `extension` is in lower case.
inline bool has_extension(std::string_view path, std::string_view extension) {
  if (path.size() <= extension.size()) return false;
  const std::string_view tail = path.substr(path.size() - extension.size());
  for (std::size_t i = 0; i < tail.size(); ++i)
    if ((tail[i] >= 'A' && tail[i] <= 'Z' ? static_cast<char>(tail[i] + ('a' - 'A')) : tail[i]) != extension[i])
      return false;
  return true;
}

CONCINO_INLINE bool ends_in_folder(std::string_view path, std::string_view name) {
  while (path.size() > 1 && path.back() == '/') path.remove_suffix(1);
  return path.ends_with(name) && (path.size() == name.size() || path[path.size() - name.size() - 1] == '/');
}

CONCINO_INLINE std::uint64_t formats_for(std::string_view path, format_id requested, format_rows known) {
  check_path(path);
  std::uint64_t found = 0;
  std::string all;
  const bool by_extension = requested == format_id();
  for (std::size_t i = 0; i < known.size; ++i) {
    const format_row& row = known.rows[i];
    if (!by_extension) {
      if (row.name == requested.name()) found |= std::uint64_t{1} << i;
      all = core::joined({all, all.empty() ? "" : ", ", row.name});
    } else {
      for (std::size_t k = 0; k < row.num_extensions; ++k) {
        if (row.is_folder ? ends_in_folder(path, row.extensions[k]) : has_extension(path, row.extensions[k]))
          found |= std::uint64_t{1} << i;
      }
    }
  }
  if (found != 0 || by_extension) return found;
  core::throw_joined<unsupported>({path, ": the format ", requested.name(), " is not among those of this call: ", all});
}

CONCINO_INLINE std::size_t choose_format(std::uint64_t candidates, format_rows known, const std::string_view* text) {
  const auto last = static_cast<std::size_t>(63 - std::countl_zero(candidates));
  if (!text || (candidates & (candidates - 1)) == 0) return last;
  for (std::size_t i = last + 1; i-- > 0;)
    if ((candidates >> i & 1) != 0 && known.rows[i].has_signature && known.rows[i].has_signature(*text)) return i;
  for (std::size_t i = last + 1; i-- > 0;)
    if ((candidates >> i & 1) != 0 && !known.rows[i].has_signature) return i;
  return last;
}

/// The extensions of all formats, or what their signatures look for.
inline std::string listed_in_message(format_rows known, bool signatures) {
  std::string all;
  for (std::size_t i = 0; i < known.size; ++i) {
    const format_row& row = known.rows[i];
    if (signatures && row.has_signature)
      all = core::joined({all, all.empty() ? "" : ", ", row.signature.empty() ? row.name : row.signature});
    for (std::size_t k = 0; !signatures && k < row.num_extensions; ++k)
      all = core::joined({all, all.empty() ? "" : ", ", row.extensions[k]});
  }
  return all;
}

CONCINO_INLINE std::uint64_t writable(std::string_view path, std::uint64_t candidates, format_rows known) {
  std::uint64_t left = 0;
  std::string_view refused;
  std::string others;
  for (std::size_t i = 0; i < known.size; ++i) {
    const format_row& row = known.rows[i];
    const bool is_candidate = (candidates >> i & 1) != 0;
    if (is_candidate && !row.is_read_only) left |= std::uint64_t{1} << i;
    if (is_candidate && row.is_read_only) refused = row.extensions[0];
    if (!row.is_read_only) others = core::joined({others, others.empty() ? "" : ", ", row.extensions[0]});
  }
  if (candidates == 0)
    core::throw_joined<unsupported>(
        {path, ": the extension is not that of a known format; known extensions: ", listed_in_message(known, false)});
  if (left == 0)
    core::throw_joined<unsupported>({path, path.empty() ? "" : ": ", refused, " can be read, but not written",
                                     others.empty() ? "" : "; formats that can be written: ", others});
  return left;
}

CONCINO_INLINE std::uint64_t readable(std::string_view path, std::uint64_t candidates, format_rows known) {
  std::uint64_t left = 0;
  std::string_view refused;
  std::string others;
  for (std::size_t i = 0; i < known.size; ++i) {
    const format_row& row = known.rows[i];
    const bool is_candidate = (candidates >> i & 1) != 0;
    if (is_candidate && !row.is_write_only) left |= std::uint64_t{1} << i;
    if (is_candidate && row.is_write_only) refused = row.extensions[0];
    if (!row.is_write_only) others = core::joined({others, others.empty() ? "" : ", ", row.extensions[0]});
  }
  if (candidates != 0 && left == 0)
    core::throw_joined<unsupported>({path, path.empty() ? "" : ": ", refused, " can be written, but not read",
                                     others.empty() ? "" : "; formats that can be read: ", others});
  return left;
}

CONCINO_INLINE std::size_t choose_by_text(std::string_view path, std::uint64_t candidates, format_rows known,
                                          std::string_view text, std::string& note) {
  const auto has_signature = [&](std::size_t i) {
    return known.rows[i].has_signature && !known.rows[i].is_write_only && known.rows[i].has_signature(text);
  };
  for (std::size_t i = known.size; i-- > 0;)
    if ((candidates >> i & 1) != 0 && has_signature(i)) return i;
  for (std::size_t i = known.size; i-- > 0;)
    if (has_signature(i)) {
      const format_row& row = known.rows[i];
      note = core::joined({"the extension is not ", row.extensions[0],
                           ", but the text begins like a file of that format, ", row.name, ", and was read as one"});
      return i;
    }
  if (candidates != 0) return choose_format(readable(path, candidates, known), known, &text);
  const std::string signatures = listed_in_message(known, true);
  core::throw_joined<unsupported>(
      {path, ": neither the extension nor the first words are those of a known format; known extensions: ",
       listed_in_message(known, false), signatures.empty() ? "" : "; known first words: ", signatures});
}

}  // namespace concino::detail
