// The steps in which surfaces are repaired. Each changes the lists and logs what it did.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/repair/detail/repair_log.hpp>
#include <concino/repair/detail/surface_lists.hpp>
#include <concino/repair/repair_options.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Verts at most `tolerance` apart become one; the others of a cluster remain as verts without polys.
void merge_verts_within(surface_lists& s, double tolerance, repair_log& log);
/// A poly that passes a vert twice becomes the cycles in between; those of fewer than three verts vanish.
/// Errors: unsupported if arity > 0 and a cycle has another number of verts.
void cut_at_repeated_verts(surface_lists& s, std::uint32_t arity, repair_log& log);
/// Of polys with the same verts, the first remains.
void remove_duplicate_polys(surface_lists& s, repair_log& log);
/// Gives each fan of polys, connected through edges of exactly two polys, verts of its own.
void split_into_fans(surface_lists& s, repair_log& log);
/// Winds polys consistently where edges of exactly two polys connect them, and outward where they are closed.
void orient_polys(surface_lists& s, repair_log& log);
/// Marks turned polys in the log.
void log_turned(const surface_lists& s, repair_log& log);
/// Removes or logs triangles without area.
void mend_degenerate(surface_lists& s, degenerate_elements how, std::uint32_t arity, repair_log& log);
/// Logs the polys that intersect others, or removes them.
/// Result: by vert, whether polys were removed there; empty if none were.
std::vector<std::uint8_t> mend_intersections(surface_lists& s, intersecting_triangles how, repair_log& log);
/// Fills holes of at most max_edges edges, and those whose verts are all marked.
/// Result: whether some were filled.
bool fill_holes(surface_lists& s, std::size_t max_edges, const std::vector<std::uint8_t>& marked, hole_filling how,
                std::uint32_t arity, repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/fill_holes.ipp>
#include <concino/repair/detail/mend_shapes.ipp>
#include <concino/repair/detail/orient_polys.ipp>
#include <concino/repair/detail/surface_steps.ipp>
#endif
