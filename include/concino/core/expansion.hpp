// Exact sums and products of doubles: a number is the sum of non-overlapping doubles, the smallest first.
#pragma once

#include <cmath>
#include <cstddef>

#if defined(__FAST_MATH__)
#error "concino: -ffast-math lets the compiler reorder sums, which makes exact predicates wrong; compile without it"
#endif

namespace concino::core {

/// a + b = sum + rest, exactly.   Source: Knuth, The Art of Computer Programming, volume 2.
inline void two_sum(double a, double b, double& sum, double& rest) {
  sum = a + b;
  const double bb = sum - a;
  rest = (a - (sum - bb)) + (b - bb);
}
/// a * b = product + rest, exactly, unless it underflows.
inline void two_product(double a, double b, double& product, double& rest) {
  product = a * b;
  rest = std::fma(a, b, -product);
}

/// An exact sum of at most N doubles. Zero components are dropped if that is easily seen: this keeps coordinates of few
/// digits cheap.
template<std::size_t N>
struct expansion {
  double part[N] = {};
  std::size_t size = 0;

  /// The sign of the largest component that is not 0.
  int sign() const {
    for (std::size_t i = size; i > 0; --i)
      if (part[i - 1] != 0) return part[i - 1] > 0 ? 1 : -1;
    return 0;
  }
  /// Adds x; there must be capacity for one more component.   Source: Shewchuk 1997, grow-expansion.
  void add(double x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size; ++i) {
      double rest;
      two_sum(x, part[i], x, rest);
      if (rest != 0) part[kept++] = rest;
    }
    part[kept++] = x;
    size = kept;
  }
};

template<std::size_t N, std::size_t M>
expansion<N + M> sum(const expansion<N>& a, const expansion<M>& b) {
  expansion<N + M> r;
  for (std::size_t i = 0; i < a.size; ++i) r.part[r.size++] = a.part[i];
  // each component of b is added above the previous ones: earlier results lie below it
  for (std::size_t j = 0; j < b.size; ++j) {
    double x = b.part[j];
    for (std::size_t i = j; i < r.size; ++i) two_sum(x, r.part[i], x, r.part[i]);
    r.part[r.size++] = x;
  }
  return r;
}

/// Source: Shewchuk 1997, scale-expansion.
template<std::size_t N>
expansion<2 * N> product(const expansion<N>& a, double b) {
  expansion<2 * N> r;
  if (a.size == 0) return r;
  double carry, low;
  two_product(a.part[0], b, carry, low);
  if (low != 0) r.part[r.size++] = low;
  for (std::size_t i = 1; i < a.size; ++i) {
    double high, rest, middle;
    two_product(a.part[i], b, high, rest);
    two_sum(carry, rest, middle, low);
    if (low != 0) r.part[r.size++] = low;
    two_sum(high, middle, carry, low);
    if (low != 0) r.part[r.size++] = low;
  }
  r.part[r.size++] = carry;
  return r;
}

template<std::size_t N, std::size_t M>
expansion<2 * N * M> product(const expansion<N>& a, const expansion<M>& b) {
  expansion<2 * N * M> r;
  for (std::size_t j = 0; j < b.size; ++j) {
    const expansion<2 * N> p = product(a, b.part[j]);
    for (std::size_t i = 0; i < p.size; ++i) r.add(p.part[i]);
  }
  return r;
}

template<std::size_t N>
expansion<N> minus(expansion<N> a) {
  for (std::size_t i = 0; i < a.size; ++i) a.part[i] = -a.part[i];
  return a;
}

/// a - b, exactly.
inline expansion<2> difference(double a, double b) {
  expansion<2> r;
  double whole, rest;
  two_sum(a, -b, whole, rest);
  if (rest != 0) r.part[r.size++] = rest;
  r.part[r.size++] = whole;
  return r;
}

}  // namespace concino::core
