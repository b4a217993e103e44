// Options and reports of load and save.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/format_id.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino {

/// What a reader changed or skipped. Each entry is one sentence.
struct load_report {
  std::size_t reoriented_polys = 0;  // cells whose verts were put into the standard order or whose faces were turned
                                     // outward
  std::vector<std::string> skipped;  // in the file, but not in the mesh
  std::vector<std::string> notes;    // anything else worth knowing
};

/// What a writer could not store in the format. Each entry is one sentence.
struct save_report {
  std::vector<std::string> lost;   // in the mesh, but not in the file
  std::vector<std::string> notes;  // anything else worth knowing
};

/// Decompresses zlib data: n bytes at `from` into `size` bytes at `to`. Returns false if they are not zlib data of
/// exactly this size. Several threads may call it at once.
using inflate_function = bool (*)(const unsigned char* from, std::size_t n, unsigned char* to, std::size_t size);

/// What readers do with polys that have a vert twice, which no mesh holds. Values of polys follow, and the report has
/// the number of such polys and the first one.
enum class repeated_verts : std::uint8_t {
  refuse,    // parse_error
  /// Equal neighbours in a polygon or face become one vert, and so do spikes (a vert between two equal ones): a quad
  /// with two equal corners becomes a triangle, such a hex a prism, pyramid, tet or other polyhedron. A polygon that
  /// still passes a vert twice, as at a bridge to a hole, becomes triangles, by polygon_triangulator. Polys without
  /// area or volume are skipped.
  collapse,
  skip       // these polys, and their values, are left out
};

struct load_options {
  format_id format = {};                   // one of the formats that the call knows; by default the first words of the
                                           // file or its extension
  concino::load_report* report = nullptr;  // unless null, cleared and then filled in
  concino::progress progress = {};         // called with the fraction of the file that has been read
  concino::profiler* profiler = nullptr;   // measures the call and its steps; load_obj and the like are "load"
  /// Maps the file into memory instead of reading it. Loading is about a tenth faster, but a file that shrinks
  /// meanwhile may terminate the program by SIGBUS; without `map` it cannot. In both cases a file whose size has
  /// changed at the end is an io_error.
  bool map = false;
  // what to do with polys that have a vert twice
  concino::repeated_verts repeated_verts = concino::repeated_verts::refuse;
  inflate_function inflate = nullptr;  // for compressed .vtu and .vtp: zlib_inflate of <concino/adapters/zlib.hpp>;
                                       // null: they are unsupported
  /// Reads elements of second and higher order, such as VTK's quadratic tets and MEDIT's TetrahedraP2, by their
  /// corners. Points that are only their other nodes are skipped, and the report says how many. Without this option
  /// such elements are unsupported.
  bool corners_only = false;
};

struct save_options {
  format_id format = {};                   // one of the formats that the call knows; by default the extension
                                           // determines it
  concino::save_report* report = nullptr;  // unless null, cleared and then filled in
  concino::progress progress = {};         // called with the fraction of the elements that have been written
  concino::profiler* profiler = nullptr;   // measures the call and its steps; save_obj and the like are "save"
  bool binary = false;                     // .off: 32-bit numbers, so coordinates are rounded to floats; .mesh: as
                                           // .meshb; unsupported by formats without a binary form
  bool as_triangles = false;               // .stl, .glb, .3mf: cuts polygons into triangles, which the report counts as
                                           // lost; otherwise they are unsupported
  bool as_boundary = false;                // of a volume, the boundary surface is written, by any format of surfaces;
                                           // the report counts the polys as lost. Surfaces are written as they are
  bool strict = false;                     // throws unsupported, before the file is touched, if anything would be lost;
                                           // costs a second pass
  bool sync = false;                       // the new data reaches the disk before it replaces a file; otherwise the
                                           // system decides when
};

/// Options of functions that write a file and have no other choices.
struct file_options {
  bool sync = false;  // as in save_options
};

}  // namespace concino
