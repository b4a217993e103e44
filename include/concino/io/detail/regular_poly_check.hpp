// Checks whether a polyhedron is regular, without sorting and hashing.
#pragma once

#include <concino/core/temporary_array.hpp>
#include <concino/mesh/arrays.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

namespace concino::detail {

/// Checks whether a polyhedron is regular, as nearly all are: it has few different faces of different verts, which are consistently oriented and close
/// it, and its volume is positive. Its verts are numbered from 0, so that the verts that follow one in some face are the bits of a word: no sorting,
/// no hashing.
template<class Vert>  // vert_id, as in face_merger
class regular_poly_check {
  static constexpr std::uint32_t max_verts = 64, max_faces = 64, stamp_step = 2 * max_verts;
  typedef float float4 __attribute__((vector_size(16)));  // with operators for each of its numbers
  typedef double double4 __attribute__((vector_size(32)));
  typedef std::uint32_t uint4 __attribute__((vector_size(16)));
  static constexpr std::array<double, max_verts + 1> reciprocal = [] {
    std::array<double, max_verts + 1> x{};
    for (std::uint32_t n = 1; n <= max_verts; ++n) x[n] = 1.0 / n;
    return x;
  }();

 public:
  struct face {
    const Vert* verts;
    std::uint32_t size, smallest;
    std::uint32_t sum;  // of the verts and their number
  };

 private:
  struct vert_of_poly {
    float4 xyz, yzx;               // its point, from the first vert
    std::uint64_t bit;             // of the words below
    std::uint64_t next, previous;  // the verts behind and before it in all faces
    std::uint64_t unused;          // so that the size is a power of two
  };
  std::span<const vec3> points_;
  core::temporary_array<std::uint32_t> numbers_;  // of verts, plus the stamp of the last poly that had them
  std::uint32_t stamp_ = 0, num_faces_ = 0, num_verts_ = 0;
  double scale_ = 0;                    // to a box of about size 1; 0 if volumes may overflow or underflow
  double volume_ = 0;                   // of the scaled poly, six times
  std::uint64_t error_ = 0;             // of the volume, by rounding, in a unit that depends on the size of the poly
  face faces_[max_faces];
  std::uint32_t sums_[2 * max_faces];
  vert_of_poly verts_[2 * max_verts];

  void begin_vert(std::uint32_t number, const vec3& point, const double4& origin) {
    const double4 p = {point.x, point.y, point.z, 0};
    vert_of_poly& v = verts_[number];
    v.xyz = __builtin_convertvector((p - origin) * scale_, float4);
    v.yzx = __builtin_shufflevector(v.xyz, v.xyz, 1, 2, 0, 3);
    v.bit = std::uint64_t{1} << number % max_verts;
    v.next = v.previous = 0;
  }

  /// Lists the faces of a poly, numbers its verts, lists the neighbours of each and computes the volume. Result: false if the poly is too large, or
  /// if a face has a vert twice or two faces an edge in the same direction.
  bool list_faces(const Vert* v) {
    const std::uint32_t stamp = stamp_;
    const vec3& first_point = points_[v[1].raw()];
    const double4 origin = {first_point.x, first_point.y, first_point.z, 0};
    std::uint32_t k = 0, num_verts = 0;
    std::uint64_t repeated = 0, error = 0;
    double volume = 0;
    const auto find = [&](Vert vert) {
      std::uint32_t number = numbers_[vert.raw()] - stamp;  // huge if it has none
      if (number >= stamp_step) {
        number = num_verts++;
        numbers_[vert.raw()] = stamp + number;
        begin_vert(number, points_[vert.raw()], origin);
      }
      return verts_ + number;
    };
    for (; k < num_faces_ && num_verts <= max_verts; ++k) {
      const std::uint32_t n = v++->raw();
      if (n < 3 || n > max_verts) break;
      const Vert* const end = v + n;
      const Vert* const begin = v;
      std::uint32_t smallest = v->raw(), sum = n + smallest;
      vert_of_poly* const first = find(*v);
      vert_of_poly* from = first;
      std::uint64_t verts = first->bit;
      float4 a = from->xyz, turned_a = from->yzx, sum_of_points = a, area = {};  // the doubled area, as z, x, y
      const auto edge = [&](vert_of_poly* to) {
        repeated |= from->next & to->bit;
        from->next |= to->bit;
        to->previous |= from->bit;
        const float4 b = to->xyz, turned_b = to->yzx;
        area += a * turned_b - turned_a * b;
        a = b, turned_a = turned_b, from = to;
      };
      ++v;
      do {
        vert_of_poly* const to = find(*v);
        smallest = std::min(smallest, v->raw());
        sum += v->raw();
        repeated |= verts & to->bit;
        verts |= to->bit;
        edge(to);
        sum_of_points += a;
      } while (++v != end);
      edge(first);
      volume += static_cast<double>(sum_of_points[0] * area[1] + sum_of_points[1] * area[2] + sum_of_points[2] * area[0]) * reciprocal[n];
      error += n * (n + 4);
      faces_[k] = {begin, n, smallest, sums_[k] = sum};
    }
    num_verts_ = num_verts;
    volume_ = volume;
    error_ = error;
    return k == num_faces_ && num_verts <= max_verts && !repeated;
  }

  /// Whether the faces close the poly, and its volume is positive without doubt.
  bool is_oriented() const {
    float4 size = {};
    bool is_closed = true;
    for (std::uint32_t i = 0; i < num_verts_; ++i) {
      const vert_of_poly& v = verts_[i];
      is_closed &= v.next == v.previous;
      size = v.xyz * v.xyz > size ? v.xyz * v.xyz : size;
    }
    const double s = std::sqrt(std::max(std::max(size[0], size[1]), size[2]));
    return is_closed && s > 1e-8 && volume_ > 12 * 0x1p-24 * s * s * s * static_cast<double>(error_);
  }
  /// Whether two faces may have the same verts. Compares each sum with those that follow it, in a circle, at most half way round.
  bool has_equal_sums() {
    const std::uint32_t n = num_faces_;
    for (std::uint32_t i = n; i < n + n / 2 + 3; ++i) sums_[i] = sums_[i - n];
    uint4 equal = {};
    for (std::uint32_t d = 1; d <= n / 2; ++d)
      for (std::uint32_t i = 0; i < n; i += 4) {
        uint4 x, y;
        std::memcpy(&x, sums_ + i, sizeof x);
        std::memcpy(&y, sums_ + i + d, sizeof y);
        equal |= x == y;
      }
    return equal[0] | equal[1] | equal[2] | equal[3];
  }

 public:
  /// Needs: the points of all verts, as long as this exists.
  explicit regular_poly_check(std::span<const vec3> points) : points_(points), numbers_(points.size(), 0u) {
    vec3 size;
    for (const vec3& p : points)
      for (std::size_t i = 0; i < 3; ++i) size[i] = std::max(size[i], std::abs(p[i]));
    const double largest = std::max(std::max(size.x, size.y), size.z);
    if (largest > 1e-100 && largest < 1e100) scale_ = 1 / largest;
  }

  /// The faces of the last polyhedron, if it was regular.
  std::span<const face> faces() const { return {faces_, num_faces_}; }

  /// Needs: the number of faces, and for each the number of its verts and these.
  bool operator()(const Vert* list) {
    num_faces_ = list->raw();
    if (num_faces_ < 4 || num_faces_ > max_faces || list[1].raw() < 3) return false;
    if (stamp_ > ~0u - 2 * stamp_step) std::fill_n(numbers_.data(), points_.size(), stamp_ = 0);
    stamp_ += stamp_step;
    return list_faces(list + 1) && is_oriented() && !has_equal_sums();
  }
};

}  // namespace concino::detail
