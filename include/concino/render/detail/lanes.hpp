// Four numbers at once, by the vectors of the compilers: these do not vectorise such code themselves.
#pragma once

#include <cstdint>
#include <cstring>

namespace concino::detail {

using float4 [[gnu::vector_size(16)]] = float;
using int4 [[gnu::vector_size(16)]] = std::int32_t;
using double2 [[gnu::vector_size(16)]] = double;
using long2 [[gnu::vector_size(16)]] = std::int64_t;

inline float4 load_lanes(const float* x) {
  float4 v;
  std::memcpy(&v, x, sizeof v);
  return v;
}
inline float4 lanes_of(float x) { return float4{x, x, x, x}; }
inline float4 larger_lanes(float4 a, float4 b) { return a > b ? a : b; }
inline float4 smaller_lanes(float4 a, float4 b) { return a < b ? a : b; }

/// Bit k is set if lane k is true.
inline unsigned lane_mask(int4 lanes) {
  long2 halves;
  lanes &= int4{1, 2, 4, 8};
  std::memcpy(&halves, &lanes, sizeof halves);
  const auto joined = static_cast<std::uint64_t>(halves[0] | halves[1]);
  return static_cast<unsigned>(joined | joined >> 32) & 15;
}

/// Four doubles as two vectors, which every processor has.
class double4 {
  double2 low_, high_;

  double4(double2 low, double2 high) : low_(low), high_(high) {}
  static long2 same_sign(double2 a, double2 b, double2 c) {
    return ((a >= 0.0) & (b >= 0.0) & (c >= 0.0)) | ((a <= 0.0) & (b <= 0.0) & (c <= 0.0));
  }

 public:
  explicit double4(float4 x) : low_{x[0], x[1]}, high_{x[2], x[3]} {}
  double operator[](int k) const { return k < 2 ? low_[k] : high_[k - 2]; }

  /// ax by - ay bx
  static double4 determinant(const double4& ax, const double4& ay, const double4& bx, const double4& by) {
    return {ax.low_ * by.low_ - ay.low_ * bx.low_, ax.high_ * by.high_ - ay.high_ * bx.high_};
  }

  struct truth {
    long2 low, high;
    bool operator[](int k) const { return (k < 2 ? low[k] : high[k - 2]) != 0; }
    bool none() const { return (low[0] | low[1] | high[0] | high[1]) == 0; }
  };
  /// No two are above and below 0, and none is not a number.
  static truth have_same_sign(const double4& a, const double4& b, const double4& c) {
    return {same_sign(a.low_, b.low_, c.low_), same_sign(a.high_, b.high_, c.high_)};
  }
};

}  // namespace concino::detail
