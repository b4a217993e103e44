// Criteria for polys, and their combination by &&, || and !.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/parallel.hpp>

#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// The base class of all criteria for polys. A criterion c has c.prepare(m): a function object that says whether a poly
/// of m meets it. It is called in several threads, while m and c exist.
struct criterion_base {};

/// A criterion for polys, such as below('x', 0.3).
template<class C>
concept Criterion = std::derived_from<std::remove_cvref_t<C>, criterion_base>;

/// A criterion for the polys of a mesh of type M: below() needs points, labeled(map, ...) a map that gives labels at
/// its polys.
template<class C, class M>
concept CriterionOn = Criterion<C> && AnyMesh<M> &&
    requires(const std::remove_cvref_t<C>& c, const std::remove_cvref_t<M>& m, const poly_t<M>& p) {
  { c.prepare(m)(p) } -> std::convertible_to<bool>;
};

/// The polys that meet both criteria.
template<Criterion A, Criterion B>
struct both_criteria : criterion_base {
  A first;
  B second;
  both_criteria(A a, B b) : first(std::move(a)), second(std::move(b)) {}
  template<class M>
    requires CriterionOn<A, M> && CriterionOn<B, M>
  auto prepare(const M& m) const {
    return [a = first.prepare(m), b = second.prepare(m)](const poly_t<M>& p) -> bool { return a(p) && b(p); };
  }
};

/// The polys that meet at least one of two criteria.
template<Criterion A, Criterion B>
struct either_criterion : criterion_base {
  A first;
  B second;
  either_criterion(A a, B b) : first(std::move(a)), second(std::move(b)) {}
  template<class M>
    requires CriterionOn<A, M> && CriterionOn<B, M>
  auto prepare(const M& m) const {
    return [a = first.prepare(m), b = second.prepare(m)](const poly_t<M>& p) -> bool { return a(p) || b(p); };
  }
};

/// The polys that do not meet a criterion.
template<Criterion C>
struct negated_criterion : criterion_base {
  C negated;
  explicit negated_criterion(C c) : negated(std::move(c)) {}
  template<class M>
    requires CriterionOn<C, M>
  auto prepare(const M& m) const {
    return [c = negated.prepare(m)](const poly_t<M>& p) -> bool { return !c(p); };
  }
};

/// Combine criteria: below('x', 0.3) && !labeled(material, {2}).
/// Needs:  criteria; those with && and || are for the same mesh type.
/// Result: a criterion that holds copies of them.      Cost: that of the criteria; the second one is not asked if the
///         first one decides.
/// Errors: none.
template<Criterion A, Criterion B>
both_criteria<A, B> operator&&(A a, B b) { return {std::move(a), std::move(b)}; }
template<Criterion A, Criterion B>
either_criterion<A, B> operator||(A a, B b) { return {std::move(a), std::move(b)}; }
template<Criterion C>
negated_criterion<C> operator!(C c) { return negated_criterion<C>(std::move(c)); }

namespace detail {

/// Writes for each poly whether it meets the criterion, by index.
template<class M, class C>
void evaluate_criterion(const M& m, const C& c, unsigned char* mask) {
  const auto meets = c.prepare(m);
  parallel_for_each(polys(m), [&m, &meets, mask](const poly_t<M>& p) { mask[index_of(m, p)] = meets(p); });
}

/// A criterion that was evaluated for all polys of m.
template<class M>
struct evaluated_criterion {
  const M* mesh;
  std::vector<unsigned char> mask;  // by index

  explicit evaluated_criterion(const M& m, bool init = false) : mesh(&m), mask(poly_index_bound(m), init) {}
  bool operator()(const poly_t<M>& p) const { return mask[index_of(*mesh, p)] != 0; }
};

}  // namespace detail

}  // namespace concino
