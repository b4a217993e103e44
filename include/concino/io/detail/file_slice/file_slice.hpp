// Cuts slices out of binary mesh files: texts of files of their own, which the readers of the formats read.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/io/options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// One of n slices of the polys of a file, all of the same size but for one poly; or some verts without polys.
struct slice_choice {
  std::size_t slice = 0, num_slices = 1;
  const std::vector<std::uint64_t>* only_verts = nullptr;  // increasing numbers; null: a slice of polys

  /// The first poly of a slice, of so many polys.
  std::uint64_t first_of(std::size_t k, std::uint64_t polys) const {
    if (only_verts) return 0;
    return polys / num_slices * k + polys % num_slices * k / num_slices;
  }
  /// Errors: invalid_argument if the file has too few.
  const std::vector<std::uint64_t>& checked_verts(std::uint64_t num_verts) const {
    if (!only_verts->empty() && only_verts->back() >= num_verts)
      core::throw_joined<invalid_argument>(
          {"load_verts: there is no vert ", only_verts->back(), "; the file has ", num_verts});
    return *only_verts;
  }
};

/// The text of a file with one slice: polys first_poly, first_poly + 1, ... and their verts, both in the order of the
/// whole file.
struct file_slice {
  std::string text, name;  // the name is for messages
  bool is_medit = false;   // else it is a .vtu file
  std::uint64_t first_poly = 0, num_polys = 0, num_verts = 0;  // the latter are those of the whole file
  std::vector<std::uint64_t> verts;                            // the numbers of the verts in the whole file
  load_report report;                                          // what was skipped before the text is read

  std::size_t room = 1 << 16;  // verts are sorted when there are so many, as most are there several times

  void add_vert(std::uint64_t v) {
    verts.push_back(v);
    if (verts.size() < room) return;
    sort_verts();
    room = std::max(room, 2 * verts.size());
  }
  bool has(std::uint64_t v) const { return std::binary_search(verts.begin(), verts.end(), v); }
  /// The number in the slice of a vert that is there.
  std::uint64_t number_of(std::uint64_t v) const {
    return static_cast<std::uint64_t>(std::lower_bound(verts.begin(), verts.end(), v) - verts.begin());
  }
  /// Sorts the verts, and keeps each once.
  void sort_verts() {
    std::sort(verts.begin(), verts.end());
    verts.erase(std::unique(verts.begin(), verts.end()), verts.end());
  }
};

/// The slices of the text of a file in these formats. They fill the slice but for its name.
void cut_vtu(std::string_view text, const std::string& path, slice_choice choice, inflate_function inflate,
             file_slice& out);
void cut_medit(std::string_view text, const std::string& path, slice_choice choice, file_slice& out);

/// A slice of a file; see load_slice.
file_slice slice_of_file(const std::string& path, slice_choice choice, const load_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/file_slice/cut_medit.ipp>
#include <concino/io/detail/file_slice/cut_vtu.ipp>
#include <concino/io/detail/file_slice/file_slice.ipp>
#endif
