// Reads the elements of a PLY file, property by property.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/ply/ply_columns.hpp>

#include <cmath>
#include <cstring>
#include <vector>

namespace concino::detail {

inline constexpr polygon_words ply_words{"different verts at the corners of a face"};

class ply_rows : protected ply_cursor {
 protected:
  const wanted_mesh& wanted_;
  file_contents& out_;
  surface_arrays& surface_;
  std::uint64_t num_verts_ = 0;
  std::uint32_t arity_ = 0;
  std::vector<std::uint64_t> scratch_;
  std::vector<double> reals_;  // the list of the last element whose use is ply_use::reals

  ply_rows(const read_context& c, file_contents& out)
      : ply_cursor(c.text, c.name, c.progress, 0), wanted_(c.wanted), out_(out), surface_(out.surface) {}

  void skip_property(const ply_property& p) {
    const std::size_t n = p.is_list() ? take_length(p) : 1;
    if (binary_ && n > left() / vtk_names_of(p.type).size) reject(end(), {"more numbers"});
    skip_values(p.type, n);
    report_progress();
  }

  /// Reads the index of a vert, which is at least `least`, 0 or -1.
  std::int64_t next_vert(vtk_number type, std::int64_t least) {
    if (!binary_) skip();
    const char* const from = at;
    const std::int64_t v = take_integer(type);
    if (v >= least && v < static_cast<std::int64_t>(num_verts_)) return v;
    if (num_verts_ == 0) reject(from, {"no index of a vert, because there are no verts"}, {v});
    reject(from, {"the index of a vert from 0 to ", num_verts_ - 1}, {v});
  }

  /// Reads element i. The polys are added to the surface.
  void row(const std::vector<ply_column>& all, std::size_t i) {
    for (const ply_column& c : all) {
      unsigned char* const to = c.to ? c.to + i * c.stride : nullptr;
      const vtk_number type = c.property->type;
      const auto store = [&](const auto& x) { std::memcpy(to, &x, sizeof x); };
      switch (c.use) {
        case ply_use::skip: skip_property(*c.property); break;
        case ply_use::number: take(type, to, 1); break;
        case ply_use::coordinate: store(coordinate(type)); break;
        case ply_use::real: store(take_real(type)); break;
        case ply_use::part: store(part(type)); break;
        case ply_use::end: store(vert_id{static_cast<std::uint32_t>(next_vert(type, 0))}); break;
        case ply_use::list: list(*c.property, to); break;
        case ply_use::reals:
          reals_.resize(take_length(*c.property));
          for (double& x : reals_) x = take_real(type);
          break;
        case ply_use::corners: corners(*c.property); break;
      }
    }
  }

  /// Ends the poly whose corners begin at `first`.
  void end_poly_at(const char* position, std::size_t first) {
    end_checked_poly(*this, position, first, scratch_, wanted_, out_, arity_, ply_words);
  }

 private:
  double coordinate(vtk_number type) {
    if (!binary_) skip();
    const char* const from = at;
    const double x = take_real(type);
    if (!std::isfinite(x)) reject(from, {"a coordinate of a vert, a finite number"});
    return x;
  }
  /// A component of a colour: from 0 to 255 or 65535 if it is an integer, else from 0 to 1.
  float part(vtk_number type) {
    const double x = take_real(type);
    return static_cast<float>(type == vtk_number::uint16 || type == vtk_number::int16 ? x / 65535
                              : is_integer(type)                                      ? x / 255
                                                                                      : x);
  }
  void list(const ply_property& p, unsigned char* to) {
    const std::size_t n = take_length(p);
    with_number_type(p.type, [&]<class T>(std::type_identity<T>) {
      if constexpr (!std::is_same_v<T, bool>) {
        auto& values = *reinterpret_cast<std::vector<T>*>(to);
        values.resize(n);
        take(p.type, values.data(), n);
      }
    });
  }

  void corners(const ply_property& p) {
    if (!binary_) skip();
    const char* const from = at;
    const std::size_t n = take_length(p), first = surface_.verts.size();
    if (n < 3) reject(from, {"a face of at least three verts"}, {n});
    for (std::size_t k = 0; k < n; ++k)
      surface_.verts.push_back(vert_id{static_cast<std::uint32_t>(next_vert(p.type, 0))});
    end_poly_at(binary_ ? binary_line_ : from, first);
  }
};

}  // namespace concino::detail
