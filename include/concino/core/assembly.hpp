// Assembly of a sparse matrix from edge weights, directly into compressed columns: no list of triplets, each weight is
// read when it is needed.
#pragma once

#include <concino/concepts/primal_graph.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/parallel.hpp>

#include <Eigen/SparseCore>

#include <cstddef>

namespace concino::core {

/// Sorts a column by row. Most columns are short, but those of verts with many neighbours are long; both are fast.
void sort_column(int* rows, double* values, std::size_t n);

/// Allocates a matrix whose array `a.outerIndexPtr()` has the number of entries of each column, from the second place
/// on.
/// Errors: unsupported if 32-bit indices cannot count the entries.
void make_room_for_counted(Eigen::SparseMatrix<double>& a);

/// Errors: unsupported if 32-bit indices cannot count the rows.
void check_rows(std::size_t size);

/// All entries, if every vert has a column.
struct whole_matrix {
  static constexpr bool is_whole = true;
  static constexpr bool wants(int, int) { return true; }
};
struct lower_triangle {
  static constexpr bool is_whole = false;
  static constexpr bool wants(int row, int column) { return row >= column; }
};

/// The matrix with `sign` times the sum of the weights at a vert on the diagonal, and minus `sign` times the weights
/// off the diagonal. column(v) is the row and column of vert v, negative if it has none: such a neighbour adds to the
/// diagonal and is reported to outside(column of v, neighbour, weight), by several threads for different v. Part
/// selects the triangle. Verts may come in any order.
template<class Part, class M, class W, class Column, class Outside>
Eigen::SparseMatrix<double> assemble(const M& m, const W& weights, std::size_t size, double sign, const Column& column,
                                     const Outside& outside) {
  check_rows(size);
  Eigen::SparseMatrix<double> a(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  int* const begin = a.outerIndexPtr();
  for (const vert_t<M> v : verts(m)) {
    const int c = column(v);
    if (c < 0) continue;
    int n = 1;
    if constexpr (Part::is_whole) {
      n += weights.num_neighbours(v);
    } else {
      weights.for_each_neighbour(v, [&](const vert_t<M>& w, double) {
        if (const int r = column(w); r >= 0 && Part::wants(r, c)) ++n;
      });
    }
    begin[c + 1] = n;
  }
  make_room_for_counted(a);
  int* const rows = a.innerIndexPtr();
  double* const values = a.valuePtr();
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {  // each vert writes its own column
    const int c = column(v);
    if (c < 0) return;
    const std::size_t first = static_cast<std::size_t>(begin[c]);
    std::size_t at = first + 1;
    double diagonal = 0;
    weights.for_each_neighbour(v, [&](const vert_t<M>& w, double weight) {
      diagonal += weight;
      const int r = column(w);
      if (r < 0) return outside(c, w, weight);
      if (!Part::wants(r, c)) return;
      rows[at] = r;
      values[at++] = -sign * weight;
    });
    rows[first] = c;
    values[first] = sign * diagonal;
    sort_column(rows + first, values + first, at - first);
  });
  return a;
}

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/core/detail/assembly.ipp>
#endif
