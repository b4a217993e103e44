// Finds the points of the pieces of a .vtu or .vtp file that are one point.
#pragma once

#include <concino/io/detail/vtk/vtk_grid.hpp>
#include <concino/io/detail/vtk/vtk_numbers.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace concino::detail {

/// The values of the points of a grid, to compare them.
class vtk_point_values {
  struct value_column {
    const std::string* name;
    const unsigned char* values;
    vtk_property_type type;
    std::size_t size;  // of a value
  };
  std::vector<value_column> columns_;

 public:
  explicit vtk_point_values(const vtk_grid& grid) {
    for (const property_column& c : grid.columns)
      if (c.kind == element_kind::vert) {
        const value_type& type = c.values->operations();
        columns_.push_back(
            {&c.name, static_cast<const unsigned char*>(c.values->data()), vtk_type_of(*type.type), type.size});
      }
  }

  /// The first array in which two points have different values; null if there is none.
  const std::string* different_array(std::uint32_t a, std::uint32_t b) const {
    for (const value_column& c : columns_)
      if (!are_equal(c, c.values + a * c.size, c.values + b * c.size)) return c.name;
    return nullptr;
  }

 private:
  /// Whether two values consist of equal numbers. Not-a-number is equal to itself.
  static bool are_equal(const value_column& c, const unsigned char* a, const unsigned char* b) {
    return std::memcmp(a, b, c.size) == 0 ||
           (c.type.number == vtk_number::float64 && are_equal_reals<double>(c, a, b)) ||
           (c.type.number == vtk_number::float32 && are_equal_reals<float>(c, a, b));
  }
  template<class T>
  static bool are_equal_reals(const value_column& c, const unsigned char* a, const unsigned char* b) {
    for (std::size_t k = 0; k < c.size; k += sizeof(T)) {
      T x, y;
      std::memcpy(&x, a + k, sizeof x);
      std::memcpy(&y, b + k, sizeof y);
      if (x != y && (x == x || y == y)) return false;
    }
    return true;
  }
};

/// Points of different pieces become one if they are at the same place and have the same values. Where a piece has
/// several points, as on both sides of a crack, nothing says which of them is that of another piece: all points at this
/// place stay apart.
class vtk_point_merger {
  const std::vector<vec3>& points_;
  const std::vector<std::size_t>& first_point_;  // of each piece, and the end
  vtk_point_values values_;
  std::vector<std::uint32_t> same_;  // the first of the points with which each one is united
  std::uint32_t first_different_ = ~0u;

 public:
  std::vector<std::uint32_t> number, kept;  // of each point, its number among those that are kept; and these
  std::size_t num_different = 0;            // points at the place of a point of an earlier piece, which have other
                                            // values
  std::size_t num_coincident = 0;           // and those where a piece has several points
  const std::string* different = nullptr;   // the name of the first array with other values

  vtk_point_merger(const vtk_grid& grid, const std::vector<std::size_t>& first_point)
      : points_(grid.points), first_point_(first_point), values_(grid), same_(points_.size()) {
    std::vector<std::uint32_t> order(points_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = same_[i] = static_cast<std::uint32_t>(i);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const vec3 &p = points_[a], &q = points_[b];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : a < b;
    });
    for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
      for (end = begin + 1; end < order.size() && points_[order[end]] == points_[order[begin]];) ++end;
      if (end - begin > 1) unite(order.data() + begin, order.data() + end);
    }
    for (std::size_t i = 0; i < same_.size(); ++i) {
      if (same_[i] == i) kept.push_back(static_cast<std::uint32_t>(i));
      number.push_back(same_[i] == i ? static_cast<std::uint32_t>(kept.size() - 1) : number[same_[i]]);
    }
  }

 private:
  std::size_t piece_of(std::uint32_t point) const {
    return static_cast<std::size_t>(std::upper_bound(first_point_.begin(), first_point_.end(), point) -
                                    first_point_.begin());
  }

  /// Unites points at one place, which are in the order of the file.
  void unite(const std::uint32_t* begin, const std::uint32_t* end) {
    const std::size_t first_piece = piece_of(*begin);
    bool is_coincident = false;
    for (const std::uint32_t* i = begin + 1; i < end; ++i)
      is_coincident = is_coincident || piece_of(*i) == piece_of(i[-1]);
    for (const std::uint32_t* i = begin + 1; i < end; ++i) {
      if (is_coincident) {
        num_coincident += piece_of(*i) != first_piece;
        continue;
      }
      const std::string* other = nullptr;
      for (const std::uint32_t* k = begin; k < i && same_[*i] == *i; ++k)
        if (same_[*k] == *k && !(other = values_.different_array(*k, *i))) same_[*i] = *k;
      if (same_[*i] != *i) continue;
      ++num_different;
      if (*i < first_different_) first_different_ = *i, different = other;
    }
  }
};

}  // namespace concino::detail
