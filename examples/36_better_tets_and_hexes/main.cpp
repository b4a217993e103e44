// Better cells for a solver. improve changes tets until no dihedral angle is too small: it flips faces and edges, moves, removes and adds verts, and keeps the
// boundary and the walls between materials. smooth_points changes no connectivity, so it works on hexes and polygons too.
#include <concino/edit.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>
#include <concino/remesh.hpp>

#include <fmt/core.h>

namespace cn = concino;
using cn::metric;

/// Why it stopped, in words.
const char* reason(cn::improvement_end end) {
  switch (end) {
    case cn::improvement_end::target: return "the target is met";
    case cn::improvement_end::boundary: return "the boundary allows no more";
    case cn::improvement_end::no_edit: return "no edit helps";
    case cn::improvement_end::max_rounds: return "it may go on";
  }
  return "";
}

template<class M>
void report(const char* title, const M& m, const cn::improvement<M>& r) {
  fmt::print("{:<22} {:5} tets, least dihedral angle {:5.1f} -> {:4.1f} degrees; {}\n", title, cn::num_polys(m), r.least_before, r.least_after, reason(r.stopped_by));
}

int main() {
  // Tets whose points were moved at random; some are inverted. The lower half is of another material.
  auto tets = cn::make_grid<cn::tetmesh>({.cells = {8, 8, 8}});
  auto material = cn::poly_property<int>(tets, "material");
  cn::set_property_rule(tets, cn::element_kind::poly, "material", cn::property_rule::copy);  // new tets have that of the old ones
  const double middle = cn::bounding_box(tets).max.z / 2;
  for (auto p : cn::polys(tets)) material[p] = cn::centroid(tets, p).z < middle ? 1 : 2;
  cn::jitter(tets, 0.4);
  const auto volume_of = [&](const auto& m, const auto& map) {
    double sum = 0;
    for (auto p : cn::polys(m))
      if (map[p] == 1) sum += cn::volume(m, p);
    return sum;
  };
  fmt::print("volume of material 1   {:.6f}\n", volume_of(tets, material));
  const auto first = cn::improve(tets, {.min_dihedral_deg = 15}, material);
  report("at least 15 degrees", tets, first);
  fmt::print("  {} flips, {} moves, {} collapses, {} new verts\n", first.num_flips, first.num_moves, first.num_collapses, first.num_new_verts);
  {
    cn::transaction t(tets);  // an experiment: without commit, the mesh is then as it was
    report("at least 30 degrees", tets, cn::improve(tets, {.min_dihedral_deg = 30}, material));
  }
  fmt::print("volume of material 1   {:.6f}, {} tets\n", volume_of(tets, material), cn::num_polys(tets));

  // Hexes cannot be flipped, but their points can move. Inverted corners are turned back.
  auto hexes = cn::make_grid<cn::hexmesh>({.cells = {8, 8, 8}});
  cn::jitter(hexes, 0.5);
  const double before = cn::worst(hexes, metric::scaled_jacobian).value;
  const auto s = cn::smooth_points(hexes);
  fmt::print("hexes                  {} of {} corners inverted -> {}; least scaled Jacobian {:.2f} -> {:.2f}\n", s.num_inverted_before, 8 * cn::num_polys(hexes),
             s.num_inverted_after, before, cn::worst(hexes, metric::scaled_jacobian).value);
}
