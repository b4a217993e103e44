// Reads and writes fields of directions: .rosy, one direction of each vert or poly, and how many there are by symmetry.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/directions/direction_field.hpp>
#include <concino/directions/trivial_connection.hpp>
#include <concino/io/options.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// What a .rosy file holds: n directions of each element, of which one is stored. The others are that one, turned by
/// the n-ths of a full turn about the normal.
struct rosy {
  int symmetry = 4;           // n, 1 to 16
  std::vector<vec3> vectors;  // one of the directions of each element, of any length; in the order of verts(m) or
                              // polys(m)
};

/// Reads a .rosy file: the number of elements and n on the first line, then a vector on each line. For the field of
/// which some directions are those of the file, pass them to direction_field as `hard`.
/// Needs:  a file as save_rosy writes it; numbers may have any blanks and line ends between them.
/// Result: the vectors in the order of the file.      Cost: O(size of the file).
/// Errors: io_error if the file cannot be read. parse_error with the line if a number is no number or not finite, n is
///         not from 1 to 16, or there are more or fewer vectors than the first line says.
rosy load_rosy(const std::string& path);
/// Reads the same from a text in memory. Messages call it `name`.
/// Needs:  as load_rosy.      Result: as load_rosy.
/// Cost:   as load_rosy.      Errors: as load_rosy, except io_error.
rosy load_rosy_text(std::string_view text, std::string_view name = "text");

/// Writes a .rosy file. Of a field of direction_field it has the first direction at each vert, in the order of
/// verts(m); of one of trivial_connection that at each poly, in the order of polys(m).
/// Needs:  finite vectors.
/// Result: the complete file, which replaces an existing one; coordinates read back as the same numbers.
/// Cost:   O(vectors).
/// Errors: invalid_argument if a vector is not finite, or symmetry is not from 1 to 16. io_error.
void save_rosy(const rosy& r, const std::string& path, const file_options& options = {});
template<class M>
void save_rosy(const direction_field_result<M>& field, const std::string& path, const file_options& options = {}) {
  rosy r{field.symmetry(), {}};
  for (const vert_t<M> v : verts(field.mesh())) r.vectors.push_back(field.direction(v));
  save_rosy(r, path, options);
}
template<class M>
void save_rosy(const trivial_connection_result<M>& field, const std::string& path, const file_options& options = {}) {
  rosy r{field.symmetry(), {}};
  for (const poly_t<M> p : polys(field.mesh())) r.vectors.push_back(field.direction(p));
  save_rosy(r, path, options);
}

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/rosy/rosy.ipp>
#endif
