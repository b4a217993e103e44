// Cells that a level set cuts in the simplest way: in two parts, with one cap between them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/level_sets/detail/cell_surface.hpp>
#include <concino/level_sets/detail/part_lists.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// A cell is simple if none of its verts is on the level set, its surface is a sphere, its faces are simple, and its chords form one loop that does not lie
/// between two cells. A crossed face is simple if it has one chord, is convex and, on the boundary, planar. The parts of simple cells follow from the signs of
/// their verts. Other cells are difficult; they and the simple ones beside them are cut by cell_parts. Unusual cells make all cells difficult: if two faces have
/// the same verts or the same chord, if two edges have the same verts, or if more than two cells meet at a face.
class simple_cells {
 public:
  static constexpr std::uint32_t none = ~0u;

  struct face {
    std::uint32_t index;                      // in the mesh
    std::uint32_t first_corner, last_corner;  // in corners_
    std::uint32_t ends[2];                    // the corners before the two crossed edges
    std::uint32_t places[2];                  // of these edges
    std::uint32_t polys[2];                   // of a crossed face that is simple: their indices
    unsigned char num_difficult;              // cells
    bool is_crossed, is_simple, starts_above;
  };
  /// What the caller has read of one cell. Verts are numbered in the cell.
  struct cell_verts {
    std::vector<std::uint32_t> indices;
    std::vector<vec3> points;
    std::vector<unsigned char> above;

    void clear() { indices.clear(), points.clear(), above.clear(); }
  };

  /// number_of: an array with `none` for each face of the mesh, which has these values again when the cells are destroyed.
  explicit simple_cells(std::uint32_t* number_of) : number_of_(number_of) {}
  simple_cells(const simple_cells&) = delete;
  simple_cells& operator=(const simple_cells&) = delete;
  ~simple_cells() {
    for (const face& f : faces_) number_of_[f.index] = none;
  }

  /// Makes room for n cells.
  void reserve(std::size_t n);
  std::size_t num_cells() const { return cells_.size(); }
  bool is_convex(std::size_t i) const { return cells_[i].is_convex; }
  bool is_difficult(std::size_t i) const { return cells_[i].is_difficult; }
  /// The difficult cells, and the simple ones beside them.
  std::vector<std::uint32_t> cells_to_cut() const;

  /// Starts a cell. Its faces follow, then end_cell().
  void start_cell(bool is_difficult);
  /// The number of a face. It is that of a new face if is_new() is true; then its corners follow.
  std::uint32_t number_of_face(std::size_t index) {
    if (number_of_[index] == none) number_of_[index] = static_cast<std::uint32_t>(faces_.size());
    return number_of_[index];
  }
  bool is_new(std::uint32_t number) const { return number == faces_.size(); }
  void start_face(std::uint32_t index);
  void add_corner(std::uint32_t vert) { corners_.push_back(vert); }
  /// Reads the corners of a face, and finds the chord of a new one. Returns false if the cell is unusual.
  bool read_corners(std::uint32_t number, bool is_new, const cell_verts& verts);
  face& face_of(std::uint32_t number) { return faces_[number]; }
  /// The number of the vert before crossed edge k of the face that was read last, and of the one behind it.
  std::uint32_t before(unsigned k) const { return local_[faces_.back().ends[k]]; }
  std::uint32_t behind(unsigned k) const { return faces_.back().ends[k] + 1 < local_.size() ? local_[faces_.back().ends[k] + 1] : local_[0]; }
  /// Whether the corners of the face that was read last lie in a plane.
  bool is_planar(const cell_verts& verts);
  /// Sets the places and the polys of the face that was read last, a new one.
  void set_chord(std::uint32_t first_place, std::uint32_t second_place, std::uint32_t poly, std::uint32_t other_poly);
  /// Adds the face that was read last to the cell.
  void add_face(std::uint32_t number, bool outward, std::uint32_t poly, const cell_verts& verts);
  /// Whether two faces have the same verts or the same chord, after the last cell.
  bool has_equal_faces();
  /// Adds other cells behind these. places: by number of a place there, the number here.
  /// Result: the added cells with faces that are also here, by number there.
  std::vector<std::uint32_t> append(const simple_cells& others, std::span<const std::uint32_t> places);
  /// Ends a cell. All cells of a shape may be known to be spheres.
  void end_cell(bool is_known_sphere, std::size_t num_verts, std::size_t num_edges);

 private:
  friend class part_merger;

  struct cell {
    std::uint32_t first_entry, last_entry, first_cap, last_cap;
    bool starts_above, is_convex, is_difficult;
  };
  struct entry {
    std::uint32_t face;
    bool outward;
  };
  struct chord {
    std::uint32_t start, end;  // places
    std::uint32_t other;       // the poly behind the face, or none
  };

  std::uint32_t* number_of_;         // by index of a face in the mesh
  std::vector<std::uint64_t> keys_;  // of faces that are not crossed, and of chords
  std::vector<face> faces_;
  std::vector<std::uint32_t> corners_;  // indices of verts
  std::vector<cell> cells_;
  std::vector<entry> entries_;
  std::vector<std::uint32_t> caps_;  // places
  std::size_t num_crossed_ = 0, num_crossed_corners_ = 0;

  std::vector<std::uint32_t> local_;  // of the current face, by corner: numbers in the cell
  std::vector<vec3> points_;
  std::vector<chord> chords_;
  cell_surface surface_;

  std::uint64_t key_of(const face& f) const;
  void find_chord(face& f, const cell_verts& verts);
  std::vector<std::uint32_t> append_faces(const simple_cells& others, std::span<const std::uint32_t> places);
  void sort_entries(const cell& c);
  bool chain_chords();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/append_cells.ipp>
#include <concino/level_sets/detail/simple_cells.ipp>
#endif
