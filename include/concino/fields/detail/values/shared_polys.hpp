// Divides what the polys of one mesh have among the polys of another one.
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

[[noreturn]] void throw_no_measure_to_share(std::size_t poly);

template<class From, class To>
class poly_sharing {
  struct share {
    poly_t<To> poly;
    double amount;
  };

  const From& from_;
  const To& to_;
  const poly_tree<To> tree_;

  /// Of a surface, polys near to p that are not in its plane count too.
  box surroundings(const poly_t<From>& p) const {
    box b = bounding_box(from_, p);
    if constexpr (dimension_v<From> == 2) {  // a volume has common parts only within the box
      const vec3 margin = 0.5 * b.diagonal() * vec3{1, 1, 1};
      b.min -= margin, b.max += margin;
    }
    return b;
  }

 public:
  poly_sharing(const From& from, const To& to) : from_(from), to_(to), tree_(to) {}

  /// Adds the parts of an amount that the polys of `to` get of poly p.
  void divide(const poly_t<From>& p, double amount, signed_simplices& mine, signed_simplices& other,
              std::vector<share>& shares) const {
    read_simplices(from_, p, mine);
    const std::size_t first = shares.size();
    double sum = 0;
    for (const poly_t<To>& q : tree_.in_box(surroundings(p))) {
      read_simplices(to_, q, other);
      const double common = common_measure<From>(mine, other);
      if (!(common > 0)) continue;
      sum += common;
      shares.push_back({q, common});
    }
    for (std::size_t k = first; k < shares.size(); ++k) shares[k].amount *= amount / sum;
    if (shares.size() == first) shares.push_back({tree_.closest(centroid(from_, p)).poly, amount});
  }

  template<class Q, class Result>
  void divide_all(const Q& q, Result& result) const {
    std::vector<poly_t<From>> all;
    for (const poly_t<From> p : polys(from_)) all.push_back(p);
    constexpr std::size_t chunk = 64;
    std::vector<std::vector<share>> shares((all.size() + chunk - 1) / chunk);
    parallel_for(
        shares.size(),
        [&](std::size_t c) {
          signed_simplices mine, other;
          for (std::size_t i = c * chunk; i < all.size() && i < (c + 1) * chunk; ++i)
            divide(all[i], static_cast<double>(q[all[i]]) * std::abs(measure(from_, all[i])), mine, other, shares[c]);
        },
        1);
    for (const auto& of_chunk : shares)
      for (const share& s : of_chunk) result[s.poly] += s.amount;
    for (const poly_t<To> p : polys(to_)) {
      const double size = std::abs(measure(to_, p));
      if (result[p] == 0) continue;
      if (!(size > 0)) throw_no_measure_to_share(index_of(to_, p));
      result[p] /= size;
    }
  }
};

template<class From, class Q, class To, class Result>
void share_polys(const From& from, const Q& q, const To& to, Result& result) {
  poly_sharing<From, To>(from, to).divide_all(q, result);
}

}  // namespace concino::detail
