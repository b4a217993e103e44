// Exact geodesics agree with those of CGAL, which uses another algorithm.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/fields/exact_geodesics.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/cgal.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;
using shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<kernel, surface>>;

void compare(const surface_arrays& arrays, const std::vector<unsigned>& sources) {
  const trimesh m(arrays);
  const surface theirs = cgal_surface<kernel::Point_3>(arrays);
  const auto exact = prepare_exact_geodesics(m);
  const auto on_theirs = prepare_exact_geodesics(theirs);
  for (const unsigned s : sources) {
    shortest_path paths(theirs);
    paths.add_source_point(CGAL::SM_Vertex_index(s));
    const auto d = exact.distance_from(vert_id{s});
    const auto e = on_theirs.distance_from(CGAL::SM_Vertex_index(s));
    for (const auto v : verts(m)) {
      const CGAL::SM_Vertex_index w(v.raw());
      const double known = paths.shortest_distance_to_source_points(w).first;
      if (known < 0) CHECK(d[v] == std::numeric_limits<double>::infinity());
      else CHECK(d[v] == doctest::Approx(known).epsilon(1e-9));
      CHECK(e[w] == doctest::Approx(d[v]).epsilon(1e-12));
    }
  }
}

}  // namespace

TEST_CASE("exact_geodesics: agree with CGAL on rough surfaces with uneven boundaries") {
  for (const unsigned seed : {1u, 2u, 3u}) compare(jittered(triangle_grid(7), 0.05, true, seed), {0, 9, 27, 63});
  auto bowl = jittered(triangle_grid(8), 0.03, false);
  for (vec3& x : bowl.points) x.z = 2 * x.x * x.y - x.x * x.x;
  compare(bowl, {0, 40, 77});
}

TEST_CASE("exact_geodesics: agree with CGAL between spikes, where most verts are saddles or tips") {
  auto spikes = jittered(triangle_grid(7), 0.02, false);
  for (std::size_t i = 0; i < spikes.points.size(); ++i) spikes.points[i].z = i % 3 == 0 ? 0.4 : 0.0;
  compare(spikes, {0, 10, 30, 45});
}

TEST_CASE("exact_geodesics: agree with CGAL on a closed surface") {
  const trimesh sphere = icosphere(2);
  surface_arrays arrays{{}, {}, {}, 3};
  for (const vert_id v : verts(sphere)) arrays.points.push_back(point(sphere, v));
  for (const poly_id p : polys(sphere))
    for (const vert_id v : adj_p2v(sphere, p)) arrays.verts.push_back(v);
  compare(jittered(arrays, 0.1), {0, 50, 120});
}
