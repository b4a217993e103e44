// Geometry does not depend on the order in which a mesh is stored.
#include <concino/geometry.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("measures, centres and normals do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    check.at_polys("measures", [](const s& x) { return measures(x.mesh); });
    check.at_polys("centroids", [](const s& x) { return centroids(x.mesh); });
    check.number("total_measure", [](const s& x) { return total_measure(x.mesh); });
    check.number("bounding_box", [](const s& x) {
      const box b = bounding_box(x.mesh);
      return std::vector<double>{b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z};
    });
    check.at_verts("vert_normals", [](const s& x) { return vert_normals(x.mesh); });
    check.at_edges("edge_lengths", [](const s& x) { return [a = edge_lengths(x.mesh)](edge_id e) { return a[e]; }; });
    check.numbers("outward_vector", [](const s& x) {
      std::vector<double> r;
      for (const poly_id p : x.polys) {  // sums over facets of squares and of products with the place
        double squares = 0, place = 0;
        for (const auto f : adj_p2facet(x.mesh, p)) {
          const vec3 a = outward_vector(x.mesh, p, f);
          squares += dot(a, a);
          for (const vert_id v : adj_facet2v(x.mesh, f)) place += dot(a, vec3(point(x.mesh, v)));
        }
        r.insert(r.end(), {squares, place});
      }
      return r;
    });
    if constexpr (SurfaceMesh<M>) {
      check.at_edges("dihedral_angles", [](const s& x) { return [a = dihedral_angles(x.mesh)](edge_id e) { return a[e]; }; }, 1);
      check.at_polys("poly_normals", [](const s& x) { return poly_normals(x.mesh); });
      check.at_verts("angle_defects", [](const s& x) { return angle_defects(x.mesh); });
    } else {
      check.at_edges("dihedral_angle", [](const s& x) {
        return [&x](edge_id e) {
          std::vector<double> r;
          for (const poly_id p : adj_e2p(x.mesh, e)) r.push_back(dihedral_angle(x.mesh, p, e));
          std::sort(r.begin(), r.end());
          return r;
        };
      });
      check.at_faces("area and centroid of faces", [](const s& x) {
        return [&x](face_id f) {
          const vec3 c = centroid(x.mesh, f);
          return std::vector<double>{area(x.mesh, f), c.x, c.y, c.z};
        };
      });
    }
  });
}

TEST_CASE_TEMPLATE("distances to a mesh do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    const std::vector<vec3> places = random_points(30, box{{-0.3, -0.3, -0.3}, {1.3, 1.3, 1.3}}, 3);
    check.number("closest", [&](const s& x) {
      const auto tree = bounding_tree(x.mesh);
      std::vector<double> r;
      for (const vec3& y : places) r.push_back(tree.closest(y).distance);
      return r;
    });
    check.number("ray", [&](const s& x) {
      const auto tree = bounding_tree(x.mesh);
      std::vector<double> r;
      for (const vec3& y : places) {
        for (const auto& hit : tree.ray_all(y + vec3{0.001, 0.002, 3}, {0.01, 0.02, -1})) r.push_back(hit.parameter);
      }
      return r;
    });
    if constexpr (VolumeMesh<M>) {
      check.number("locate", [&](const s& x) {
        const auto tree = bounding_tree(x.mesh);
        std::vector<double> r;
        for (const vec3& y : places) {
          const auto p = tree.locate(y);
          r.push_back(p ? static_cast<double>(std::find(x.polys.begin(), x.polys.end(), *p) - x.polys.begin()) : -1);
        }
        return r;
      });
    } else {
      check.number("hausdorff_distance", [&](const s& x) {
        const auto other = make_grid<trimesh>({.cells = {3, 3, 1}});
        const auto d = hausdorff_distance(x.mesh, other, {.tolerance = 1e-12});
        return std::vector<double>{d.lower};
      });
      check.number("self_intersections", [&](const s& x) { return static_cast<double>(self_intersections(x.mesh).size()); });
    }
  });
}
