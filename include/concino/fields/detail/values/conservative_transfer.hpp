// Conservative transfer of a density from the polys of one mesh to those of another one: the integral remains.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/fields/detail/values/overlap.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/centroid.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

[[noreturn]] void throw_target_without_measure(std::size_t poly);

template<class From, class To>
class conservative_transfer {
  struct share {
    poly_t<To> poly;
    double amount;
  };

  const From& from_;
  const To& to_;
  const poly_tree<To> tree_;

  /// The box in which polys of `to` may overlap p: for a surface, also those near p that are not in its plane.
  box surroundings(const poly_t<From>& p) const {
    box b = bounding_box(from_, p);
    if constexpr (dimension_v<From> == 2) {  // a volume has common parts only within the box
      const vec3 margin = 0.5 * b.diagonal() * vec3{1, 1, 1};
      b.min -= margin, b.max += margin;
    }
    return b;
  }

 public:
  conservative_transfer(const From& from, const To& to) : from_(from), to_(to), tree_(to) {}

  /// Distributes the amount of poly p over the polys of `to`, in proportion to the measures that they have in common
  /// with p. Adds them to `shares`.
  void distribute(const poly_t<From>& p, double amount, signed_simplices& source_simplices,
                  signed_simplices& target_simplices, std::vector<share>& shares) const {
    read_simplices(from_, p, source_simplices);
    const std::size_t first = shares.size();
    double sum = 0;
    for (const poly_t<To>& q : tree_.in_box(surroundings(p))) {
      read_simplices(to_, q, target_simplices);
      const double common = common_measure<From>(source_simplices, target_simplices);
      if (!(common > 0)) continue;
      sum += common;
      shares.push_back({q, common});
    }
    for (std::size_t k = first; k < shares.size(); ++k) shares[k].amount *= amount / sum;
    if (shares.size() == first) shares.push_back({tree_.closest(centroid(from_, p)).poly, amount});
  }

  template<class Q, class Result>
  void distribute_all(const Q& q, Result& result) const {
    std::vector<poly_t<From>> all;
    for (const poly_t<From> p : polys(from_)) all.push_back(p);
    constexpr std::size_t chunk = 64;
    std::vector<std::vector<share>> shares((all.size() + chunk - 1) / chunk);
    parallel_for(
        shares.size(),
        [&](std::size_t c) {
          signed_simplices source_simplices, target_simplices;
          for (std::size_t i = c * chunk; i < all.size() && i < (c + 1) * chunk; ++i)
            distribute(all[i], static_cast<double>(q[all[i]]) * std::abs(measure(from_, all[i])), source_simplices,
                       target_simplices, shares[c]);
        },
        1);
    for (const auto& of_chunk : shares)
      for (const share& s : of_chunk) result[s.poly] += s.amount;
    for (const poly_t<To> p : polys(to_)) {
      const double size = std::abs(measure(to_, p));
      if (result[p] == 0) continue;
      if (!(size > 0)) throw_target_without_measure(index_of(to_, p));
      result[p] /= size;
    }
  }
};

template<class From, class Q, class To, class Result>
void transfer_conservatively(const From& from, const Q& q, const To& to, Result& result) {
  conservative_transfer<From, To>(from, to).distribute_all(q, result);
}

}  // namespace concino::detail
