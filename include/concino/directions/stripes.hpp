// stripes(m, field, frequency): stripes at even distances on a surface, across the directions of a field.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/stripes/stripe_angles.hpp>
#include <concino/directions/direction_field.hpp>
#include <concino/mesh/corner.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct stripes_options {
  concino::progress progress = nullptr;   // called with "stripes"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// A poly in which stripes begin or end.
template<class P>
struct stripe_singularity {
  P poly;
  int index = 0;             // how many stripes begin in it, minus those that end; 0 where the field turns
  bool field_turns = false;  // whether the lines of the field do not agree around the poly
};

template<class M>
struct stripes_result {
  corner_map<M, double> angles;  // radians: 2 pi from one stripe to the next. The cosine is the same at both polys of
                                 // an edge, the angle is so up to its sign and multiples of 2 pi
  std::vector<stripe_singularity<poly_t<M>>> singular;  // in the order of polys(m). There angles jump between the last
                                                        // and the first corner
  double energy = 0;    // how much the distances differ from what is asked: the integral of the squared difference of
                        // gradients over that of the square, in units of length^-2; 0: not at all
  double residual = 0;  // of the eigenvector; 1e-9 if it was found, more if the next eigenvalue is so near that it was
                        // not within 100 rounds
};

/// Stripes on a surface: auto s = stripes(m, direction_field(m, {.symmetry = 2}), 20); stripe_lines(s) are lines in
/// their middles. The angle grows along the directions of the field, so that stripes cross them at right angles.
/// Needs:  Embedded SurfaceMesh M, no temporary, of polys of any shape; field: of direction_field on m, with symmetry 1
///         or 2. frequency: stripes per unit of length, above 0; some polys for each stripe are needed.
/// Result: see stripes_result. Distances are kept as well as directions allow: where stripes would come too close or
///         too far apart, some begin or end in singular polys.
/// Cost:   one factorisation of a matrix with two rows for each vert, and up to 100 solves.
/// Errors: invalid_argument if the field is one of another mesh or has another symmetry, or the frequency is not finite
///         and above 0, or so high that more than 1,000 stripes would cross an edge; solver_error; cancelled.
/// Source: Knoppel, Crane, Pinkall, Schroder 2015, "Stripe patterns on surfaces", with virtual elements in place of
///         their linear elements.
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
stripes_result<std::remove_cvref_t<M>> stripes(M&& m, const direction_field_result<std::remove_cvref_t<M>>& field,
                                               double frequency, const stripes_options& options = {}) {
  const core::profiled_options profiled(options, "stripes");
  if (!(frequency > 0 && std::isfinite(frequency)))
    throw invalid_argument("stripes: the frequency must be finite and above 0");
  if (field.symmetry() != 1 && field.symmetry() != 2)
    core::throw_joined<invalid_argument>({"stripes: the field has symmetry ", field.symmetry(), "; 1 or 2 is needed"});
  const detail::oriented_surface& s = field.surface();
  if (s.num_verts() != vert_index_bound(m) || s.num_polys() != num_polys(m))
    throw invalid_argument("stripes: the field is one of another mesh");
  const detail::stripe_angles found = detail::find_stripes(
      s, field.symmetry(), field.values(), std::ldexp(frequency, s.exponent), profiled->progress);
  stripes_result<std::remove_cvref_t<M>> result{
      make_corner_map<double>(m), {}, std::ldexp(found.energy, -2 * s.exponent), found.residual};
  std::size_t p = 0;
  for (const poly_t<M> poly : polys(m)) {
    std::size_t k = 0;
    for (const vert_t<M> v : adj_p2v(m, poly)) {
      for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c)
        if (s.vert[c] == index_of(m, v)) result.angles.of(poly)[k] = found.angle[c];
      ++k;
    }
    if (found.index[p] != 0 || found.field_turns[p])
      result.singular.push_back({poly, found.index[p], found.field_turns[p] != 0});
    ++p;
  }
  return result;
}

/// Lines in the middles of stripes, where the angle is a multiple of 2 pi, poly by poly: scene().add_lines(
/// stripe_lines(s)).
/// Needs:  a result of stripes, whose mesh has not changed.
/// Result: segments that meet at edges. Singular polys have none.
/// Cost:   O(corners + segments).
/// Errors: none.
template<class M>
std::vector<std::array<vec3, 2>> stripe_lines(const stripes_result<M>& found) {
  const M& m = found.angles.mesh();
  std::vector<unsigned char> is_singular(poly_index_bound(m));
  for (const auto& x : found.singular) is_singular[index_of(m, x.poly)] = 1;
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<std::array<vec3, 2>> all;
  std::vector<vec3> corners, ends;
  for (const poly_t<M> p : polys(m)) {
    if (is_singular[index_of(m, p)]) continue;
    const auto angles = found.angles.of(p);
    corners.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) corners.push_back(to_vec3(point(m, v)));
    double low = angles[0], high = angles[0];
    for (const double a : angles) low = std::min(low, a), high = std::max(high, a);
    for (double level = turn * std::ceil(low / turn); level <= high; level += turn) {
      ends.clear();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::size_t next = (k + 1) % corners.size();
        const double a = angles[k] - level, b = angles[next] - level;
        if ((a < 0) != (b < 0)) ends.push_back(corners[k] + (a / (a - b)) * (corners[next] - corners[k]));
      }
      for (std::size_t k = 0; k + 1 < ends.size(); k += 2) all.push_back({ends[k], ends[k + 1]});
    }
  }
  return all;
}

// What to write instead of calls that cannot compile.
template<class... T> void stripes(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void stripes(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void stripes(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
