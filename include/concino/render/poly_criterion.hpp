// A criterion of any type for the polys of a mesh, for options that hold one.
#pragma once

#include <concino/render/value_criteria.hpp>

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

namespace requirement {

/// P says at each poly of M whether it is chosen: a poly_map<M, bool>, such as visible_polys returns.
template<class P, class M>
concept is_choice_of_polys = !Criterion<P> && AnyMesh<M> && ReadableMap<P, poly_t<M>> &&
                             requires(const std::remove_cvref_t<P>& chosen, const poly_t<M>& p) {
  requires std::same_as<std::remove_cvref_t<decltype(chosen[p])>, bool>;
};

}  // namespace requirement

/// A criterion for polys of a mesh of type M, whatever its type. Options such as those of scenes hold one.
/// Needs:  AnyMesh M; a criterion for it, or a map of bool at its polys. Maps that are lvalues must outlive it.
/// Result: an implicit conversion from such a criterion, of which it holds a copy; copies share it. A map means
///         selected(map). By default all polys meet it.
/// Cost:   one allocation; to evaluate it, one array of a byte per poly.
/// Errors: those of the criterion.
template<AnyMesh M>
class poly_criterion : public criterion_base {
  std::shared_ptr<const void> criterion_;
  void (*evaluate_)(const void*, const M&, unsigned char*) = nullptr;

 public:
  poly_criterion() = default;

  template<class C>
    requires(!std::same_as<C, poly_criterion> && CriterionOn<C, M>)
  poly_criterion(C c)
      : criterion_(std::make_shared<const C>(std::move(c))),
        evaluate_([](const void* x, const M& m, unsigned char* mask) {
          detail::evaluate_criterion(m, *static_cast<const C*>(x), mask);
        }) {}

  template<class P>
    requires requirement::is_choice_of_polys<P, M>
  poly_criterion(P&& map) : poly_criterion(selected(std::forward<P>(map))) {}

  /// Whether there is one; if not, all polys meet it. There is no conversion to bool, since ! negates a criterion.
  bool has_criterion() const { return evaluate_ != nullptr; }

  detail::evaluated_criterion<M> prepare(const M& m) const {
    detail::evaluated_criterion<M> all(m, !evaluate_);
    if (evaluate_) evaluate_(criterion_.get(), m, all.mask.data());
    return all;
  }
};

}  // namespace concino
