// Where new verts of smooth subdivisions of surfaces lie: the rules of Loop and of Catmull and Clark, at boundaries and
// creases too.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>

#include <cmath>
#include <numbers>

namespace concino::detail {

/// The end of e that is not v.
template<class M>
vert_t<M> other_end(const M& m, const edge_t<M>& e, const vert_t<M>& v) {
  const auto [a, b] = end_verts(m, e);
  return a == v ? b : a;
}

/// Which edges are sharp: creases, and those with one poly or more than two.
template<class M, class Creases>
struct sharp_edges {
  const M& m;
  const Creases& creases;

  bool operator[](const edge_t<M>& e) const { return creases[e] || num_elements(adj_e2p(m, e)) != 2; }

  /// The edges at a vert, the sharp ones among them, and the other ends of the first two of these.
  struct around {
    std::size_t edges = 0, sharp = 0;
    vert_t<M> ends[2];
  };
  around operator()(const vert_t<M>& v) const {
    around found;
    for (const edge_t<M> e : adj_v2e(m, v)) {
      ++found.edges;
      if (!(*this)[e]) continue;
      if (found.sharp < 2) found.ends[found.sharp] = other_end(m, e, v);
      ++found.sharp;
    }
    return found;
  }
};

/// The rule of verts on sharp edges, that of cubic splines: they follow the curve of two sharp edges, and do not move
/// where more than two meet. Returns false if fewer than two sharp edges meet at v.
template<class Around, class V, class Take>
bool take_sharp(const Around& at, const V& v, const Take& take) {
  if (at.edges == 0 || at.sharp > 2) {
    take(v, 1.0);
  } else if (at.sharp == 2) {
    take(v, 0.75), take(at.ends[0], 0.125), take(at.ends[1], 0.125);
  } else {
    return false;
  }
  return true;
}

/// Source: Loop 1987, "Smooth subdivision surfaces based on triangles"; creases by Hoppe et al. 1994, "Piecewise smooth
///         surface reconstruction".
template<class M, class Creases>
struct loop_rule {
  const M& m;
  const Creases& creases;

  template<class Take>
  void operator()(const edge_t<M>& e, const Take& take) const {
    const auto [a, b] = end_verts(m, e);
    const bool is_sharp = sharp_edges<M, Creases>{m, creases}[e];
    const double weight = is_sharp ? 0.5 : 0.375;
    take(a, weight), take(b, weight);
    if (is_sharp) return;
    for (const poly_t<M> p : adj_e2p(m, e))
      for (const vert_t<M> v : adj_p2v(m, p))
        if (v != a && v != b) take(v, 0.125);
  }
  template<class Take>
  void operator()(const vert_t<M>& v, const Take& take) const {
    const auto at = sharp_edges<M, Creases>{m, creases}(v);
    if (take_sharp(at, v, take)) return;
    const double n = static_cast<double>(at.edges), root = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n),
                 moved = 0.625 - root * root;
    take(v, 1 - moved);
    for (const vert_t<M> w : adj_v2v(m, v)) take(w, moved / n);
  }
};

/// Source: Catmull, Clark 1978, "Recursively generated B-spline surfaces on arbitrary topological meshes"; creases by
///         DeRose, Kass, Truong 1998,
/// "Subdivision surfaces in character animation".
template<class M, class Creases>
struct catmull_clark_rule {
  const M& m;
  const Creases& creases;

  template<class Take>
  void operator()(const poly_t<M>& p, const Take& take) const {
    take_poly(p, 1, take);
  }
  template<class Take>
  void operator()(const edge_t<M>& e, const Take& take) const {
    const auto [a, b] = end_verts(m, e);
    const bool is_sharp = sharp_edges<M, Creases>{m, creases}[e];
    const double weight = is_sharp ? 0.5 : 0.25;
    take(a, weight), take(b, weight);
    if (is_sharp) return;
    for (const poly_t<M> p : adj_e2p(m, e)) take_poly(p, 0.25, take);
  }
  template<class Take>
  void operator()(const vert_t<M>& v, const Take& take) const {
    const auto at = sharp_edges<M, Creases>{m, creases}(v);
    if (take_sharp(at, v, take)) return;
    // (n - 3) / n of the vert, 2 / n of the mean of the midpoints of its edges, 1 / n of the mean of its polys
    const double n = static_cast<double>(at.edges);
    take(v, (n - 2) / n);
    for (const vert_t<M> w : adj_v2v(m, v)) take(w, 1 / (n * n));
    const auto& around = adj_v2p(m, v);
    const double of_poly = 1 / (n * static_cast<double>(num_elements(around)));
    for (const poly_t<M> p : around) take_poly(p, of_poly, take);
  }

 private:
  template<class Take>
  void take_poly(const poly_t<M>& p, double weight, const Take& take) const {
    const auto& corners = adj_p2v(m, p);
    const double each = weight / static_cast<double>(num_elements(corners));
    for (const vert_t<M> v : corners) take(v, each);
  }
};

}  // namespace concino::detail
