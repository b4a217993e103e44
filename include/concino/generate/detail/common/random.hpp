// A pseudorandom number generator with the same results on every machine and with every compiler.
#pragma once

#include <concino/core/hash_bytes.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace concino::detail {

/// The SplitMix64 generator.      Source: Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
class random_stream {
  std::uint64_t state_;

 public:
  constexpr explicit random_stream(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    const std::uint64_t before = state_;
    state_ += 0x9e3779b97f4a7c15u;
    return core::scrambled(before);
  }
  /// The next number in [0, 1), a multiple of 2^-53.
  constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// The next number in [low, high]. std::fma is explicit, so that the last bit does not depend on whether a compiler
  /// contracts the expression.
  double between(double low, double high) { return std::clamp(std::fma(unit(), high - low, low), low, high); }
};

}  // namespace concino::detail
