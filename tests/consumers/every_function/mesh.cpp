#include "call.hpp"

#include <concino/adapters/span.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/support/limits.hpp>
#include <concino/mesh/support/standard_cells.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>
#include <concino/mesh/support/volume_sign.hpp>
#include <concino/mesh/view_arrays.hpp>

#include <array>

namespace {

/// A correspondence of a mesh with itself.
template<class M>
cn::correspondence same_elements(const M& m) {
  const std::vector verts(cn::verts(m).begin(), cn::verts(m).end());
  const std::vector polys(cn::polys(m).begin(), cn::polys(m).end());
  cn::correspondence c{cn::origins_of(m, verts), {}, {}, cn::origins_of(m, polys)};
  cn::match_edges_and_faces(m, m, c);
  return c;
}

void call_maps() {
  call("make_vert_map", [](auto& m) { cn::make_vert_map<int>(m); }, all);
  call("make_edge_map", [](auto& m) { cn::make_edge_map<int>(m); }, all);
  call("make_face_map", [](auto& m) { cn::make_face_map<int>(m); }, volumes);
  call("make_poly_map", [](auto& m) { cn::make_poly_map<int>(m); }, all);
  call("make_facet_map", [](auto& m) { cn::make_facet_map<int>(m); }, all);
  call("make_corner_map", [](auto& m) { cn::make_corner_map<int>(m); }, all);
  call("vert_at", [](auto& m) { cn::vert_at(m, cn::corner<std::remove_reference_t<decltype(m)>>{first(cn::polys(m)), 0}); }, all);
  call("corner_index", [](auto& m) { cn::corner_index(m, cn::corner<std::remove_reference_t<decltype(m)>>{first(cn::polys(m)), 0}); }, all);
}

void call_properties() {
  call("vert_property", [](auto& m) { cn::vert_property<double>(m, "u"); }, all);
  call("edge_property", [](auto& m) { cn::edge_property<double>(m, "u"); }, all);
  call("face_property", [](auto& m) { cn::face_property<double>(m, "u"); }, volumes);
  call("poly_property", [](auto& m) { cn::poly_property<double>(m, "u"); }, all);
  call("mesh_property", [](auto& m) { cn::mesh_property<double>(m, "u"); }, all);
  call("corner_property", [](auto& m) { cn::corner_property<double>(m, "u"); }, all);
  call("find_vert_property", [](auto& m) { cn::find_vert_property<double>(m, "u"); }, all);
  call("find_edge_property", [](auto& m) { cn::find_edge_property<double>(m, "u"); }, all);
  call("find_face_property", [](auto& m) { cn::find_face_property<double>(m, "u"); }, volumes);
  call("find_poly_property", [](auto& m) { cn::find_poly_property<double>(m, "u"); }, all);
  call("find_mesh_property", [](auto& m) { cn::find_mesh_property<double>(m, "u"); }, all);
  call("find_corner_property", [](auto& m) { cn::find_corner_property<double>(m, "u"); }, all);
  call("property_list", [](auto& m) { cn::property_list(m); }, all);
  call("set_property_rule", [](auto& m) {
    cn::vert_property<double>(m, "u");
    cn::set_property_rule(m, cn::element_kind::vert, "u", cn::property_rule::copy);
  }, all);
  call("remove_property", [](auto& m) { cn::remove_property(m, cn::element_kind::vert, "u"); }, all);
  call("to_string", [] {
    cn::to_string(cn::element_kind::vert);
    cn::to_string(cn::property_rule::copy);
  });
  call("origins_of", [](auto& m) { same_elements(m); }, all);
  call("match_edges_and_faces", [](auto& m) { same_elements(m); }, all);
  call("transfer_values", [](auto& m) {
    const std::vector<double> values(cn::num_verts(m));
    cn::transfer_values(same_elements(m).verts, std::span(values), cn::property_rule::copy);
  }, all);
  call("transfer_properties", [](auto& m) {
    auto copy = m;
    cn::vert_property<double>(m, "u");
    cn::transfer_properties(m, copy, same_elements(m));
  }, all);
}

void call_cells() {
  const std::array<cn::vert_id, 4> v{cn::vert_id{0}, cn::vert_id{1}, cn::vert_id{2}, cn::vert_id{3}};
  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  call("standard_cell_of", [] { cn::standard_cell_of(cn::cell_shape::tet); });
  call("six_times_volume_under", [&] { cn::six_times_volume_under(3, [&](std::size_t i) { return x[i]; }, x[3]); });
  call("six_times_volume", [&] { cn::six_times_volume(cn::cell_shape::tet, v.data(), x); });
  call("has_negative_volume", [&] { cn::has_negative_volume(cn::cell_shape::tet, v.data(), x); });
  call("make_volume_positive", [&] {
    auto w = v;
    cn::make_volume_positive(cn::cell_shape::tet, w.data(), x);
  });
  call("compare_cycles", [&] { cn::compare_cycles(v.data(), v.data(), 4); });
  call("to_polyhedra", [&] { cn::to_polyhedra(cn::cell_arrays{x, {v.begin(), v.end()}, 4}); });
  call("check_poly_corners", [] { cn::check_poly_corners(8, 24, 6, "a mesh"); });
  call("has_moderate_coordinates", [&] { cn::has_moderate_coordinates(x[1]); });
}

void call_views() {
  std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<double> points;
  for (const cn::vec3& p : x) points.insert(points.end(), {p.x, p.y, p.z});
  std::vector<int> tri{0, 1, 2}, quad{0, 1, 2, 3}, tet{0, 1, 2, 4}, hex{0, 1, 2, 3, 4, 5, 6, 7};
  std::vector<int> tri_offsets{0, 3}, offsets{0, 3, 6, 9, 12}, corners{0, 2, 1, 0, 1, 4, 1, 2, 4, 2, 0, 4}, poly_offsets{0, 4}, faces{0, 1, 2, 3};
  call("view_tri", [&] { cn::view_tri(points, tri); });
  call("view_quad", [&] { cn::view_quad(points, quad); });
  call("view_tet", [&] { cn::view_tet(points, tet); });
  call("view_hex", [&] { cn::view_hex(points, hex); });
  call("view_polygons", [&] { cn::view_polygons(points, tri_offsets, tri); });
  call("view_polyhedra", [&] { cn::view_polyhedra(points, offsets, corners, poly_offsets, faces); });
  call("boundary", [](auto& m) { cn::boundary(m); }, volumes);
  call("submesh", [](auto& m) { cn::submesh(m, [](auto) { return true; }); }, all);
}

}  // namespace

void call_mesh() {
  call_maps();
  call_properties();
  call_cells();
  call_views();
}
