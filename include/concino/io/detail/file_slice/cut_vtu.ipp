// Bodies of file_slice.hpp: cuts slices out of binary .vtu files.
#pragma once

#include <concino/io/detail/file_slice/vtu_slice_cells.hpp>

#include <bit>
#include <utility>

namespace concino::detail {

/// Writes one slice. The tags of the new file are on the lines of those of the old one, so that errors of the reader
/// name these.
class vtu_cutter : vtu_slice_cells {
  std::vector<const vtk_xml_entry*> arrays_;  // of the slice, in the order of the file
  std::uint64_t offset_ = 0;
  std::size_t line_ = 1;

 public:
  vtu_cutter(const read_context& in, file_slice& out) : vtu_slice_cells(in, out) {}

  void cut(slice_choice choice) {
    read(choice);
    for (const vtk_xml_entry& e : index_.entries)
      if (e.part == vtk_xml_part::cells ? has_list(e.array.name) : has_values(e)) arrays_.push_back(&e);
    write_tags();
    out_.text.reserve(out_.text.size() + offset_);
    for (const vtk_xml_entry* const e : arrays_) {
      if (e->part == vtk_xml_part::cells) append_list(e->array.name);
      else append_values(*e);
    }
  }

 private:
  bool has_list(std::string_view name) const {
    if (name == "connectivity" || name == "offsets" || name == "types") return num_cells_ > 0;
    return (name == "faces" || name == "faceoffsets") && !face_ends_.empty();
  }
  /// The type and the bytes of a list of the cells.
  std::pair<vtk_number, std::string_view> list(std::string_view name) const {
    const auto bytes_of = [](const auto& all) {
      return std::string_view(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(all[0]));
    };
    if (name == "types") return {vtk_number::uint8, types_};
    if (name == "faceoffsets") return {vtk_number::int64, bytes_of(face_ends_)};
    return {vtk_number::uint32, bytes_of(name == "connectivity" ? connectivity_ : name == "offsets" ? ends_ : faces_)};
  }

  /// Whether the file has as many values as elements. Reports the array as skipped if not. Errors: parse_error for
  /// points of another number.
  bool has_values(const vtk_xml_entry& e) {
    if (e.part != vtk_xml_part::points && e.part != vtk_xml_part::of_points && e.part != vtk_xml_part::of_cells &&
        e.part != vtk_xml_part::of_mesh)
      return false;
    const std::uint64_t n = e.part == vtk_xml_part::of_mesh    ? e.array.tuples
                            : e.part == vtk_xml_part::of_cells ? piece_->cells
                                                               : piece_->points;
    if (e.part == vtk_xml_part::points) require_numbers(e.array, 3 * n);
    const std::uint64_t found = count_numbers(e.array);
    if (n == found / e.array.components && found % e.array.components == 0) return true;
    out_.report.skipped.push_back(core::joined({"array \"", e.array.name, "\" of ", found, " numbers, where ", n,
                                                " values of ", e.array.components, " are needed"}));
    return false;
  }
  /// The values that an array has for the elements of the slice.
  std::uint64_t num_values(const vtk_xml_entry& e) const {
    return e.part == vtk_xml_part::of_mesh    ? e.array.tuples
           : e.part == vtk_xml_part::of_cells ? num_cells_
                                              : out_.verts.size();
  }

  /// Writes on the line of a tag of the whole file, or behind it.
  void tag(const char* place, core::message text) {
    for (const std::size_t line = line_of(place); line_ < line; ++line_) out_.text += '\n';
    out_.text += core::joined(text);
  }
  void write_tags() {
    constexpr bool is_little = std::endian::native == std::endian::little;
    const char* place = text_cursor::begin();
    tag(place, {"<VTKFile type=\"UnstructuredGrid\" byte_order=\"", is_little ? "Little" : "Big",
             "Endian\" header_type=\"UInt64\"><UnstructuredGrid>"});
    bool in_piece = false;
    vtk_xml_part part = vtk_xml_part::none;
    const auto begin_part = [&](vtk_xml_part next) {
      if (next == part) return;
      if (part != vtk_xml_part::none) tag(place, {"</", element_of(part), ">"});
      if (!in_piece && next != vtk_xml_part::of_mesh) {
        tag(piece_->at, {"<Piece NumberOfPoints=\"", out_.verts.size(), "\" NumberOfCells=\"", num_cells_, "\">"});
        in_piece = true;
      }
      part = next;
      if (part != vtk_xml_part::none) tag(place, {"<", element_of(part), attributes_of(part), ">"});
    };
    for (const vtk_xml_entry* const e : arrays_) {
      begin_part(e->part);
      place = e->array.at;
      array_tag(*e);
    }
    begin_part(vtk_xml_part::none);
    tag(place, {in_piece ? "</Piece>" : "", "</UnstructuredGrid><AppendedData encoding=\"raw\">_"});
  }
  void array_tag(const vtk_xml_entry& e) {
    const vtk_xml_array& a = e.array;
    const bool is_list = e.part == vtk_xml_part::cells;
    const vtk_number type = is_list ? list(a.name).first : a.type;
    const std::uint64_t bytes = is_list ? list(a.name).second.size() : num_values(e) * a.components * size_of(a);
    tag(a.at, {"<DataArray type=\"", vtk_names_of(type).xml, "\" Name=\"", xml_text(a.name), "\" NumberOfComponents=\"",
               a.components, "\" NumberOfTuples=\"", a.tuples, "\" format=\"appended\" offset=\"", offset_, "\"/>"});
    offset_ += 8 + bytes;
  }
  static const char* element_of(vtk_xml_part part) {
    return part == vtk_xml_part::of_mesh     ? "FieldData"
           : part == vtk_xml_part::of_points ? "PointData"
           : part == vtk_xml_part::points    ? "Points"
           : part == vtk_xml_part::of_cells  ? "CellData"
                                             : "Cells";
  }
  std::string attributes_of(vtk_xml_part part) const {
    const auto attribute = [](const char* name, const std::string& value) {
      return value.empty() ? value : core::joined({" ", name, "=\"", xml_text(value), "\""});
    };
    if (part == vtk_xml_part::of_cells) return attribute("GlobalIds", index_.global_cell_ids);
    if (part != vtk_xml_part::of_points) return {};
    return core::joined({attribute("Normals", index_.normals), attribute("TCoords", index_.textures),
                         attribute("GlobalIds", index_.global_point_ids)});
  }

  void header(std::uint64_t bytes) { out_.text.append(reinterpret_cast<const char*>(&bytes), 8); }
  void append_list(std::string_view name) {
    const std::string_view bytes = list(name).second;
    header(bytes.size());
    out_.text += bytes;
  }
  void append_values(const vtk_xml_entry& e) {
    const std::uint64_t k = e.array.components;
    const std::size_t bytes = k * size_of(e.array);
    header(num_values(e) * bytes);
    const auto append = [&](std::uint64_t first, std::uint64_t count, std::string& to) {
      append_numbers(e.array, size_of(e.array), first * k, count * k, to);
    };
    if (e.part == vtk_xml_part::of_mesh) return append(0, e.array.tuples, out_.text);
    if (e.part == vtk_xml_part::of_cells) {
      for (const run& r : cells_) append(r.first, r.count, out_.text);
      return;
    }
    std::size_t next = 0;  // of the verts of the slice
    std::string some;
    for (const run& r : points_)
      for (std::uint64_t first = r.first, count; first < r.first + r.count; first += count) {
        count = std::min<std::uint64_t>(1 << 14, r.first + r.count - first);
        some.clear();
        append(first, count, some);
        for (; next < out_.verts.size() && out_.verts[next] < first + count; ++next)
          out_.text.append(some, (out_.verts[next] - first) * bytes, bytes);
      }
  }
};

CONCINO_INLINE void cut_vtu(std::string_view text, const std::string& path, slice_choice choice,
                            inflate_function inflate, file_slice& out) {
  load_report unused;
  const concino::progress none;
  const read_context in{text, path, {}, &unused, &none, true, inflate};
  vtu_cutter(in, out).cut(choice);
}

}  // namespace concino::detail
