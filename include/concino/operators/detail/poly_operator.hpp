// An abstract base for the computation of local matrices of polys.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/operators/discretisation.hpp>

#include <memory>
#include <utility>

namespace concino::detail {

/// Computes the local matrix of one poly after another. It is type-erased, so that the assembly is compiled once per
/// mesh type and not once per discretisation. The cost of the call is negligible.
template<class M>
struct poly_operator {
  virtual ~poly_operator() = default;
  virtual void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) = 0;
};

/// Creates one for each thread that needs it.
template<class M>
using make_poly_operator = function_ref<std::unique_ptr<poly_operator<M>>()>;

/// Wraps the object that make() returns, which is called as element(p, out).
template<class M, class Make>
std::unique_ptr<poly_operator<M>> poly_operator_of(const Make& make) {
  struct wrapped final : poly_operator<M> {
    decltype(make()) element;
    explicit wrapped(const Make& make_element) : element(make_element()) {}
    void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) override { element(p, out); }
  };
  return std::unique_ptr<poly_operator<M>>(new wrapped(make));
}

}  // namespace concino::detail
