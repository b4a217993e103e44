// Integers of 256 bits, for exact determinants in Voronoi diagrams on a lattice.
#pragma once

#include <concino/core/uint128.hpp>

#include <cmath>
#include <cstdint>

namespace concino::detail {

__extension__ typedef __int128 int128;

/// A 256-bit integer: two's complement, wraps on overflow.
class int256 {
  std::uint64_t limb_[4] = {0, 0, 0, 0};  // the lowest first

 public:
  constexpr int256() = default;
  constexpr int256(int128 x)
      : limb_{static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(static_cast<core::uint128>(x) >> 64), 0, 0} {
    if (x < 0) limb_[2] = limb_[3] = ~std::uint64_t{0};
  }
  constexpr int256(std::int64_t x) : int256(static_cast<int128>(x)) {}

  constexpr int sign() const {
    if (limb_[3] >> 63) return -1;
    return (limb_[0] | limb_[1] | limb_[2] | limb_[3]) != 0;
  }

  friend constexpr int256 operator+(const int256& a, const int256& b) {
    int256 r;
    core::uint128 carry = 0;
    for (int i = 0; i < 4; ++i) {
      carry += static_cast<core::uint128>(a.limb_[i]) + b.limb_[i];
      r.limb_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return r;
  }
  friend constexpr int256 operator-(const int256& a) {
    int256 r;
    for (int i = 0; i < 4; ++i) r.limb_[i] = ~a.limb_[i];
    return r + int256(std::int64_t{1});
  }
  friend constexpr int256 operator-(const int256& a, const int256& b) { return a + -b; }
  friend constexpr int256 operator*(const int256& a, const int256& b) {
    int256 r;
    for (int i = 0; i < 4; ++i) {
      core::uint128 carry = 0;
      for (int j = 0; i + j < 4; ++j) {
        carry += static_cast<core::uint128>(a.limb_[i]) * b.limb_[j] + r.limb_[i + j];
        r.limb_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return r;
  }
  friend constexpr bool operator==(const int256&, const int256&) = default;

  /// The nearest double, or one of its neighbours.
  double to_double() const {
    if (sign() < 0) return -(-*this).to_double();
    double x = 0;
    for (int i = 3; i >= 0; --i) x = x * 0x1p64 + static_cast<double>(limb_[i]);
    return x;
  }
};

}  // namespace concino::detail
