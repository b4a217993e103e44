// Cuts a surface along a level set.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets/clip_options.hpp>
#include <concino/level_sets/detail/clip/clip_verts.hpp>
#include <concino/level_sets/detail/cut/crossed_surface_reader.hpp>
#include <concino/level_sets/detail/cut/poly_parts.hpp>

#include <utility>
#include <vector>

namespace concino::detail {

/// The polys of the result are those that are kept whole, in the order of m, and then parts of polys.
template<class M, class U>
class surface_clipper {
  const M& m_;
  double level_;
  bool both_;
  std::vector<unsigned char> states_;
  crossed_surface_reader<M> crossed_;
  poly_cuts cuts_;
  std::vector<poly_t<M>> whole_;
  std::vector<std::uint32_t> cut_;  // parts
  clipped_surface<M> result_;

 public:
  surface_clipper(const M& m, const U& u, double level, bool both, const char* caller)
      : m_(m), level_(level), both_(both), states_(level_states(m, u, level, caller)),
        crossed_(m, u, level, crossed_polys(m, states_)), cuts_(crossed_.arrays, level) {}

  clipped_surface<M> run(const clip_options& options, const char* caller) {
    report_concave_polys(options, caller);
    const poly_parts parts(cuts_);
    for (const std::uint32_t v : parts.moved_verts) result_.report.moved_verts.push_back(crossed_.verts[v]);
    report_progress(options.progress, 0.3, "clipping");
    clip_verts<M, crossed_surface> verts_of(m_, crossed_.arrays, parts.places, level_);
    choose_polys(parts, verts_of);
    verts_of.number();
    verts_of.list([&](const level_place& x) { return crossed_.origins_of(x, level_); });
    build(parts, verts_of);
    report_progress(options.progress, 0.8, "clipping");
    list_cut_edges(parts, verts_of);
    if (options.properties) transfer_if_any(m_, result_.mesh, result_.from);
    report_progress(options.progress, 1, "clipping");
    return std::move(result_);
  }

 private:
  /// A poly that no chord cuts does not count.
  void report_concave_polys(const clip_options& options, const char* caller) {
    std::vector<vec3> corners;
    std::vector<unsigned char> is_cut(crossed_.polys.size(), 0);
    for (const poly_cuts::chord& c : cuts_.chords()) is_cut[c.poly] |= c.cuts;
    for (std::uint32_t p = 0; p < is_cut.size(); ++p) {
      if (!is_cut[p]) continue;
      ++result_.report.cut_polys;
      corners.clear();
      for (std::uint32_t k = crossed_.arrays.first_corner[p]; k < crossed_.arrays.first_corner[p + 1]; ++k)
        corners.push_back(crossed_.arrays.points[crossed_.arrays.verts[k]]);
      if (is_convex_polygon(corners)) continue;
      if (options.convex_only) throw_not_convex(caller, index_of(m_, crossed_.polys[p]));
      ++result_.report.concave_polys;
    }
  }

  void choose_polys(const poly_parts& parts, clip_verts<M, crossed_surface>& verts_of) {
    const auto keep = [&](const poly_t<M>& p, bool above) {
      if (!above && !both_) return;
      for (const vert_t<M> v : adj_p2v(m_, p)) verts_of.mark(v);
      whole_.push_back(p);
      result_.above.push_back(above);
    };
    std::size_t next = 0, part = 0;
    for (const poly_t<M> p : polys(m_)) {
      if (next == crossed_.polys.size() || !(crossed_.polys[next] == p)) {
        const auto& ring = adj_p2v(m_, p);
        const vert_t<M> first = *ring.begin();
        keep(p, states_[index_of(m_, first)] != below_level);
        continue;
      }
      for (; part < parts.parts.size() && parts.parts[part].poly == next; ++part) {
        const poly_parts::part& x = parts.parts[part];
        if (x.is_whole) keep(p, x.is_above);
        else if (x.is_above || both_) cut_.push_back(static_cast<std::uint32_t>(part));
      }
      ++next;
    }
    for (const std::uint32_t i : cut_)
      for (std::uint32_t k = parts.parts[i].first; k < parts.parts[i].last; ++k)
        verts_of.mark_place(parts.part_places[k]);
  }

  void build(const poly_parts& parts, clip_verts<M, crossed_surface>& verts_of) {
    surface_arrays a;
    a.offsets.push_back(0);
    for (const poly_t<M>& p : whole_) {
      for (const vert_t<M> v : adj_p2v(m_, p)) a.verts.push_back(verts_of.of(v));
      a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
      result_.from.polys.add(static_cast<std::uint32_t>(index_of(m_, p)));
    }
    for (const std::uint32_t i : cut_) {
      const poly_parts::part& x = parts.parts[i];
      for (std::uint32_t k = x.first; k < x.last; ++k) a.verts.push_back(verts_of.of_place(parts.part_places[k]));
      a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
      result_.above.push_back(x.is_above);
    }
    a.points = std::move(verts_of.points);
    result_.from.verts = std::move(verts_of.origins);
    result_.mesh = polygonmesh(std::move(a));
    for (std::size_t i = 0; i < cut_.size(); ++i) {
      const poly_id p{whole_.size() + i};
      const poly_t<M>& q = crossed_.polys[parts.parts[cut_[i]].poly];
      const double size = area(result_.mesh, p);
      if (!(dot(area_vector(result_.mesh, p), area_vector(m_, q)) > 0)) ++result_.report.inverted_parts;
      result_.from.polys.add({origin{static_cast<std::uint32_t>(index_of(m_, q)), size > 0 ? size : 0}});
    }
    match_edges_and_faces(m_, result_.mesh, result_.from);
  }

  void list_cut_edges(const poly_parts& parts, const clip_verts<M, crossed_surface>& verts_of) {
    std::vector<unsigned char> is_listed(num_edges(result_.mesh), 0);
    for (const auto& [x, y] : parts.cut_edges) {
      const vert_id a = verts_of.of_place(x), b = verts_of.of_place(y);
      if (a.is_none() || b.is_none()) continue;
      for (const edge_id e : adj_v2e(result_.mesh, a)) {
        const auto ends = end_verts(result_.mesh, e);
        if ((ends.first != b && ends.second != b) || is_listed[e.raw()]) continue;
        is_listed[e.raw()] = 1;
        result_.cut_edges.push_back(e);
      }
    }
  }
};

}  // namespace concino::detail
