// Criteria for values at polys: labels, limits of a quantity such as quality, a selection, or any function.
#pragma once

#include <concino/core/error.hpp>
#include <concino/render/criterion.hpp>
#include <concino/render/detail/colors/kept_map.hpp>

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace concino {

namespace requirement {

/// P gives a whole number at each E.
template<class P, class E>
concept gives_labels = ReadableMap<P, E> && requires(const std::remove_cvref_t<P>& p, const E& e) {
  { p[e] } -> std::convertible_to<long long>;
  requires !std::is_floating_point_v<std::remove_cvref_t<decltype(p[e])>>;
};

}  // namespace requirement

/// Polys with one of some labels. P: the type of a forwarded map.
template<class P>
struct label_criterion : criterion_base {
  detail::kept_map<P> map;
  std::vector<long long> labels;  // in ascending order
  label_criterion(detail::kept_map<P> from, std::vector<long long> some)
      : map(std::move(from)), labels(std::move(some)) {
    std::sort(labels.begin(), labels.end());
  }

  template<AnyMesh M>
    requires requirement::gives_labels<P, poly_t<M>>
  auto prepare(const M& m) const {
    detail::check_map(m, map.get(), poly_index_bound(m), element_kind::poly, "labeled");
    return [&u = map.get(), &some = labels](const poly_t<M>& p) -> bool {
      return std::binary_search(some.begin(), some.end(), static_cast<long long>(u[p]));
    };
  }
};

/// Polys with a value in [low, high]. P: the type of a forwarded map.
template<class P>
struct value_criterion : criterion_base {
  detail::kept_map<P> map;
  double low, high;
  const char* caller;
  value_criterion(detail::kept_map<P> from, double least, double largest, const char* name)
      : map(std::move(from)), low(least), high(largest), caller(name) {
    if (!(low <= high)) core::throw_joined<invalid_argument>({caller, ": the limit is not a number (NaN)"});
  }

  template<AnyMesh M>
    requires requirement::gives_numbers<P, poly_t<M>>
  auto prepare(const M& m) const {
    detail::check_map(m, map.get(), poly_index_bound(m), element_kind::poly, caller);
    return [&u = map.get(), from = low, to = high](const poly_t<M>& p) -> bool {
      const double x = static_cast<double>(u[p]);
      return from <= x && x <= to;
    };
  }
};

/// Polys for which a function returns true.
template<class F>
struct function_criterion : criterion_base {
  F function;
  explicit function_criterion(F f) : function(std::move(f)) {}

  template<AnyMesh M>
    requires requires(const F& f, const poly_t<M>& p) { { f(p) } -> std::convertible_to<bool>; }
  auto prepare(const M& m) const {
    detail::evaluated_criterion<M> all(m);  // the caller's function need not be callable in several threads
    for (const poly_t<M> p : polys(m)) all.mask[index_of(m, p)] = static_cast<bool>(function(p));
    return all;
  }
};

/// Polys p whose label map[p] is one of those given: labeled(material, {1, 3}).
/// Needs:  map[p] is a whole number for each poly. A map that is an lvalue must outlive the criterion; a temporary map
///         is stored in it.
/// Result: a criterion.      Cost: O(n log n) for n labels; to evaluate it, O(log n) for each poly.
/// Errors: none here; to evaluate it, invalid_argument if map is a map of another mesh, or was made before polys were
///         added.
template<class P>
label_criterion<P> labeled(P&& map, std::initializer_list<long long> labels) {
  return {detail::kept_map<P>(std::forward<P>(map)), std::vector<long long>(labels)};
}
template<class P, class R>
  requires requires(const R& labels) { { *labels.begin() } -> std::convertible_to<long long>; labels.end(); }
label_criterion<P> labeled(P&& map, const R& labels) {
  std::vector<long long> some;
  for (const auto& x : labels) some.push_back(static_cast<long long>(x));
  return {detail::kept_map<P>(std::forward<P>(map)), std::move(some)};
}

/// Polys p with map[p] <= limit, with map[p] >= limit, or with map[p] true: at_most(quality(m,
/// metric::scaled_jacobian), 0.2).
/// Needs:  map[p] is a number for each poly; maps as above.
/// Result: a criterion, which polys with the value NaN do not meet.      Cost: O(1); to evaluate it, one read for each
///         poly.
/// Errors: invalid_argument if the limit is NaN; as above to evaluate it.
template<class P>
value_criterion<P> at_most(P&& map, double limit) {
  return {detail::kept_map<P>(std::forward<P>(map)), -std::numeric_limits<double>::infinity(), limit, "at_most"};
}
template<class P>
value_criterion<P> at_least(P&& map, double limit) {
  return {detail::kept_map<P>(std::forward<P>(map)), limit, std::numeric_limits<double>::infinity(), "at_least"};
}
template<class P>
value_criterion<P> selected(P&& map) {
  return {detail::kept_map<P>(std::forward<P>(map)), 1, 1, "selected"};
}

/// Polys p for which f(p) is true.
/// Needs:  f(p) is true or false for each poly. The criterion holds a copy of f.
/// Result: a criterion.      Cost: O(1); to evaluate it, one call for each poly, in the order of the mesh and in one
///         thread.
/// Errors: none; to evaluate it, those of f.
template<class F>
function_criterion<F> where(F f) { return function_criterion<F>(std::move(f)); }

}  // namespace concino
