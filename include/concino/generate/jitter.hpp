// Random perturbation: moves verts by a fraction of the length of their shortest edges.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/common/finite.hpp>
#include <concino/generate/detail/common/random.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/graph/boundary_verts.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace concino {

struct jitter_options {
  std::uint64_t seed = 1;     // of the random numbers; any value
  bool keep_boundary = true;  // verts on the boundary do not move
  bool in_plane = true;       // surfaces: verts move in the plane perpendicular to the sum of the vector areas around
                              // the vert
};

/// Moves the interior verts of m at random, each by at most `amount` times its shortest edge along every axis.
/// Needs:  MutablePoints AnyMesh. Cells of good shape stay valid up to an amount of about 0.2.
/// Result: m; the edges are measured before any vert moves. A flat surface stays in its plane (options.in_plane). Verts
///         without edges do not move; with in_plane, neither do verts around which the vector areas cancel out. The
///         random numbers depend only on the seed and the order of verts(m), and are the same on every machine.
/// Cost:   O(V + E) time, O(V) memory.
/// Errors: invalid_argument if amount is not finite or below 0; invalid_mesh that names a vert without a finite point.
///         m is then unchanged.
/// Source: random_stream: Steele, Lea, Flood 2014 (SplitMix64).
template<AnyMesh M>
  requires MutablePoints<M> && (!std::is_const_v<M>)
void jitter(M& m, double amount, const jitter_options& options = {}) {
  if (!(amount >= 0 && amount <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_argument>(
        {"jitter: amount is ", core::number_text(amount), "; it must be finite and 0 or more"});
  detail::check_points_finite("jitter", m);
  const auto stays = options.keep_boundary ? boundary_verts(m) : make_vert_map<bool>(m, false);

  std::vector<vec3> normal;
  if constexpr (SurfaceMesh<M>) {  // only a surface has a tangent plane
    if (options.in_plane) {
      normal.resize(vert_index_bound(m));
      for (const poly_t<M> p : polys(m)) {
        const vec3 area = shape_of(m, adj_p2v(m, p)).area;
        for (const vert_t<M> v : adj_p2v(m, p)) normal[index_of(m, v)] += area;
      }
    }
  }
  std::vector<vec3> moved;
  moved.reserve(num_verts(m));
  detail::random_stream random(options.seed);
  for (const vert_t<M> v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    // even if unused: each vert has its own
    const double dx = random.between(-1, 1), dy = random.between(-1, 1), dz = random.between(-1, 1);
    const std::size_t i = index_of(m, v);
    double shortest = std::numeric_limits<double>::infinity();
    if (!stays[v])
      for (const vert_t<M> w : adj_v2v(m, v)) shortest = std::min(shortest, distance(x, to_vec3(point(m, w))));
    if (!(shortest < std::numeric_limits<double>::infinity())) {
      moved.push_back(x);
      continue;
    }
    vec3 step{dx, dy, dz};
    if (!normal.empty()) {
      const double length = norm(normal[i]);
      const vec3 n = normal[i] / length;
      step -= dot(n, step) * n;
      if (!is_finite(step)) step = {};  // there is no plane
    }
    moved.push_back(x + amount * shortest * step);
  }
  std::size_t k = 0;
  for (const vert_t<M> v : verts(m)) set_point(m, v, moved[k++]);
}

// What to write instead of calls that cannot compile.
template<class... T> void jitter(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void jitter(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
