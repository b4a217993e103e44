#include "call.hpp"

#include <concino/geometry.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

namespace {

template<class M> auto poly(const M& m) { return first(cn::polys(m)); }
template<class M> auto face(const M& m) { return first(cn::faces(m)); }

void call_points() {
  const cn::vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  call("closest_point", [&] {
    cn::closest_point(o, x, y);
    cn::closest_point(o, x, y, z);
  });
  call("plane_through", [&] { cn::plane_through(o, x); });
  call("signed_distance", [&] { cn::signed_distance(cn::plane_through(o, x), y); });
  call("point_at", [&] {
    cn::point_at(cn::ray{o, x}, 1);
    cn::point_at(cn::segment{o, x}, 1);
  });
  call("closest_parameter", [&] { cn::closest_parameter(cn::segment{o, x}, y); });
  call("orient2d", [&] { cn::orient2d(o, x, y); });
  call("orient3d", [&] { cn::orient3d(o, x, y, z); });
  call("triangulate_polygon", [&] { cn::triangulate_polygon(std::vector{o, x, x + y, y}); });
}

void call_sizes() {
  call("area_vector", [](auto& m) { cn::area_vector(m, poly(m)); }, surfaces);
  call("area_vector", [](auto& m) { cn::area_vector(m, face(m)); }, volumes);
  call("area", [](auto& m) { cn::area(m, poly(m)); }, surfaces);
  call("area", [](auto& m) { cn::area(m, face(m)); }, volumes);
  call("volume", [](auto& m) { cn::volume(m, poly(m)); }, volumes);
  call("measure", [](auto& m) { cn::measure(m, poly(m)); }, all);
  call("measure", [](auto& m) { cn::measure(m, first(cn::edges(m))); }, surfaces);
  call("measure", [](auto& m) { cn::measure(m, face(m)); }, volumes);
  call("measures", [](auto& m) { cn::measures(m); }, all);
  call("total_measure", [](auto& m) { cn::total_measure(m); }, all);
  call("edge_length", [](auto& m) { cn::edge_length(m, first(cn::edges(m))); }, all);
  call("edge_lengths", [](auto& m) { cn::edge_lengths(m); }, all);
  call("corner_angle", [](auto& m) { cn::corner_angle(m, poly(m), first(cn::adj_p2v(m, poly(m)))); }, surfaces);
  call("corner_angle", [](auto& m) { cn::corner_angle(m, face(m), first(cn::adj_f2v(m, face(m)))); }, volumes);
  call("angle_defects", [](auto& m) { cn::angle_defects(m); }, surfaces);
  call("dihedral_angle", [](auto& m) {
    for (const auto e : cn::edges(m))
      if (!cn::is_boundary(m, e)) cn::dihedral_angle(m, e);
  }, surfaces);
  call("dihedral_angle", [](auto& m) { cn::dihedral_angle(m, poly(m), first(cn::adj_p2e(m, poly(m)))); }, volumes);
  call("dihedral_angles", [](auto& m) { cn::dihedral_angles(m); }, surfaces);
}

void call_places() {
  call("lowest_element", []<class M>(M& m) { cn::lowest_element(m, cn::mesh_point<M>{poly(m), cn::centroid(m, poly(m))}); }, all);
  call("bounding_box", [](auto& m) {
    cn::bounding_box(m);
    cn::bounding_box(m, poly(m));
    cn::bounding_box(m, first(cn::edges(m)));
  }, all);
  call("bounding_box", [](auto& m) { cn::bounding_box(m, face(m)); }, volumes);
  call("convex_hull", [] { cn::convex_hull(std::vector<cn::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}); });
  const std::vector<cn::vec3> polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  call("enclosing_ball", [&] { cn::enclosing_ball(polygon); });
  call("enclosing_ball", [](auto& m) {
    cn::enclosing_ball(m);
    cn::enclosing_ball(m, poly(m));
  }, all);
  call("enclosing_circle", [&] { cn::enclosing_circle(polygon); });
  call("enclosing_circle", [](auto& m) { cn::enclosing_circle(m, poly(m)); }, surfaces);
  call("inscribed_circle", [&] { cn::inscribed_circle(polygon); });
  call("inscribed_circle", [](auto& m) { cn::inscribed_circle(m, poly(m)); }, surfaces);
  call("kernel", [&] { cn::kernel(polygon); });
  call("kernel", [](auto& m) { cn::kernel(m, poly(m)); }, all);
  call("width", [&] { cn::width(polygon); });
  call("width", [](auto& m) { cn::width(m, poly(m)); }, all);
  call("bounding_tree", [](auto& m) { cn::bounding_tree(m).closest({3, 3, 3}); }, all);
  call("vert_mean", [](auto& m) { cn::vert_mean(m, poly(m)); }, all);
  call("centroid", [](auto& m) { cn::centroid(m, poly(m)); }, all);
  call("centroid", [](auto& m) { cn::centroid(m, face(m)); }, volumes);
  call("centroids", [](auto& m) { cn::centroids(m); }, all);
  call("circumcentre", [](auto& m) { cn::circumcentre(m, poly(m)); }, kinds<cn::trimesh, cn::tetmesh>());
  call("circumcentre", [](auto& m) { cn::circumcentre(m, face(m)); }, tets);
  call("one_sided_distance", [](auto& m) { cn::one_sided_distance(m, m); }, surfaces);
  call("hausdorff_distance", [](auto& m) { cn::hausdorff_distance(m, m); }, surfaces);
  call("self_intersections", [](auto& m) { cn::self_intersections(m); }, surfaces);
}

void call_directions() {
  call("normal", [](auto& m) { cn::normal(m, poly(m)); }, surfaces);
  call("normal", [](auto& m) { cn::normal(m, face(m)); }, volumes);
  call("vert_normal", [](auto& m) { cn::vert_normal(m, first(cn::verts(m))); }, all);
  call("poly_normals", [](auto& m) { cn::poly_normals(m); }, surfaces);
  call("face_normals", [](auto& m) { cn::face_normals(m); }, volumes);
  call("vert_normals", [](auto& m) { cn::vert_normals(m); }, all);
  call("surface_normals", [](auto& m) { cn::surface_normals(m); }, surfaces);
  call("outward_vector", [](auto& m) { cn::outward_vector(m, poly(m), first(cn::adj_p2facet(m, poly(m)))); }, all);
  call("for_each_outer_polygon", [](auto& m) { cn::for_each_outer_polygon(m, [](auto&&...) {}); }, all);
  call("for_each_visible_polygon", [](auto& m) { cn::for_each_visible_polygon(m, cn::make_poly_map<bool>(m, true), [](auto&&...) {}); }, all);
  call("shape_of", [](auto& m) { cn::shape_of(m, cn::adj_facet2v(m, first(cn::facets(m)))); }, volumes);
  call("area_vector_of", [](auto& m) { cn::area_vector_of(m, cn::adj_facet2v(m, first(cn::facets(m)))); }, volumes);
}

}  // namespace

void call_geometry() {
  call_points();
  call_sizes();
  call_places();
  call_directions();
}
