#include "call.hpp"

#include <concino/generate.hpp>

namespace {

/// A back end of tetrahedralize() that finds no tets.
struct no_tets {
  const char* name() const { return "no_tets"; }
  cn::tetrahedralize_output tetrahedralize(const cn::tetrahedralize_input&, const cn::tetrahedralize_options&) const { throw cn::unsupported("no tets"); }
};

template<class M>
M cube() { return cn::make_box<M>({.cells = {2, 2, 2}}); }

void call_shapes() {
  call("make_box", [](auto& m) { cn::make_box<std::remove_reference_t<decltype(m)>>({.cells = {1, 1, 1}}); }, all);
  call("make_grid", [](auto& m) { cn::make_grid<std::remove_reference_t<decltype(m)>>({.cells = {1, 1, 1}}); }, all);
  call("make_cone", [](auto& m) { cn::make_cone<std::remove_reference_t<decltype(m)>>({.cells = 2}); }, all);
  call("make_cylinder", [](auto& m) { cn::make_cylinder<std::remove_reference_t<decltype(m)>>({.cells = {4, 1}}); }, all);
  call("make_sphere", [](auto& m) { cn::make_sphere<std::remove_reference_t<decltype(m)>>({.cells = 2}); }, all);
  call("make_torus", [](auto& m) { cn::make_torus<std::remove_reference_t<decltype(m)>>({.cells = {4, 4}}); }, all);
  call("icosphere", [] { cn::icosphere(0); });
  call("random_points", [] { cn::random_points(3, {{0, 0, 0}, {1, 1, 1}}); });
  call("triangulate", [] { cn::triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}); });
  const cn::box unit{{0, 0, 0}, {1, 1, 1}};
  call("voronoi_polygons", [&] { cn::voronoi_polygons({{0.2, 0.2, 0}, {0.8, 0.7, 0}}, unit); });
  call("voronoi_polyhedra", [&] { cn::voronoi_polyhedra(cn::random_points(5, unit), unit); });
  call("voronoi_polyhedra", [&](auto& m) {
    cn::voronoi_polyhedra(cn::random_points(5, unit), cube<std::remove_reference_t<decltype(m)>>());
  }, triangles);
  call("voxel_hexes", [](auto& m) { cn::voxel_hexes(cube<std::remove_reference_t<decltype(m)>>(), 2); }, surfaces);
}

void call_subdivisions() {
  call("subdivide_1_to_4", [](auto& m) { cn::subdivide_1_to_4(m); }, triangles);
  call("subdivide_1_to_8", [](auto& m) { cn::subdivide_1_to_8(m); }, kinds<cn::tetmesh, cn::hexmesh>());
  call("subdivide_barycentric", [](auto& m) { cn::subdivide_barycentric(m); }, all);
  call("subdivide_catmull_clark", [](auto& m) { cn::subdivide_catmull_clark(m); }, surfaces);
  call("subdivide_loop", [](auto& m) { cn::subdivide_loop(m); }, triangles);
  call("subdivide_midpoint", [](auto& m) { cn::subdivide_midpoint(m); }, all);
  call("subdivide_root3", [](auto& m) { cn::subdivide_root3(m); }, triangles);
  call("loop_limit", [](auto& m) { cn::loop_limit(m); }, triangles);
  call("catmull_clark_limit", [](auto& m) { cn::catmull_clark_limit(m); }, surfaces);
}

void call_between_kinds() {
  call("agglomerate", [](auto& m) { cn::agglomerate(m, cn::random_labels(m, 2)); }, all);
  call("random_labels", [](auto& m) { cn::random_labels(m, 2); }, all);
  call("boundary_surface", [](auto& m) { cn::boundary_surface(m); }, volumes);
  call("dual_mesh", [](auto& m) { cn::dual_mesh(m); }, all);
  call("extrude", [](auto& m) { cn::extrude(m, {0, 0, 1}); }, surfaces);
  call("offset_shell", [](auto& m) { cn::offset_shell(m, 0.1); }, surfaces);
  call("revolve", [](auto& m) { cn::revolve(m, {-1, 0, 0}, {0, 1, 0}, 4); }, surfaces);
  call("grade", [](auto& m) { cn::grade(m, {2, 1, 1}); }, all);
  call("jitter", [](auto& m) { cn::jitter(m, 0.1); }, all);
  call("quads_from_triangles", [](auto& m) { cn::quads_from_triangles(m); }, triangles);
  call("tetrahedralize", [](auto& m) {
    try {
      cn::tetrahedralize(cube<std::remove_reference_t<decltype(m)>>(), no_tets());
    } catch (const cn::unsupported&) {
    }
  }, surfaces);
  call("to_tets", [](auto& m) { cn::to_tets(m); }, volumes);
  call("to_triangles", [](auto& m) { cn::to_triangles(m); }, surfaces);
  call("unite", [](auto& m) { cn::unite(m, m); }, all);
}

}  // namespace

void call_generate() {
  call_shapes();
  call_subdivisions();
  call_between_kinds();
}
