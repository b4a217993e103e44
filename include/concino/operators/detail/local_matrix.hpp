// The part of one poly in a matrix over verts: what every operator that is assembled poly by poly hands to the assembly.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace concino::detail {

/// A symmetric matrix over the verts of one poly, n x n. Used again for poly after poly, so that nothing is allocated for each.
template<class Vert>
struct local_matrix {
  std::vector<Vert> verts;      // of the poly, each once, in any order
  std::vector<double> entries;  // the lower triangle, row after row: entry (i, j) with j <= i at i (i + 1) / 2 + j

  std::size_t size() const { return verts.size(); }
  double& at(std::size_t i, std::size_t j) { return entries[i * (i + 1) / 2 + j]; }
  double at(std::size_t i, std::size_t j) const { return entries[i * (i + 1) / 2 + j]; }
};

/// What computes the local matrix of one poly after another. Behind a table of functions, so that the assembly is compiled once for a mesh type
/// and not once for each kind of weights; the call is nothing beside the work.
template<class M>
struct poly_operator {
  virtual ~poly_operator() = default;
  virtual void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) = 0;
};

template<class M>
using make_poly_operator = std::unique_ptr<poly_operator<M>> (*)(const M&);

/// An Element that is made of a mesh and called as element(p, out), as a poly_operator.
template<class Element, class M>
std::unique_ptr<poly_operator<M>> poly_operator_of(const M& m) {
  struct wrapped final : poly_operator<M> {
    Element element;
    explicit wrapped(const M& mesh) : element(mesh) {}
    void operator()(const poly_t<M>& p, local_matrix<vert_t<M>>& out) override { element(p, out); }
  };
  return std::make_unique<wrapped>(m);
}

}  // namespace concino::detail
