// Makes a path along edges straight by flips of intrinsic triangles.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/lines/detail/geodesics/intrinsic_triangles.hpp>

#include <vector>

namespace concino::detail {

/// Shortens the path of these half-edges, each of which starts where the one before ends, until nothing can be flipped.
/// Returns the half-edges of the straight path; none if a closed one shrinks to a vert. The edges of t change.
std::vector<int> flip_out(intrinsic_triangles& t, const std::vector<int>& path, bool is_closed);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/geodesics/flip_out.ipp>
#endif
