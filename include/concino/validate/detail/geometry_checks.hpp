// Checks of the shape of elements: points, lengths, areas, volumes, planarity, self-intersecting polygons.
#pragma once

#include <concino/core/local_points.hpp>
#include <concino/core/message.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/validate/detail/defect_log.hpp>
#include <concino/validate/detail/hex_orders.hpp>
#include <concino/validate/detail/self_intersection_finder.hpp>

#include <array>
#include <optional>

namespace concino::detail {

/// Checks one polygon after another: polys of a surface, faces of a volume.
template<class M>
class polygon_checks {
  core::local_points local_;
  std::vector<plane_point> flat_;
  self_intersection_finder self_intersection_;

 public:
  template<class X, class Ring>
  void operator()(const M& m, const X& x, const Ring& ring, defect_log<M>& log) {
    std::vector<vec3>& points = local_.points;
    points.clear();
    for (const vert_t<M> v : ring) points.push_back(to_vec3(point(m, v)));
    const std::size_t n = points.size();
    for (const vec3& p : points)
      if (!is_finite(p)) return;  // reported at the vert
    if (n < 3) return;            // reported as degenerate
    const auto add_zero = [&](const char* why) {
      if (defect<M>* d = log.add(defect_kind::zero_size, x))
        d->what = core::joined({log.name(x), " has no area: ", why});
    };
    const bool is_degenerate = n == 3 && core::is_degenerate_simplex(points);  // before fit changes them
    if (!local_.fit()) return add_zero("its verts are all at one point");

    const vec3 area = core::vector_area(points, 0, n);
    const double size = local_.size, length = norm(area);
    const bool no_area = n == 3 ? is_degenerate : local_.is_zero_area(area, n);
    if (n == 3) {
      if (no_area) return add_zero("its verts lie on one line");
      if (length <= log.options().size_tolerance * size * size) add_zero(below_tolerance().c_str());
      return;
    }
    const vec3 normal = no_area ? widest_normal() : area / length;
    if (no_area && normal == vec3()) return add_zero("its verts lie on one line");

    double off = 0;
    vec3 mean;
    for (const vec3& p : points) mean += p / static_cast<double>(n);
    for (const vec3& p : points) off = std::max(off, std::abs(dot(p - mean, normal)));
    const bool bent = off > 1e-9 * size;
    const auto touch = find_self_intersection(normal, bent);
    if (touch) {
      if (defect<M>* d = log.add(defect_kind::self_touching, x))
        d->what = core::joined(
            {log.name(x),
             bent ? ", seen along its normal, touches or crosses itself: " : " touches or crosses itself: ",
             side_name(m, ring, touch->first, n, log), " meets ", side_name(m, ring, touch->second, n, log)});
    } else if (no_area) {
      add_zero("its parts cancel out");
    } else if (length <= log.options().size_tolerance * size * size) {
      add_zero(below_tolerance().c_str());
    }
    if (!no_area && off > log.options().planarity_tolerance * size)
      if (defect<M>* d = log.add(defect_kind::non_planar, x))
        d->what = core::joined({log.name(x), " is not planar: a vert lies ",
                                core::number_text(rounded(100 * off / size)), " % of its size off its plane"});
  }

 private:
  static std::string below_tolerance() { return "it is below the tolerance"; }
  static double rounded(double x) { return std::round(x * 100) / 100; }

  /// A normal of the points for the case that their area vector is zero; zero if they lie on one line.
  vec3 widest_normal() const {
    const std::vector<vec3>& points = local_.points;
    vec3 farthest, best;
    for (const vec3& p : points)
      if (norm(p) > norm(farthest)) farthest = p;
    for (const vec3& p : points)
      if (const vec3 c = cross(farthest, p); norm(c) > norm(best)) best = c;
    return local_.is_zero_area(best, 3) ? vec3() : best / norm(best);
  }

  /// Projects along the normal. A planar polygon keeps its exact coordinates: the one in which the normal is largest is
  /// dropped, which neither creates nor removes a contact.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> find_self_intersection(const vec3& normal, bool bent) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    flat_.clear();
    if (bent) {
      vec3 t = cross(normal, x < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0});
      t /= norm(t);
      const vec3 b = cross(normal, t);
      for (const vec3& p : local_.points) flat_.push_back({dot(p, t), dot(p, b)});
    } else {
      const std::size_t out = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
      for (const vec3& p : local_.points) flat_.push_back({p[(out + 1) % 3], p[(out + 2) % 3]});
    }
    return self_intersection_(flat_);
  }

  template<class Ring>
  static std::string side_name(const M&, const Ring& ring, std::uint32_t side, std::size_t n,
                               const defect_log<M>& log) {
    std::string from, to;
    std::size_t i = 0;
    for (const vert_t<M> v : ring) {
      if (i == side) from = log.name(v);
      if (i == (side + 1) % n) to = log.name(v);
      ++i;
    }
    return core::joined({"the side from ", from, " to ", to});
  }
};

/// Whether a tet is degenerate; nothing for other polys.
template<VolumeMesh M>
std::optional<bool> is_degenerate_tet(const M& m, const poly_t<M>& p) {
  std::array<vec3, 4> corners;
  std::size_t n = 0;
  for (const vert_t<M> v : adj_p2v(m, p)) {
    if (n == corners.size()) return std::nullopt;
    corners[n++] = to_vec3(point(m, v));
  }
  return n == corners.size() ? std::optional(core::is_degenerate_simplex(corners)) : std::nullopt;
}

template<VolumeMesh M>
void check_cell_size(const M& m, const poly_t<M>& p, core::local_points& local,
                     std::vector<std::pair<std::size_t, bool>>& ends, defect_log<M>& log) {
  local.points.clear();
  ends.clear();
  for (const face_t<M> f : adj_p2f(m, p)) {
    for (const vert_t<M> v : adj_f2v(m, f)) local.points.push_back(to_vec3(point(m, v)));
    ends.push_back({local.points.size(), face_is_outward(m, p, f)});
  }
  for (const vec3& x : local.points)
    if (!is_finite(x)) return;
  double volume = 0;
  if (local.fit()) {
    std::size_t first = 0;
    for (const auto& [last, outward] : ends) {
      vec3 mean;
      for (std::size_t i = first; i < last; ++i) mean += local.points[i];
      const double part =
          last > first ? dot(mean / static_cast<double>(last - first), core::vector_area(local.points, first, last)) / 3
                       : 0;
      volume += outward ? part : -part;
      first = last;
    }
  }
  const double size = local.size, none = local.zero_volume(local.points.size());
  const bool is_flat = is_degenerate_tet(m, p).value_or(std::abs(volume) <= none);
  if (is_flat || std::abs(volume) <= log.options().size_tolerance * size * size * size) {
    if (defect<M>* d = log.add(defect_kind::zero_size, p))
      d->what = core::joined(
          {log.name(p), is_flat ? " has no volume: it is flat" : " has no volume: it is below the tolerance"});
  } else if (volume < 0) {
    if (defect<M>* d = log.add(defect_kind::inverted_cell, p))
      d->what =
          core::joined({log.name(p), " is inside out: its volume is negative, ",
                        core::number_text(std::round(-1e4 * volume / (local.box.x * local.box.y * local.box.z)) / 100),
                        " % of the box around it"});
  }
}

/// By index, the hexes whose corners look like a lexicographic order. Hexes that are only mirrored are reported as
/// inverted cells.
template<VolumeMesh M>
std::vector<std::uint8_t> check_hex_orders(const M& m, defect_log<M>& log) {
  std::vector<std::uint8_t> other(arity_v<M> == 8 ? poly_index_bound(m) : 0);
  if constexpr (arity_v<M> == 8) {  // only hexes have commonly confused orders
    hex_order_checks order_of;
    for (const poly_t<M> p : polys(m)) {
      const hex_order order = order_of(m, p);
      if (!is_lexicographic(order)) continue;
      other[index_of(m, p)] = 1;
      if (defect<M>* d = log.add(defect_kind::corner_order, p))
        d->what = core::joined({"the corners of hex ", index_of(m, p), " look like ", hex_order_remedy(order)});
    }
  }
  return other;
}

/// `encloses_volume`, by index: the polys of a volume that are closed and wound consistently; others enclose no volume.
template<AnyMesh M>
void check_geometry(const M& m, [[maybe_unused]] const std::vector<std::uint8_t>& encloses_volume, defect_log<M>& log) {
  log.begin_stage(1, num_verts(m) + num_edges(m) + num_polys(m));
  box all;
  for (const vert_t<M> v : verts(m)) {
    log.step();
    const vec3 x = to_vec3(point(m, v));
    if (is_finite(x)) all.add(x);
    else if (defect<M>* d = log.add(defect_kind::non_finite_point, v))
      d->what = core::joined({log.name(v), " is at (", core::number_text(x.x), ", ", core::number_text(x.y), ", ",
                              core::number_text(x.z), "), which is not finite"});
  }
  if (log.wants(defect_kind::zero_size)) {
    // a quarter cannot overflow
    const double shortest =
        all.is_empty() ? 0 : log.options().length_tolerance * distance(0.25 * all.min, 0.25 * all.max);
    for (const edge_t<M> e : edges(m)) {
      log.step();
      vec3 end[2];
      int k = 0;
      for (const vert_t<M> v : adj_e2v(m, e))
        if (k < 2) end[k++] = to_vec3(point(m, v));
      if (!is_finite(end[0]) || !is_finite(end[1]) ||
          (end[0] != end[1] && !(distance(0.25 * end[0], 0.25 * end[1]) <= shortest)))
        continue;
      if (defect<M>* d = log.add(defect_kind::zero_size, e))
        d->what = core::joined({log.edge_name(e), end[0] == end[1] ? " has no length: its ends are at one point"
                                                                   : " has no length: it is below the tolerance"});
    }
  }
  if (!log.wants_any({defect_kind::zero_size, defect_kind::inverted_cell, defect_kind::self_touching,
                      defect_kind::non_planar, defect_kind::corner_order}))
    return;
  polygon_checks<M> check_polygon;
  if constexpr (SurfaceMesh<M>) {  // polys of a surface are polygons; those of a volume have polygons as faces
    for (const poly_t<M> p : polys(m)) {
      log.step();
      check_polygon(m, p, adj_p2v(m, p), log);
    }
  } else {
    // In a hex of another order, faces and volume are meaningless.
    const std::vector<std::uint8_t> misread = check_hex_orders(m, log);
    const auto is_misread = [&](const poly_t<M>& p) { return !misread.empty() && misread[index_of(m, p)]; };
    for (const face_t<M> f : faces(m)) {
      bool of_misread = false;
      if (!misread.empty())
        for (const poly_t<M> p : adj_f2p(m, f)) of_misread = of_misread || is_misread(p);
      if (!of_misread) check_polygon(m, f, adj_f2v(m, f), log);
    }
    core::local_points local;
    std::vector<std::pair<std::size_t, bool>> ends;
    for (const poly_t<M> p : polys(m)) {
      log.step();
      if (encloses_volume[index_of(m, p)] && !is_misread(p)) check_cell_size(m, p, local, ends, log);
    }
  }
}

}  // namespace concino::detail
