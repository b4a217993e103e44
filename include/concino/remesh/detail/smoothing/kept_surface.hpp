// What verts that slide keep: the surface of the input, which is the mesh itself or the boundary and the interfaces of
// a volume, and its lines.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/remesh/detail/feature_lines.hpp>
#include <concino/remesh/detail/smoothing/feature_polylines.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// Whether the two polys at e, if there are two, run along it in opposite directions, as they do where the surface is
/// consistently oriented.
template<class M>
bool runs_both_ways(const M& m, const edge_t<M>& e) {
  const auto [a, b] = end_verts(m, e);
  unsigned forward = 0, backward = 0;
  for (const poly_t<M> p : adj_e2p(m, e)) {
    vert_t<M> before{};
    for (const vert_t<M> v : adj_p2v(m, p)) before = v;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      forward += before == a && v == b, backward += before == b && v == a;
      before = v;
    }
  }
  return forward + backward != 2 || forward == 1;
}

enum class vert_motion : std::uint8_t {
  space,  // anywhere: a vert inside a volume
  surface,
  line,
  none,
};

class kept_surface {
  static constexpr unsigned none = std::numeric_limits<unsigned>::max();

  polygonmesh mesh_;
  std::optional<poly_tree<polygonmesh>> tree_;
  std::vector<bool> is_line_;       // by edge
  std::vector<unsigned> patches_;   // by poly: polys with one number are connected by edges that are not part of lines
  std::vector<unsigned> patch_of_;  // by vert that moves over the surface
  std::vector<vec3> normals_;       // by vert that moves over the surface, of either sign
  std::optional<feature_polylines> lines_;

  bool is_sharp(const edge_id& e, double least_cosine) const {
    vec3 normals[2];
    unsigned n = 0;
    for (const poly_id p : adj_e2p(mesh_, e)) {
      if (n < 2) normals[n] = concino::normal(mesh_, p);
      ++n;
    }
    return n != 2 || (runs_both_ways(mesh_, e) ? 1 : -1) * dot(normals[0], normals[1]) < least_cosine;
  }

  void find_patches() {
    patches_.assign(num_polys(mesh_), none);
    std::vector<poly_id> found;
    unsigned patch = 0;
    for (const poly_id seed : polys(mesh_)) {
      if (patches_[seed.raw()] != none) continue;
      patches_[seed.raw()] = patch;
      found.assign(1, seed);
      while (!found.empty()) {
        const poly_id p = found.back();
        found.pop_back();
        for (const edge_id e : adj_p2e(mesh_, p)) {
          if (is_line_[e.raw()]) continue;
          for (const poly_id q : adj_e2p(mesh_, e))
            if (patches_[q.raw()] == none) patches_[q.raw()] = patch, found.push_back(q);
        }
      }
      ++patch;
    }
  }

 public:
  struct place {
    vec3 point, normal;
    double along = 0;
  };

  kept_surface(const kept_surface&) = delete;  // the tree refers to the mesh
  kept_surface& operator=(const kept_surface&) = delete;

  /// surface: its verts have the numbers of those of the mesh that is smoothed. named: edges of lines besides sharp
  /// ones, anywhere in the mesh. stays: by vert, whether it may not move.
  kept_surface(polygonmesh surface, vert_pairs named, double angle_deg, std::vector<bool> stays)
      : mesh_(std::move(surface)), is_line_(num_edges(mesh_)), patch_of_(num_verts(mesh_), none) {
    tree_.emplace(mesh_);
    for (auto& [a, b] : named)
      if (b < a) std::swap(a, b);
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    std::vector<bool> is_on_surface(named.size());
    const double least_cosine = angle_deg >= 180 ? -2 : std::cos(angle_deg * std::numbers::pi / 180);
    vert_pairs on_lines = named;
    std::vector<bool> has_line(num_verts(mesh_));
    for (const edge_id e : edges(mesh_)) {
      const auto [a, b] = end_verts(mesh_, e);
      const std::pair<unsigned, unsigned> ends = std::minmax({a.raw(), b.raw()});
      const auto at = std::lower_bound(named.begin(), named.end(), ends);
      const bool is_named = at != named.end() && *at == ends;
      if (is_named) is_on_surface[static_cast<std::size_t>(at - named.begin())] = true;
      is_line_[e.raw()] = is_named || is_sharp(e, least_cosine);
      if (is_line_[e.raw()]) on_lines.emplace_back(ends);
    }
    find_patches();
    for (const auto& [a, b] : on_lines) has_line[a] = has_line[b] = true;
    normals_.resize(num_verts(mesh_));
    for (const vert_id v : verts(mesh_)) {
      const unsigned i = v.raw();
      vec3 sum;
      for (const poly_id p : adj_v2p(mesh_, v)) {
        const vec3 n = concino::normal(mesh_, p);
        sum += (dot(n, sum) < 0 ? -1.0 : 1.0) * n;
        patch_of_[i] = patches_[p.raw()];
      }
      if (patch_of_[i] == none) continue;
      if (!feature_lines<polygonmesh>::is_one_fan(mesh_, v)) stays[i] = true;
      const double size = norm(sum);
      if (size > 0) normals_[i] = sum / size;
    }
    for (std::size_t k = 0; k < named.size(); ++k)
      if (!is_on_surface[k])  // it meets the surface at its ends
        for (const unsigned v : {named[k].first, named[k].second})
          if (patch_of_[v] != none) stays[v] = true;
    std::vector<vec3> points;
    for (const vert_id v : verts(mesh_)) points.push_back(concino::point(mesh_, v));
    lines_.emplace(points, std::move(on_lines), stays, std::max(least_cosine, 0.0));
    for (unsigned i = 0; i < stays.size(); ++i)
      motions.push_back(stays[i]               ? vert_motion::none
                        : lines_->has(i)       ? vert_motion::line
                        : has_line[i]          ? vert_motion::none
                        : patch_of_[i] == none ? vert_motion::space
                                               : vert_motion::surface);
  }

  std::vector<vert_motion> motions;  // by vert

  const polygonmesh& mesh() const { return mesh_; }
  bool is_on_line(const edge_id& e) const { return is_line_[e.raw()]; }
  vec3 closest(const vec3& x) const { return tree_->closest(x).point; }
  vec3 normal(unsigned v) const { return normals_[v]; }
  vec3 tangent(unsigned v) const { return lines_->tangent(v); }

  /// Where v comes to be if it moves from x by `step`. Returns false if this is no place for it: past a neighbour on
  /// its line, or in another part of the surface.
  bool find_place(unsigned v, const vec3& x, const vec3& step, place& to) const {
    if (motions[v] == vert_motion::line) {
      const auto [along, is_possible] = lines_->moved(v, dot(step, tangent(v)));
      to.along = along, to.point = lines_->point(v, along);
      return is_possible;
    }
    to.point = x + step;
    if (motions[v] == vert_motion::space) return true;
    const auto hit = tree_->closest(to.point);
    to.point = hit.point, to.normal = concino::normal(mesh_, hit.poly);
    return patches_[hit.poly.raw()] == patch_of_[v];
  }

  void set(unsigned v, const place& to) {
    if (motions[v] == vert_motion::line) lines_->set(v, to.along);
    else normals_[v] = to.normal;
  }

  /// The numbers of the fans in which the polys at v lie, in the order of `polys`: two of them are in one fan if edges
  /// at v that are not on lines connect them.
  void find_fans(const vert_id& v, const std::vector<poly_id>& polys, std::vector<unsigned>& fans) const {
    fans.assign(polys.size(), none);
    std::vector<std::size_t> found;
    unsigned fan = 0;
    for (std::size_t seed = 0; seed < polys.size(); ++seed) {
      if (fans[seed] != none) continue;
      fans[seed] = fan;
      found.assign(1, seed);
      while (!found.empty()) {
        const poly_id p = polys[found.back()];
        found.pop_back();
        for (const edge_id e : adj_p2e(mesh_, p)) {
          const auto [a, b] = end_verts(mesh_, e);
          if (is_line_[e.raw()] || (a != v && b != v)) continue;
          for (const poly_id q : adj_e2p(mesh_, e)) {
            const auto i = static_cast<std::size_t>(std::find(polys.begin(), polys.end(), q) - polys.begin());
            if (fans[i] == none) fans[i] = fan, found.push_back(i);
          }
        }
      }
      ++fan;
    }
  }
};

}  // namespace concino::detail
