// Lists the pieces and the arrays that a .pvtu file names.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_tags.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Whether a path leads to a file in the folder where it begins, or below it.
bool stays_in_folder(std::string_view path);

/// An array that every piece has.
struct pvtu_array {
  const char* at = nullptr;  // its tag, for errors
  vtk_xml_part part = vtk_xml_part::none;  // of_points or of_cells
  std::string name;
  vtk_number type = vtk_number::none;
  std::uint64_t components = 1;
};

struct pvtu_piece {
  const char* at = nullptr;  // its tag, for errors
  std::string source;        // the path of its file, from the folder of the .pvtu file
};

struct pvtu_index {
  std::vector<pvtu_array> arrays;
  std::vector<pvtu_piece> pieces;
  std::string global_point_ids, global_cell_ids;  // the names of these arrays; empty if there are none
};

/// Reads the tags of a .pvtu file.
/// Errors: parse_error with the line of a wrong tag; unsupported for other types of files.
class pvtu_tags : xml_elements {
  pvtu_index& index_;
  name_table sources_;  // of the pieces
  vtk_xml_part part_ = vtk_xml_part::none;
  bool in_grid_ = false;

  void file(const xml_tag& tag) const;
  void begin(const xml_tag& tag);
  void piece(const xml_tag& tag);
  void array(const xml_tag& tag);

 public:
  pvtu_tags(const read_context& in, pvtu_index& index) : xml_elements(in.text, in.name), index_(index) {}
  void read();
  using xml_elements::fail, xml_elements::line_of;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/pvtu/pvtu_tags.ipp>
#endif
