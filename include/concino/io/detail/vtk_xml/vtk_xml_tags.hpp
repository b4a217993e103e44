// Lists the arrays of a .vtu or .vtp file, in one pass over its tags.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_xml_data.hpp>
#include <concino/io/detail/vtk_xml/xml_elements.hpp>

namespace concino::detail {

/// The parts of a piece. The order of lists of cells is that of their values.
enum class vtk_xml_part : std::uint8_t {
  verts,
  lines,
  polys,
  strips,
  cells,
  points,
  of_points,
  of_cells,
  of_mesh,
  none
};

struct vtk_xml_piece {
  const char* at = nullptr;
  std::uint64_t points = 0, cells = 0;   // of an UnstructuredGrid
  std::uint64_t lists[4] = {};           // of PolyData: the numbers of verts, lines, polys, strips
  std::size_t first_entry = 0;           // of its arrays
};

/// An array, and where it belongs.
struct vtk_xml_entry {
  std::size_t piece;
  vtk_xml_part part;
  vtk_xml_array array;
  std::uint32_t next = ~0u;  // the entry of the same array in the next piece that has it
};

/// What the tags of a file say.
struct vtk_xml_index {
  bool is_polydata = false;
  vtk_xml_encoding encoding;
  std::vector<vtk_xml_piece> pieces;
  std::vector<vtk_xml_entry> entries;
  std::uint64_t num_texts = 0;           // arrays of texts
  std::vector<std::string> bit_arrays;   // the names of arrays of bits
  // the arrays that are named as such, of the first piece
  std::string normals, textures, global_point_ids, global_cell_ids;
};

class vtk_xml_tags : xml_elements {
  vtk_xml_index& index_;
  vtk_xml_part part_ = vtk_xml_part::none;
  bool in_grid_ = false;

 public:
  vtk_xml_tags(const read_context& in, vtk_xml_index& index) : xml_elements(in.text, in.name), index_(index) {}

  void read() {
    read_elements(
        [&](const xml_tag& tag) { file(tag); },
        [&](const xml_tag& tag) {
          const bool is_data = tag.name == "AppendedData";
          if (is_data) appended(tag);
          else begin(tag);
          return !is_data;
        },
        [&](std::string_view element) {
          if (part_of(element) != vtk_xml_part::none) part_ = vtk_xml_part::none;
        });
    if (!in_grid_) fail(end(), "<UnstructuredGrid> or <PolyData>");
  }

 private:
  void file(const xml_tag& tag) {
    const std::string type = text_of(tag, "type"), order = text_of(tag, "byte_order"),
                      header = text_of(tag, "header_type"), compressor = text_of(tag, "compressor");
    index_.is_polydata = type == "PolyData";
    if (!index_.is_polydata && type != "UnstructuredGrid")
      core::throw_joined<unsupported>({name(), ": type=\"", std::string_view(type).substr(0, 40),
                                       "\" is not supported; UnstructuredGrid and PolyData are"});
    if (!order.empty() && order != "LittleEndian" && order != "BigEndian")
      fail(tag.at, {"byte_order LittleEndian or BigEndian"}, {"'", std::string_view(order).substr(0, 40), "'"});
    index_.encoding.swapped = (order == "BigEndian") != (std::endian::native == std::endian::big);
    if (order.empty()) index_.encoding.swapped = false;
    if (!header.empty() && header != "UInt32" && header != "UInt64")
      fail(tag.at, {"header_type UInt32 or UInt64"}, {"'", std::string_view(header).substr(0, 40), "'"});
    index_.encoding.wide = header == "UInt64";
    index_.encoding.compressed = !compressor.empty();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      core::throw_joined<unsupported>(
          {name(), ": compressor ", std::string_view(compressor).substr(0, 40),
           " is not supported; vtkZLibDataCompressor is, and files that are not compressed"});
  }

  static vtk_xml_part part_of(std::string_view name) {
    constexpr std::string_view names[] = {"Verts",  "Lines",     "Polys",    "Strips",   "Cells",
                                          "Points", "PointData", "CellData", "FieldData"};
    for (unsigned i = 0; i < std::size(names); ++i)
      if (names[i] == name) return static_cast<vtk_xml_part>(i);
    return vtk_xml_part::none;
  }

  void begin(const xml_tag& tag) {
    if (tag.name == (index_.is_polydata ? "PolyData" : "UnstructuredGrid")) {
      in_grid_ = true;
    } else if (tag.name == "Piece") {
      if (!in_grid_) fail(tag.at, "<UnstructuredGrid> or <PolyData> before a piece");
      vtk_xml_piece piece;
      piece.at = tag.at;
      piece.first_entry = index_.entries.size();
      piece.points = number_of(tag, "NumberOfPoints", 0);
      piece.cells = number_of(tag, "NumberOfCells", 0);
      constexpr std::string_view lists[] = {"NumberOfVerts", "NumberOfLines", "NumberOfPolys", "NumberOfStrips"};
      for (unsigned i = 0; i < 4; ++i) piece.lists[i] = number_of(tag, lists[i], 0);
      index_.pieces.push_back(piece);
    } else if (const vtk_xml_part part = part_of(tag.name); part != vtk_xml_part::none) {
      if (!tag.ends) part_ = part;
      if (part == vtk_xml_part::of_points && index_.pieces.size() == 1) {
        index_.normals = text_of(tag, "Normals");
        index_.textures = text_of(tag, "TCoords");
        index_.global_point_ids = text_of(tag, "GlobalIds");
      }
      if (part == vtk_xml_part::of_cells && index_.pieces.size() == 1)
        index_.global_cell_ids = text_of(tag, "GlobalIds");
    } else if (tag.name == "DataArray" || tag.name == "Array") {
      if (part_ == vtk_xml_part::none || (index_.pieces.empty() && part_ != vtk_xml_part::of_mesh)) return;
      array(tag);
    }
  }

  void array(const xml_tag& tag) {
    vtk_xml_array a;
    a.at = tag.at;
    a.name = text_of(tag, "Name");
    const std::string type = text_of(tag, "type"), format = text_of(tag, "format");
    a.type = vtk_number_of_xml(type);
    if (tag.name == "Array" || type == "String") {
      ++index_.num_texts;
      return;
    }
    if (type == "Bit") {
      index_.bit_arrays.push_back(a.name);
      return;
    }
    if (a.type == vtk_number::none)
      fail(tag.at, {"a type of numbers, such as Float64 or Int32"}, {"'", std::string_view(type).substr(0, 40), "'"});
    a.components = std::max<std::uint64_t>(1, number_of(tag, "NumberOfComponents", 1));
    a.tuples = number_of(tag, "NumberOfTuples", 1);
    constexpr std::string_view formats[] = {"ascii", "binary", "appended"};
    for (const std::string_view known : formats)
      if (format == known) a.format = known;
    if (a.format.empty())
      fail(tag.at, {"format ascii, binary or appended"}, {"'", std::string_view(format).substr(0, 40), "'"});
    if (a.format == "appended") a.offset = number_of(tag, "offset", ~std::uint64_t{0});
    a.begin = at;
    a.end = at;
    if (!tag.ends) {
      const auto* const close = left() ? static_cast<const char*>(std::memchr(at, '<', left())) : nullptr;
      a.end = close ? close : end();
    }
    index_.entries.push_back({index_.pieces.empty() ? 0 : index_.pieces.size() - 1, part_, std::move(a), ~0u});
  }

  /// The rest of the file is data.
  void appended(const xml_tag& tag) {
    const std::string encoding = text_of(tag, "encoding");
    if (encoding != "raw" && encoding != "base64")
      fail(tag.at, {"encoding raw or base64"}, {"'", std::string_view(encoding).substr(0, 40), "'"});
    skip_space();
    if (at_end() || *at != '_') fail(tag.at, "_ at the beginning of AppendedData");
    index_.encoding.appended = at + 1;
    index_.encoding.base64_appended = encoding == "base64";
    if (!in_grid_) fail(tag.at, "<UnstructuredGrid> or <PolyData>");
  }
};

}  // namespace concino::detail
