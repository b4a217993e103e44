#include <concino/geometry/outward_vector.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/geometry/centroid.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

namespace {

double difference(const vec3& a, const vec3& b) { return norm(a - b); }

template<class M>
vec3 midpoint(const M& m, const facet_t<M>& x) {
  vec3 sum;
  double n = 0;
  for (const vert_t<M> v : adj_facet2v(m, x)) sum += to_vec3(point(m, v)), ++n;
  return sum / n;
}

}  // namespace

TEST_CASE_TEMPLATE("outward_vector: sums to 0 over each poly, and fulfils the divergence theorem", M, CONCINO_ALL_KINDS) {
  for (const auto& arrays : {grid_arrays<M>(2), rotated(jittered(grid_arrays<M>(2), 0.1, VolumeMesh<M>))}) {
    const M m(arrays);
    for (const auto p : polys(m)) {
      vec3 sum;
      double flux = 0;  // the flux of x - o, whose divergence is the dimension
      const vec3 o = centroid(m, p);
      for (const auto x : adj_p2facet(m, p)) {
        const vec3 out = outward_vector(m, p, x);
        sum += out;
        flux += dot(midpoint(m, x) - o, out);
        CHECK(norm(out) <= measure(m, x) * (1 + 1e-12));
      }
      CHECK(norm(sum) < 1e-13);
      // The mean point of a face of more than three verts is not its centroid in general, least of all in jittered meshes.
      if (SurfaceMesh<M> || TetMesh<M>) CHECK(flux / dimension_v<M> == doctest::Approx(measure(m, p)).epsilon(1e-11));
    }
  }
}

TEST_CASE_TEMPLATE("outward_vector: is opposite for the two polys of a facet, and as long as the facet", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(3);
  vec3 boundary;
  for (const auto x : facets(m)) {
    vec3 sum;
    for (const auto p : adj_facet2p(m, x)) {
      const vec3 out = outward_vector(m, p, x);
      CHECK(norm(out) == doctest::Approx(measure(m, x)));
      for (const auto v : adj_facet2v(m, x)) CHECK(std::abs(dot(out, to_vec3(point(m, v)) - midpoint(m, x))) < 1e-15);
      sum += out;
    }
    if (is_boundary(m, x)) boundary += sum;
    else CHECK(norm(sum) < 1e-15);
  }
  CHECK(norm(boundary) < 1e-14);
}

TEST_CASE_TEMPLATE("outward_vector: rotates with the mesh, scales exactly, is the same on the archetype", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.1);
  const M m(arrays), turned(rotated(arrays)), large(scaled(arrays, 0x1p300)), small(scaled(arrays, 0x1p-300));
  const auto weak = only_embedded_mesh(m);
  const double by = VolumeMesh<M> ? 0x1p100 : 0x1p300;
  const M larger(scaled(arrays, by)), smaller(scaled(arrays, 1 / by));
  for (const auto p : polys(m))
    for (const auto x : adj_p2facet(m, p)) {
      const vec3 out = outward_vector(m, p, x);
      CHECK(difference(outward_vector(turned, p, x), rotated(out)) < 1e-13);
      const double factor = VolumeMesh<M> ? by * by : by;
      CHECK(outward_vector(larger, p, x) == factor * out);
      CHECK(outward_vector(smaller, p, x) == out / factor);
      const auto wx = [&] {
        if constexpr (VolumeMesh<M>) return weak.face(x);  // archetypes wrap each kind of element
        else return weak.edge(x);
      }();
      CHECK(outward_vector(weak, weak.poly(p), wx) == out);
      CHECK(measure(weak, wx) == measure(m, x));
    }
}

TEST_CASE("outward_vector: is right on a user's surface and volume") {
  const auto s = user_mesh::surface_example();  // poly 0 is the triangle (0,0) (1,0) (1,1)
  CHECK(difference(outward_vector(s, user_mesh::cell{0}, user_mesh::segment{0}), {0, -1, 0}) < 1e-15);
  CHECK(difference(outward_vector(s, user_mesh::cell{0}, user_mesh::segment{1}), {1, 0, 0}) < 1e-15);
  const auto w = user_mesh::volume_example();  // a cube under a pyramid
  CHECK(outward_vector(w, user_mesh::cell{0}, user_mesh::facet{0}) == vec3{0, 0, -1});
  CHECK(outward_vector(w, user_mesh::cell{0}, user_mesh::facet{1}) == vec3{0, 0, 1});
  CHECK(outward_vector(w, user_mesh::cell{1}, user_mesh::facet{1}) == vec3{0, 0, -1});
}

TEST_CASE("outward_vector: is right for degenerate and very large polys") {
  const trimesh needle({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  for (const auto e : edges(needle)) CHECK(outward_vector(needle, poly_id{0}, e) == vec3{});
  const double huge = 1.7e308;
  const trimesh far_apart({{-huge, -huge, 0}, {huge, -huge, 0}, {0, huge, 0}}, {{0, 1, 2}});
  const vec3 down = outward_vector(far_apart, poly_id{0}, edge_id{0});
  CHECK(down.y == -HUGE_VAL);
  CHECK(down.x == 0);
}
