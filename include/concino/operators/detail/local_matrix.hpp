// The part of one poly in a matrix over verts: what every operator that is assembled poly by poly hands to the assembly.
#pragma once

#include <cstddef>
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

  /// As many rows as verts, all 0.
  void clear_entries() { entries.assign(verts.size() * (verts.size() + 1) / 2, 0.0); }
};

}  // namespace concino::detail
