// What computes the matrices of polys, behind a table of functions.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/operators/discretisation.hpp>

#include <memory>
#include <utility>

namespace concino::detail {

/// What computes the local matrix of one poly after another. Behind a table of functions, so that the assembly is compiled once for a mesh type
/// and not once for each discretisation; the call is nothing beside the work.
template<class M>
struct poly_operator {
  virtual ~poly_operator() = default;
  virtual void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) = 0;
};

/// Makes one for each thread that asks.
template<class M>
using make_poly_operator = function_ref<std::unique_ptr<poly_operator<M>>()>;

/// The element that make() gives, which is called as element(p, out).
template<class M, class Make>
std::unique_ptr<poly_operator<M>> poly_operator_of(const Make& make) {
  struct wrapped final : poly_operator<M> {
    decltype(make()) element;
    explicit wrapped(const Make& make_element) : element(make_element()) {}
    void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) override { element(p, out); }
  };
  return std::make_unique<wrapped>(make);
}

}  // namespace concino::detail
