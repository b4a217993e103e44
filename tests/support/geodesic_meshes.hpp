// Meshes of every kind with known geodesic distances: flat and round, like scans and like CAD models, graded, squeezed, jigsaw, with reentrant
// corners. docs/convergence.md shows the errors of heat geodesics on them, and tests compute some of these again.
#pragma once

#include <concino/edit/elements.hpp>
#include <concino/fields/exact_geodesics.hpp>
#include <concino/generate.hpp>

#include <support/kinds.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::testing {

/// A flat square of n x n polygons that interlock: each edge of a grid becomes a wave of `parts` short edges.
inline polygonmesh jigsaw(unsigned n, unsigned parts = 7, double amplitude = 0.16) {
  surface_arrays a;
  const double step = 1.0 / n;
  const auto corner = [&](unsigned i, unsigned j) { return vert_id{j * (n + 1) + i}; };
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) a.points.push_back({i * step, j * step, 0});
  // The verts inside the edge from a corner to the right, or up, in that order; on the border it is straight.
  const auto wave = [&](unsigned i, unsigned j, bool up) {
    const bool straight = up ? i == 0 || i == n : j == 0 || j == n;
    const double side = straight ? 0 : (i * 7 + j * 5 + up) % 2 ? amplitude : -amplitude;
    std::vector<vert_id> verts;
    for (unsigned k = 1; k < parts; ++k) {
      const double along = static_cast<double>(k) / parts, off = side * std::sin(6.28318530717958647692 * along);
      verts.push_back(vert_id{a.points.size()});
      a.points.push_back({step * (i + (up ? off : along)), step * (j + (up ? along : off)), 0});
    }
    return verts;
  };
  std::vector<std::vector<vert_id>> right, above;
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) {
      right.push_back(i < n ? wave(i, j, false) : std::vector<vert_id>());
      above.push_back(j < n ? wave(i, j, true) : std::vector<vert_id>());
    }
  a.offsets.push_back(0);
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const auto add = [&](vert_id first, const std::vector<vert_id>& rest, bool backward) {
        a.verts.push_back(first);
        if (backward) a.verts.insert(a.verts.end(), rest.rbegin(), rest.rend());
        else a.verts.insert(a.verts.end(), rest.begin(), rest.end());
      };
      add(corner(i, j), right[corner(i, j).raw()], false);
      add(corner(i + 1, j), above[corner(i + 1, j).raw()], false);
      add(corner(i + 1, j + 1), right[corner(i, j + 1).raw()], true);
      add(corner(i, j + 1), above[corner(i, j).raw()], true);
      a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
    }
  return polygonmesh(std::move(a));
}

/// A ball with bumps, of triangles of all sizes, as scanners make them.
inline trimesh bumpy_ball(unsigned level) {
  trimesh m = icosphere(level);
  jitter(m, 0.25, {.in_plane = false});
  for (const vert_id v : verts(m)) {
    vec3 x = point(m, v);
    x = x / norm(x);
    x = x + 0.25 * vec3{std::sin(2 * x.y), std::sin(3 * x.z), std::sin(2 * x.x)};  // some parts are finer than others
    x = x / norm(x);
    const double bumps = 0.18 * std::sin(4 * x.x + 1) * std::sin(5 * x.y) + 0.1 * std::sin(7 * x.z + x.x) + 0.03 * std::sin(17 * x.x) * std::sin(15 * x.z);
    set_point(m, v, (1 + bumps) * vec3{x.x, 0.7 * x.y, 1.3 * x.z});
  }
  return m;
}

/// A washer as CAD programs triangulate it: `around` quads per ring, two triangles each; few rings, so that triangles are long and thin.
inline trimesh washer(unsigned around, unsigned layers) {
  surface_arrays a{{}, {}, {}, 3};
  std::vector<std::pair<double, double>> profile;  // radius and height, once round the ring's section
  for (unsigned k = 0; k < layers; ++k) profile.emplace_back(1 - 0.6 * k / layers, 0.0);
  for (unsigned k = 0; k < layers; ++k) profile.emplace_back(0.4, 0.3 * k / layers);
  for (unsigned k = 0; k < layers; ++k) profile.emplace_back(0.4 + 0.6 * k / layers, 0.3);
  for (unsigned k = 0; k < layers; ++k) profile.emplace_back(1, 0.3 - 0.3 * k / layers);
  const auto rings = static_cast<unsigned>(profile.size());
  for (unsigned i = 0; i < around; ++i)
    for (const auto& [radius, height] : profile) {
      const double angle = 6.28318530717958647692 * i / around;
      a.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  for (unsigned i = 0; i < around; ++i)
    for (unsigned k = 0; k < rings; ++k) {
      const unsigned b = (i + 1) % around, l = (k + 1) % rings, p = i * rings + k, q = b * rings + k, r = b * rings + l, s = i * rings + l;
      for (const unsigned v : {p, r, q, p, s, r}) a.verts.push_back(vert_id{v});
    }
  return trimesh(std::move(a));
}

/// Removes the polys whose centroid is in the part, and the verts that have no polys left.
template<class M, class F>
void remove_part(M& m, const F& part) {
  std::vector<poly_id> gone;
  for (const poly_id p : polys(m))
    if (part(centroid(m, p))) gone.push_back(p);
  for (const poly_id p : gone) remove_poly(m, p);
  std::vector<vert_id> alone;
  for (const vert_id v : verts(m)) {
    bool has_edge = false;
    for ([[maybe_unused]] const vert_id w : adj_v2v(m, v)) has_edge = true;
    if (!has_edge) alone.push_back(v);
  }
  for (const vert_id v : alone) remove_vert(m, v);
}

using known_distance = std::function<double(const vec3&, const vec3&)>;

inline double straight(const vec3& a, const vec3& b) { return distance(a, b); }
inline double on_unit_sphere(const vec3& a, const vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }
/// The distance in a square, or cube, without the quarter where x and y are above 1/2: straight, or around the reentrant edge.
inline double round_the_corner(const vec3& a, const vec3& b) {
  const auto is_right = [](const vec3& x) { return x.x > 0.5; };
  if (is_right(a) == is_right(b)) return distance(a, b);
  const double share = (0.5 - a.x) / (b.x - a.x), at = a.y + share * (b.y - a.y);
  if (at <= 0.5) return distance(a, b);
  return std::hypot(std::hypot(a.x - 0.5, a.y - 0.5) + std::hypot(b.x - 0.5, b.y - 0.5), a.z - b.z);
}

/// Exact distances over a surface whose polys are divided into triangles at the means of their verts.
template<class M>
vert_map<M, double> exact_over_fans(const M& m, const vert_id& source) {
  surface_arrays a{{}, {}, {}, 3};
  a.points.resize(vert_index_bound(m));
  for (const vert_id v : verts(m)) a.points[index_of(m, v)] = point(m, v);
  for (const poly_id p : polys(m)) {
    const vert_id middle{a.points.size()};
    vec3 sum;
    std::vector<vert_id> ring;
    for (const vert_id v : adj_p2v(m, p)) {
      sum += point(m, v);
      ring.push_back(v);
    }
    a.points.push_back(sum / static_cast<double>(ring.size()));
    for (std::size_t k = 0; k < ring.size(); ++k) a.verts.insert(a.verts.end(), {middle, ring[k], ring[(k + 1) % ring.size()]});
  }
  const trimesh fans(std::move(a));
  const auto exact = exact_geodesics(fans, source);
  auto d = make_vert_map<double>(m, 0.0);
  for (const vert_id v : verts(m)) d[v] = exact[v];
  return d;
}

/// Calls use(name, mesh, source, known distances) for each mesh of a kind, with about `count` polys. The source is the vert nearest to a point.
template<class M, class Use>
void for_each_geodesic_mesh(unsigned count, const Use& use) {
  constexpr bool is_surface = dimension_v<M> == 2;
  const double polys_a_cube = std::is_same_v<M, tetmesh> ? 6 : 1, quads = std::is_same_v<M, trimesh> ? count / 2.0 : count;
  const auto n = static_cast<unsigned>(std::lround(is_surface ? std::sqrt(quads) : std::cbrt(count / polys_a_cube)));
  const auto report = [&](const std::string& name, const M& m, const vec3& from, const known_distance& known) {
    vert_id source{0};
    double least = std::numeric_limits<double>::infinity();
    for (const vert_id v : verts(m))
      if (const double d = distance(point(m, v), from); d < least) {
        least = d;
        source = v;
      }
    auto d = make_vert_map<double>(m, 0.0);
    if constexpr (std::is_same_v<M, trimesh>) {
      if (!known) d = exact_geodesics(m, source);
    } else if constexpr (is_surface) {
      if (!known) d = exact_over_fans(m, source);
    }
    if (known)
      for (const vert_id v : verts(m)) d[v] = known(point(m, source), point(m, v));
    use(name, m, source, d);
  };
  const vec3 corner{0, 0, 0}, inside{0.3, 0.4, is_surface ? 0 : 0.55}, low{0.8, 0.2, is_surface ? 0 : 0.3};
  const auto grid = [&] { return make_grid<M>({.cells = {n, n, n}}); };
  const auto quarter = [](const vec3& x) { return x.x > 0.5 && x.y > 0.5; };
  const auto even = n + n % 2;
  const auto even_grid = [&] { return make_grid<M>({.cells = {even, even, even}}); };
  const auto simplices = [&](unsigned polys) {
    using simplex = std::conditional_t<is_surface, trimesh, tetmesh>;
    const auto k = static_cast<unsigned>(std::lround(is_surface ? std::sqrt(polys / 2.0) : std::cbrt(polys / 6.0)));
    auto m = make_grid<simplex>({.cells = {k + k % 2, k + k % 2, k + k % 2}});
    jitter(m, is_surface ? 0.2 : 0.1);
    return m;
  };

  {
    M m = grid();
    jitter(m, is_surface ? 0.2 : 0.1);
    report("perturbed", m, inside, straight);
  }
  for (const double power : {2.0, 3.0}) {
    M m = grid();
    grade(m, {power, power, is_surface ? 1 : power});
    report(power == 2 ? "graded by squares" : "graded by cubes", m, corner, straight);
  }
  {
    M m = grid();
    for (const vert_id v : verts(m)) set_point(m, v, vec3{point(m, v).x, 0.05 * point(m, v).y, point(m, v).z});
    report("squeezed 1 to 20", m, {0.3, 0.02, is_surface ? 0 : 0.55}, straight);
  }
  {
    M m = even_grid();
    if constexpr (!std::is_same_v<M, polygonmesh>) {  // boundaries of hexagons do not fit the quarter
      remove_part(m, quarter);
      report("round a corner", m, low, round_the_corner);
    }
  }
  if constexpr (is_surface) {
    const auto cells = static_cast<std::size_t>(std::lround(std::sqrt(quads / 6)));
    const M sphere = make_sphere<M>({.cells = std::max<std::size_t>(cells, 2)});
    report("sphere", sphere, {0.3, 0.5, 1}, {});
    if constexpr (!std::is_same_v<M, trimesh>) report("sphere by great circles", sphere, {0.3, 0.5, 1}, on_unit_sphere);
  } else if constexpr (std::is_same_v<M, hexmesh>) {
    M m = make_sphere<M>({.cells = static_cast<std::size_t>(std::lround(std::cbrt(count / 4.0)))});
    report("ball", m, {0.3, 0.2, -0.4}, straight);
  }
  if constexpr (std::is_same_v<M, trimesh>) {
    report("bumpy ball", bumpy_ball(count > 3000 ? 4 : 2), {1, 0, 0}, {});
    report("washer", washer(count / 24, 3), {1, 0, 0.3}, {});
    report("washer of needles", washer(count / 8, 1), {1, 0, 0.3}, {});
    M plate = grid();
    jitter(plate, 0.2);
    remove_part(plate, [](const vec3& x) { return std::hypot(x.x - 0.5, x.y - 0.5) < 0.25; });
    report("plate with a hole", plate, {0.1, 0.4, 0}, {});
    const auto around = static_cast<std::size_t>(std::lround(std::sqrt(count)));
    report("torus", make_torus<M>({.cells = {around, around / 2}}), {1.4, 0, 0}, {});
  }
  if constexpr (std::is_same_v<M, polygonmesh>) {
    report("jigsaw", jigsaw(n), inside, straight);
    report("jigsaw of short edges", jigsaw(std::max(n / 3, 3u), 20), corner, straight);
    auto fine = simplices(8 * count);
    report("agglomerates", agglomerate(fine, random_labels(fine, 8)), inside, straight);
    remove_part(fine, quarter);
    report("agglomerates round a corner", agglomerate(fine, random_labels(fine, 8)), low, round_the_corner);
    M voronoi = voronoi_polygons(random_points(count, box{{0, 0, 0}, {1, 1, 0}}, 1), box{{0, 0, 0}, {1, 1, 0}});
    report("Voronoi", voronoi, inside, straight);
    grade(voronoi, {3, 3, 1});
    report("Voronoi graded by cubes", voronoi, corner, straight);
  }
  if constexpr (std::is_same_v<M, polyhedralmesh>) {
    auto fine = simplices(6 * count);
    report("agglomerates", agglomerate(fine, random_labels(fine, 6)), inside, straight);
    report("agglomerates of short edges", agglomerate(fine, random_labels(fine, 40)), corner, straight);
    remove_part(fine, quarter);
    report("agglomerates round a corner", agglomerate(fine, random_labels(fine, 6)), low, round_the_corner);
    M voronoi = voronoi_polyhedra(random_points(count / 6, box{{0, 0, 0}, {1, 1, 1}}, 1), box{{0, 0, 0}, {1, 1, 1}});
    report("Voronoi", voronoi, inside, straight);
    grade(voronoi, {3, 3, 3});
    report("Voronoi graded by cubes", voronoi, corner, straight);
  }
}

}  // namespace concino::testing
