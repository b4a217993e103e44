// concino::clipper: Clipper as the back end that unites, cuts and offsets regions of the plane.
//
//   const auto both = region_union(a, b, clipper);
//
// Needs: Clipper 6.4 (Debian: libpolyclipping-dev), linked by -lpolyclipping. It is under the Boost licence.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <utility>

namespace concino {

namespace detail {

inline ClipperLib::Path clipper_path(std::span<const snapped_point> path) {
  ClipperLib::Path p;
  p.reserve(path.size());
  for (const snapped_point& x : path) p.emplace_back(x[0], x[1]);
  return p;
}

/// Returns whether there is a path with area.
inline bool add_clipper_paths(ClipperLib::Clipper& c, const lattice_paths& paths, ClipperLib::PolyType type) {
  bool any = false;
  for (std::size_t i = 0; i < paths.size(); ++i) any = c.AddPath(clipper_path(paths[i]), type, true) || any;
  return any;
}

/// The regions of a tree of contours: outer ones, their holes, islands in these, and so on.
inline lattice_regions regions_of_tree(const ClipperLib::PolyTree& tree) {
  lattice_regions result;
  const auto add = [&](const ClipperLib::Path& path) {
    for (const ClipperLib::IntPoint& p : path) result.paths.points.push_back({p.X, p.Y});
    result.paths.ends.push_back(result.paths.points.size());
  };
  std::vector<const ClipperLib::PolyNode*> outers(tree.Childs.begin(), tree.Childs.end());
  for (std::size_t i = 0; i < outers.size(); ++i) {
    const ClipperLib::PolyNode& outer = *outers[i];
    add(outer.Contour);
    for (const ClipperLib::PolyNode* const hole : outer.Childs) {
      add(hole->Contour);
      outers.insert(outers.end(), hole->Childs.begin(), hole->Childs.end());
    }
    result.region_ends.push_back(result.paths.size());
  }
  return result;
}

}  // namespace detail

/// Clipper 6.4. Coordinates are integers of 62 bits.
/// Cost:   for n points, of which k lie at any height: O(n (log n + k)); those that cross cost more.
/// Errors: unsupported if Clipper refuses coordinates, or fails.
/// Source: Vatti 1992, "A generic solution to polygon clipping", with extensions by Angus Johnson.
struct clipper_back_end final : polygon_clipper {
  constexpr clipper_back_end() = default;

  const char* name() const override { return "Clipper"; }

  lattice_regions combine(region_operation what, const lattice_paths& a, const lattice_paths& b) const override {
    const auto type = what == region_operation::unite      ? ClipperLib::ctUnion
                      : what == region_operation::subtract ? ClipperLib::ctDifference
                                                           : ClipperLib::ctIntersection;
    return guarded([&](ClipperLib::PolyTree& tree) {
      ClipperLib::Clipper c;
      const bool any = detail::add_clipper_paths(c, a, ClipperLib::ptSubject);
      if (!detail::add_clipper_paths(c, b, ClipperLib::ptClip) && !any) return true;  // Execute would fail
      return c.Execute(type, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
    });
  }

  lattice_regions offset(const lattice_paths& paths, const lattice_offset& how) const override {
    return guarded([&](ClipperLib::PolyTree& tree) {
      // the last chord of an arc is up to 1.5 times as long as the others, so its error is up to 2.25 times as large
      ClipperLib::ClipperOffset c(how.mitre_limit, std::max(0.25, how.chord_error / 2.25));
      const auto join = how.corners == offset_corners::mitred ? ClipperLib::jtMiter : ClipperLib::jtRound;
      const auto end = how.open ? ClipperLib::etOpenRound : ClipperLib::etClosedPolygon;
      for (std::size_t i = 0; i < paths.size(); ++i) c.AddPath(detail::clipper_path(paths[i]), join, end);
      c.Execute(tree, how.distance);
      return true;
    });
  }

 private:
  template<class F>
  static lattice_regions guarded(const F& execute) {
    try {
      ClipperLib::PolyTree tree;
      if (!execute(tree)) throw unsupported("Clipper could not combine these regions");
      return detail::regions_of_tree(tree);
    } catch (const ClipperLib::clipperException& e) {
      throw unsupported(core::joined({"Clipper: ", e.what()}));
    }
  }
};
inline constexpr clipper_back_end clipper;

}  // namespace concino
