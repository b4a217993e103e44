// Bodies of tetrahedralize_steps.hpp: the options of tetrahedralize(), checked; its times; and the tets that miss what
// was asked for.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/volumes/tetrahedralize_steps.hpp>
#include <concino/geometry/circumcentre.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace concino::detail {

CONCINO_INLINE tetrahedralize_steps::tetrahedralize_steps(const tetrahedralize_options& o) : options_(o) {
  const auto check = [](const char* name, double x, bool is_allowed, const char* range) {
    if (!is_allowed)
      core::throw_joined<invalid_argument>(
          {"tetrahedralize: ", name, " is ", core::number_text(x), "; it must be ", range});
  };
  check("radius_edge", o.radius_edge, o.radius_edge == 0 || (o.radius_edge >= 1 && std::isfinite(o.radius_edge)),
        "0 or at least 1");
  check("min_dihedral_deg", o.min_dihedral_deg, o.min_dihedral_deg >= 0 && o.min_dihedral_deg < 70,
        "0 or more, and below 70");
  check("max_volume", o.max_volume, o.max_volume >= 0 && std::isfinite(o.max_volume), "0 or more");
  check("max_seconds", o.max_seconds, o.max_seconds > 0, "above 0");
  for (const tet_region& r : o.regions)
    check("the max_volume of a region", r.max_volume, r.max_volume >= 0 && std::isfinite(r.max_volume), "0 or more");
  report_progress(o.progress, 0, "tetrahedralizing");
}
CONCINO_INLINE void tetrahedralize_steps::end_of_check() { checked_ = clock::now(); }
CONCINO_INLINE void tetrahedralize_steps::end_of_back_end() { filled_ = clock::now(); }
CONCINO_INLINE void tetrahedralize_steps::end_of_verification(tetrahedralize_report& report) {
  const auto seconds = [](clock::duration d) { return std::chrono::duration<double>(d).count(); };
  report.seconds_of_check = seconds(checked_ - start_);
  report.seconds_of_back_end = seconds(filled_ - checked_);
  report.seconds_of_verification = seconds(clock::now() - filled_);
  report_progress(options_.progress, 1, "tetrahedralizing");
}

CONCINO_INLINE void list_poor_tets(const tetmesh& m, std::span<const std::uint32_t> regions,
                                   const tetrahedralize_options& o, tetrahedralize_report& report) {
  const bool shapes = o.radius_edge > 0 || o.min_dihedral_deg > 0 || o.edge_length;
  if (!shapes && o.max_volume == 0 && regions.empty()) return;
  const double largest_cosine = std::cos((o.min_dihedral_deg - 1e-6) * std::numbers::pi / 180);
  for (const poly_id p : polys(m)) {
    vec3 q[4];
    std::size_t n = 0;
    for (const vert_id v : adj_p2v(m, p)) q[n++] = point(m, v);
    double allowed = o.max_volume;
    if (!regions.empty() && regions[p.raw()] < o.regions.size() && o.regions[regions[p.raw()]].max_volume > 0)
      allowed = o.regions[regions[p.raw()]].max_volume;
    if (allowed > 0 && !(dot(q[1] - q[0], cross(q[2] - q[0], q[3] - q[0])) <= 6 * allowed * (1 + 1e-9)))
      report.beyond_max_volume.push_back(p);
    if (!shapes) continue;
    double shortest = std::numeric_limits<double>::infinity(), longest = 0, cosine = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        shortest = std::min(shortest, norm(q[i] - q[j]));
        longest = std::max(longest, norm(q[i] - q[j]));
        std::size_t others[2], k = 0;  // the angle at edge ij lies between the parts of the directions to the other two
                                       // that are normal to it
        for (std::size_t x = 0; x < 4; ++x)
          if (x != i && x != j) others[k++] = x;
        const vec3 axis = q[j] - q[i];
        const auto across = [&](const vec3& u) { return u - axis * (dot(u, axis) / dot(axis, axis)); };
        const vec3 a = across(q[others[0]] - q[i]), b = across(q[others[1]] - q[i]);
        cosine = std::max(cosine, dot(a, b) / (norm(a) * norm(b)));
      }
    if (o.edge_length && !(longest <= o.edge_length((q[0] + q[1] + q[2] + q[3]) / 4) * (1 + 1e-9)))
      report.beyond_edge_length.push_back(p);
    if (o.min_dihedral_deg > 0 && !(cosine <= largest_cosine)) report.beyond_min_dihedral.push_back(p);
    if (o.radius_edge > 0 && !(norm(circumcentre(m, p) - q[0]) <= o.radius_edge * (1 + 1e-9) * shortest))
      report.beyond_radius_edge.push_back(p);
  }
}

CONCINO_INLINE void describe_missed_bounds(std::size_t num_tets, bool is_boundary_kept, tetrahedralize_report& report) {
  const auto add = [&](const std::vector<poly_id>& tets, const char* one, const char* several, const char* what) {
    if (tets.empty()) return;
    if (report.not_met.empty()) report.not_met = core::joined({"Of ", num_tets, num_tets == 1 ? " tet, " : " tets, "});
    else report.not_met.append(", ");
    report.not_met.append(core::joined({tets.size(), tets.size() == 1 ? one : several, what}));
  };
  add(report.beyond_max_volume, " is", " are", " larger than max_volume");
  add(report.beyond_edge_length, " has", " have", " an edge longer than edge_length");
  add(report.beyond_radius_edge, " is", " are", " beyond radius_edge");
  add(report.beyond_min_dihedral, " has", " have", " an angle below min_dihedral_deg");
  if (report.not_met.empty()) return;
  report.not_met.append(
      is_boundary_kept ? "; the boundary is kept as it is, and keep_boundary = false lets it get more verts." : ".");
}

}  // namespace concino::detail
