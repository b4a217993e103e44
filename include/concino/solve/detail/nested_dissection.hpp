// A fill-reducing elimination order by nested dissection of the graph of a matrix.
#pragma once

#include <concino/core/compiled.hpp>

#include <Eigen/SparseCore>

#include <vector>

namespace concino::detail {

/// Computes an elimination order by nested dissection, and returns the row at each position. It uses the graph only, not coordinates.
/// The rows of a connected part are sorted by the difference of their distances from two distant rows, and split in the middle. A minimum vertex cover of
/// the cut edges is the separator. Further covers move it as long as it becomes smaller. Both halves are split in the same way. Parts that are small, or
/// that have no small separator, keep their order by minimum degree. A separator comes after the parts that it separates. Rows with very many entries
/// come last. The result is empty if the matrix as a whole has no small separator; then minimum degree is as good.
/// pattern: compressed, with an entry wherever it or its transpose has one. by_degree: the row at each position of the order by minimum degree.
/// Cost:   O(n log n) time and O(n) memory, where n is the number of entries; the matchings take more where separators are large.
/// Source: George 1973 (nested dissection); Liu 1989 (improvement by covers); Hopcroft, Karp 1973 and Koenig 1931 (minimum covers).
std::vector<int> nested_dissection_order(const Eigen::SparseMatrix<double>& pattern, const std::vector<int>& by_degree);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/nested_dissection.ipp>
#endif
