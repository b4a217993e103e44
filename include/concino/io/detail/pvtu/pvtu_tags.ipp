// Bodies of pvtu_tags.hpp: lists the pieces and the arrays that a .pvtu file names.
#pragma once

#include <concino/io/detail/pvtu/pvtu_tags.hpp>

#include <algorithm>
#include <string_view>

namespace concino::detail {

CONCINO_INLINE bool stays_in_folder(std::string_view path) {
  if (path.empty() || path.starts_with('/') || path.find_first_of(std::string_view(":\0", 2)) != path.npos)
    return false;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (path.substr(0, end) == "..") return false;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return true;
}

CONCINO_INLINE void pvtu_tags::read() {
  read_elements([&](const xml_tag& tag) { file(tag); },
                [&](const xml_tag& tag) {
                  begin(tag);
                  return true;
                },
                [&](std::string_view element) {
                  if (element == "PPointData" || element == "PCellData") part_ = vtk_xml_part::none;
                });
  if (!in_grid_) fail(end(), "<PUnstructuredGrid>");
}

CONCINO_INLINE void pvtu_tags::file(const xml_tag& tag) const {
  const std::string type = text_of(tag, "type");
  if (type != "PUnstructuredGrid")
    core::throw_joined<unsupported>(
        {name(), ": type=\"", std::string_view(type).substr(0, 40), "\" is not supported; PUnstructuredGrid is"});
}

CONCINO_INLINE void pvtu_tags::begin(const xml_tag& tag) {
  if (tag.name == "PUnstructuredGrid") {
    in_grid_ = true;
  } else if (tag.name == "Piece") {
    piece(tag);
  } else if (tag.name == "PPointData" || tag.name == "PCellData") {
    const bool of_points = tag.name == "PPointData";
    (of_points ? index_.global_point_ids : index_.global_cell_ids) = text_of(tag, "GlobalIds");
    if (!tag.ends) part_ = of_points ? vtk_xml_part::of_points : vtk_xml_part::of_cells;
  } else if (part_ != vtk_xml_part::none && (tag.name == "PDataArray" || tag.name == "DataArray")) {
    array(tag);
  }
}

CONCINO_INLINE void pvtu_tags::piece(const xml_tag& tag) {
  if (!in_grid_) fail(tag.at, "<PUnstructuredGrid> before a piece");
  pvtu_piece p{tag.at, text_of(tag, "Source")};
  std::replace(p.source.begin(), p.source.end(), '\\', '/');
  if (!stays_in_folder(p.source))
    fail(tag.at, {"Source, the path of a piece in the folder of this file or below it"},
         {"'", std::string_view(p.source).substr(0, 80), "'"});
  if (const std::size_t known = sources_.add(p.source); known < index_.pieces.size())
    fail(tag.at, {"another piece than on line ", line_of(index_.pieces[known].at)}, {"'", p.source, "' again"});
  index_.pieces.push_back(std::move(p));
}

CONCINO_INLINE void pvtu_tags::array(const xml_tag& tag) {
  pvtu_array a{tag.at, part_, text_of(tag, "Name"), vtk_number::none, 1};
  const std::string type = text_of(tag, "type");
  a.type = vtk_number_of_xml(type);
  a.components = std::max<std::uint64_t>(1, number_of(tag, "NumberOfComponents", 1));
  if (type == "String" || type == "Bit") return;  // the reader of the pieces says that it skips them
  if (a.type == vtk_number::none)
    fail(tag.at, {"a type of numbers, such as Float64 or Int32"}, {"'", std::string_view(type).substr(0, 40), "'"});
  index_.arrays.push_back(std::move(a));
}

}  // namespace concino::detail
