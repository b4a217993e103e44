// The result of repair: what was done and what is left, as typed records and as sentences.
#pragma once

#include <concino/mesh/element_origins.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino {

/// What repair did, or left. The elements of a record are indices in the mesh before, of verts or polys.
enum class repair_kind : std::uint8_t {
  merged_verts,          // verts that became one with others
  collapsed_corners,     // polys that lost corners because verts were merged
  removed_degenerate,    // polys without area or volume that were removed
  collapsed_degenerate,  // triangles without area that were collapsed
  removed_duplicates,    // polys with the same verts as earlier ones
  removed_intersecting,  // polys that intersected others
  split_verts,           // verts of several fans, or at edges of several polys
  turned_polys,          // polys that are wound the other way now
  filled_holes,          // holes: a vert of each
  united_faces,          // faces that have become one with others: a vert of each
  removed_verts,         // verts without polys
  removed_faces,         // faces without polys: a vert of each
  // left
  degenerate,     // triangles without area
  one_sided,      // components that cannot be oriented: a poly of each
  left_hole,      // holes that could not be filled: a vert of each
  intersecting,   // polys that intersect others
  open_cell,      // polyhedra with missing faces
  inverted_cell,  // cells of negative volume that are wound like their neighbours
};
inline constexpr std::size_t num_repair_kinds = 18;

/// Whether a kind is of what repair leaves, rather than of what it does.
/// Needs:  one of the kinds above.      Result: true for the last six.      Cost: O(1).      Errors: none.
constexpr bool is_left(repair_kind kind) { return kind >= repair_kind::degenerate; }

struct repair_record {
  repair_kind kind;
  std::vector<std::uint32_t> elements;  // indices in the mesh before
  std::string what;                     // a sentence

  std::size_t count() const { return elements.size(); }
};

/// for (auto& what : fix.done) fmt::print("{}\n", what);
struct repair_result {
  std::vector<std::string> done;       // a sentence for each kind of change; empty: the mesh is as it was
  std::vector<std::string> left;       // what was to be mended and is left, and why
  std::vector<repair_record> records;  // the same, typed: at most one of each kind, but one for each open cell
  concino::correspondence from;        // the verts and polys of the mesh before of which those of the mesh were made;
                                       // elements without origin fill holes

  /// How many elements the records of this kind have.
  std::size_t count(repair_kind kind) const {
    std::size_t n = 0;
    for (const repair_record& r : records) n += r.kind == kind ? r.count() : 0;
    return n;
  }
};

}  // namespace concino
