// Limits of smooth subdivision: how the ring around a vert, after one step, gives the point and the tangent plane of the smooth surface.
#pragma once

#include <concino/generate/detail/read_sectors.hpp>
#include <concino/generate/detail/smooth_rules.hpp>
#include <concino/generate/detail/subdivision.hpp>

#include <cmath>
#include <numbers>
#include <span>

namespace concino::detail {

/// A vert after one step of subdivision, with the new verts around it, counter-clockwise: of its edges, and of its polys, of which poly k is between
/// edges k and k + 1. On the boundary there is one edge more than polys.
struct limit_ring {
  vec3 vert;
  std::span<const vec3> edges, polys;
  bool is_closed = false;
};

/// The weights of the ring that give the tangents of a scheme. For edge k they are sin or cos of k times the angle, which is a full or half turn divided by the
/// number of polys, and for the polys `poly` times the sum of those of their two edges. They are left eigenvectors of one step, for the eigenvalue `value`.
/// At the boundary, the first and the last edge and the vert have weights of their own.
struct tangent_masks {
  double angle, value, poly;

  vec3 sum(const limit_ring& r, double (*wave)(double)) const {
    vec3 t;
    for (std::size_t k = 0; k < r.edges.size(); ++k) t += wave(static_cast<double>(k) * angle) * r.edges[k];
    for (std::size_t k = 0; k < r.polys.size(); ++k)
      t += poly * (wave(static_cast<double>(k) * angle) + wave(static_cast<double>(k + 1) * angle)) * r.polys[k];
    return t;
  }
};

struct loop_masks {
  static tangent_masks at(double angle) { return {angle, 0.375 + 0.25 * std::cos(angle), 0}; }
  /// The parts of a new vert that come from an old edge at the vert and from the vert: for the boundary, where all rules are summed along the fan.
  static constexpr double edge_to_end = 0.125, edge_to_vert = 0.375;
  static vec3 inner_point(const limit_ring& r) {
    const double n = static_cast<double>(r.edges.size()), root = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n), moved = 0.625 - root * root;
    const double own = 0.375 * n / moved;
    vec3 sum = own * r.vert;
    for (const vec3& x : r.edges) sum += x;
    return sum / (own + n);
  }
};

struct catmull_clark_masks {
  static tangent_masks at(double angle) {
    const double c = std::cos(angle), value = (5 + c + std::sqrt((c + 9) * (c + 1))) / 16;
    return {angle, value, 1 / (16 * value - 4)};
  }
  static constexpr double edge_to_end = 0.0625, edge_to_vert = 0.375;
  static vec3 inner_point(const limit_ring& r) {
    const double n = static_cast<double>(r.edges.size());
    vec3 sum = n * n * r.vert;
    for (const vec3& x : r.edges) sum += 4.0 * x;
    for (const vec3& x : r.polys) sum += x;
    return sum / (n * (n + 5));
  }
};

/// A tangent at a boundary vert that points into the surface.
template<class Masks>
vec3 inward_tangent(const limit_ring& r) {
  const vec3 ends = r.edges.front() + r.edges.back();
  if (r.polys.size() == 1) return ends - 2.0 * r.vert;
  const tangent_masks masks = Masks::at(std::numbers::pi / static_cast<double>(r.polys.size()));
  // Those inside have the weights of a sine, as if the ring were closed by its mirror image. The weights x of the two ends and y of the vert then follow from
  //   (value - 1/2) x = y / 8 + at_end,   (value - 3/4) y = x + at_vert,
  // where at_end and at_vert are what the new verts inside take from an end and from the vert.
  double edges = 0;
  for (std::size_t k = 1; k + 1 < r.edges.size(); ++k) edges += std::sin(static_cast<double>(k) * masks.angle);
  const double s = std::sin(masks.angle);
  const double at_end = Masks::edge_to_end * s + masks.poly * s / 4, at_vert = Masks::edge_to_vert * edges + masks.poly * edges / 2;
  const double a = masks.value - 0.5, b = masks.value - 0.75;
  const double x = -(at_vert + 8 * b * at_end) / (1 - 8 * a * b), y = 8 * (a * x - at_end);
  return masks.sum(r, [](double angle) { return std::sin(angle); }) + x * ends + y * r.vert;
}

template<class Masks>
vec3 limit_normal(const limit_ring& r) {
  vec3 normal;
  if (r.is_closed) {
    const tangent_masks masks = Masks::at(2 * std::numbers::pi / static_cast<double>(r.edges.size()));
    if (r.edges.size() < 3) return normal;
    normal = cross(masks.sum(r, [](double angle) { return std::cos(angle); }), masks.sum(r, [](double angle) { return std::sin(angle); }));
  } else {
    normal = cross(r.edges.front() - r.edges.back(), inward_tangent<Masks>(r));
  }
  const double length = norm(normal);
  return length > 0 ? normal / length : vec3();
}

/// The limits at all verts.
template<class Masks, class Result, class M, class Rule>
Result limit_of(const M& m, const Rule& rule) {
  const auto stepped = [&](const auto& x) {
    vec3 sum;
    rule(x, [&](const vert_t<M>& v, double weight) { sum += weight * to_vec3(point(m, v)); });
    return sum;
  };
  auto edge_points = make_edge_map<vec3>(m);
  parallel_for_each(edges(m), [&](const edge_t<M>& e) { edge_points[e] = stepped(e); });
  std::vector<vec3> poly_points;  // by position; the sectors name polys by it
  auto number = make_poly_map<std::uint32_t>(m);
  for (const poly_t<M> p : polys(m)) {
    number[p] = static_cast<std::uint32_t>(poly_points.size());
    if constexpr (std::is_same_v<Masks, catmull_clark_masks>) poly_points.push_back(stepped(p));
    else poly_points.emplace_back();  // Loop's rules do not use them
  }
  std::vector<unsigned char> polys_at(edge_index_bound(m));
  for (const edge_t<M> e : edges(m)) polys_at[index_of(m, e)] = static_cast<unsigned char>(std::min<std::size_t>(num_elements(adj_e2p(m, e)), 3));
  sector_fans fans(vert_index_bound(m));
  read_sectors(m, [&](const poly_t<M>& p) { return number[p]; }, fans);
  const sharp_edges<M, no_creases> sharp{m, no_creases()};
  Result result{make_vert_map<vec3>(m), make_vert_map<vec3>(m)};
  std::vector<vec3> around_edges, around_polys;
  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    const fan_kind kind = fans.arrange(i, [&](std::uint32_t e) { return polys_at[e] != 2; });
    const auto at = sharp(v);
    limit_ring r{stepped(v), {}, {}, kind == fan_kind::closed};
    around_edges.clear(), around_polys.clear();
    for (const edge_t<M> e : adj_v2e(m, v)) around_edges.push_back(edge_points[e]);
    for (const sector& s : fans[i]) around_polys.push_back(poly_points[s.poly]);
    r.edges = around_edges, r.polys = around_polys;
    if (at.edges == 0 || at.sharp > 2) result.points[v] = r.vert;
    else if (at.sharp < 2) result.points[v] = Masks::inner_point(r);
    else {
      vec3 ends;
      for (const edge_t<M> e : adj_v2e(m, v))
        if (sharp[e]) ends += edge_points[e];
      result.points[v] = (4.0 * r.vert + ends) / 6;
    }
    if (kind == fan_kind::broken || at.sharp > 2) continue;
    // In cyclic order.
    around_edges.clear();
    for (const sector& s : fans[i]) around_edges.push_back(edge_points.values()[s.in]);
    if (kind == fan_kind::open) around_edges.push_back(edge_points.values()[fans[i].back().out]);
    r.edges = around_edges;
    result.normals[v] = limit_normal<Masks>(r);
  }
  return result;
}

}  // namespace concino::detail
