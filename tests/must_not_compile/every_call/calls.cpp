// Each call below has one mistake and is rejected by a deleted overload that says what to write; check.cmake checks each line.
#include <concino/concepts/archetypes.hpp>
#include <concino/convert.hpp>
#include <concino/edit.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/io.hpp>
#include <concino/level_sets.hpp>
#include <concino/lines.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/quality.hpp>
#include <concino/remesh.hpp>
#include <concino/render.hpp>
#include <concino/validate.hpp>

namespace cn = concino;

struct stranger {};
cn::trimesh made();

// The adapter is not included.
void no_adapter(const stranger& other) {
  cn::bfs(other);  // refused
  cn::dijkstra(other);  // refused
  cn::shortest_path(other);  // refused
  cn::connected_components(other);  // refused
  cn::harmonic_map(other);  // refused
  cn::bounding_box(other);  // refused
  cn::total_measure(other);  // refused
  cn::quality(other);  // refused
  cn::isolines(other);  // refused
  cn::isosurface(other);  // refused
  cn::clip(other);  // refused
  cn::gradient(other);  // refused
  cn::laplacian(other);  // refused
  cn::save(other);  // refused
  cn::save_text(other);  // refused
  cn::scene().add(other);  // refused
  cn::validate(other);  // refused
  cn::convert<cn::polygonmesh>(other);  // refused
  cn::heat_geodesics(other);  // refused
  cn::primal(other);  // refused
  cn::dual(other);  // refused
  cn::with_points(other);  // refused
  cn::make_vert_map<int>(other);  // refused
  cn::make_edge_map<int>(other);  // refused
  cn::make_face_map<int>(other);  // refused
  cn::make_poly_map<int>(other);  // refused
}

// A temporary mesh.
void temporary() {
  cn::bfs(made());  // refused
  cn::bfs_forest(made());  // refused
  cn::dijkstra(made());  // refused
  cn::grow_regions(made());  // refused
  cn::connected_components(made());  // refused
  cn::prepare_harmonic_map(made());  // refused
  cn::harmonic_map(made());  // refused
  cn::prepare_poisson(made());  // refused
  cn::poisson(made());  // refused
  cn::prepare_heat_flow(made());  // refused
  cn::heat_flow(made());  // refused
  cn::prepare_smooth(made());  // refused
  cn::smooth(made());  // refused
  cn::random_labels(made());  // refused
  cn::bounding_tree(made());  // refused
  cn::centroids(made());  // refused
  cn::angle_defects(made());  // refused
  cn::dihedral_angles(made());  // refused
  cn::adaptive_size(made());  // refused
  cn::edge_lengths(made());  // refused
  cn::measures(made());  // refused
  cn::quality(made(), cn::metric::area);  // refused
  cn::boundary_verts(made());  // refused
  cn::poly_normals(made());  // refused
  cn::face_normals(made());  // refused
  cn::vert_normals(made());  // refused
  cn::surface_normals(made());  // refused
  cn::divergence(made());  // refused
  cn::gradient(made());  // refused
  cn::vert_gradient(made());  // refused
  cn::rotated(made());  // refused
  cn::vert_masses(made());  // refused
  cn::poly_masses(made());  // refused
  cn::load_vert_field<double>(made());  // refused
  cn::load_poly_field<double>(made());  // refused
  cn::ambient_occlusion(made());  // refused
  cn::ambient_occlusion_at_verts(made());  // refused
  cn::visible_polys(made());  // refused
  cn::prepare_exact_geodesics(made());  // refused
  cn::exact_geodesics(made());  // refused
  cn::critical_points(made());  // refused
  cn::hodge_decomposition(made());  // refused
  cn::form_vectors(made());  // refused
  cn::integral_line(made());  // refused
  cn::integral_lines(made());  // refused
  cn::evenly_spaced_lines(made());  // refused
  cn::to_polys(made());  // refused
  cn::resample(cn::trimesh(), 0, made());  // refused
  cn::normalized(made());  // refused
  cn::simplified(made());  // refused
  cn::simplified_on_cells(made());  // refused
  cn::regions_of_maxima(made());  // refused
  cn::regions_of_minima(made());  // refused
  cn::prepare_heat_geodesics(made());  // refused
  cn::heat_geodesics(made());  // refused
  cn::prepare_log_map(made());  // refused
  cn::log_map(made());  // refused
  cn::prepare_parallel_transport(made());  // refused
  cn::parallel_transport(made());  // refused
  cn::prepare_trace_geodesic(made());  // refused
  cn::trace_geodesic(made());  // refused
  cn::karcher_mean(made());  // refused
  cn::prepare_straighten(made());  // refused
  cn::straighten(made());  // refused
  cn::make_vert_map<int>(made());  // refused
  cn::make_edge_map<int>(made());  // refused
  cn::make_face_map<int>(made());  // refused
  cn::make_facet_map<int>(made());  // refused
  cn::make_corner_map<int>(made());  // refused
  cn::make_poly_map<int>(made());  // refused
  cn::convert_with_correspondence<cn::polygonmesh>(made());  // refused
}

// The verts have no points.
void no_points(const cn::trimesh& m) {
  const auto pure = cn::only_surface_mesh(m);
  cn::dijkstra(pure, pure.vert(cn::vert_id{0}));  // refused
  cn::shortest_path(pure, pure.vert(cn::vert_id{0}), pure.vert(cn::vert_id{1}));  // refused
  cn::bounding_box(pure);  // refused
  cn::total_measure(pure);  // refused
  cn::quality(pure, cn::metric::area);  // refused
  cn::gradient(pure);  // refused
  cn::save(pure);  // refused
  cn::save_text(pure);  // refused
  cn::scene().add(pure);  // refused
  cn::convert<cn::polygonmesh>(pure);  // refused
  cn::heat_geodesics(pure);  // refused
  cn::isolines(pure);  // refused
  cn::isosurface(pure);  // refused
  cn::clip(pure);  // refused
}

// Level sets of what is not a number at each vert.
void no_values(const cn::trimesh& m, const cn::tetmesh& t) {
  const auto colours = cn::make_vert_map<cn::vec3>(m);
  cn::isolines(m, colours, 0.5);  // refused
  cn::isosurface(t, colours, 0.5);  // refused
  cn::clip(m, colours, 0.5);  // refused
}

// A graph, for which no discretisation is the default.
void bare_graph(const cn::trimesh& m) {
  const auto g = cn::primal(m);
  const cn::vert_id a{0};
  const auto f = cn::make_vert_map<double>(m);
  cn::laplacian(g);  // refused
  cn::harmonic_map(g, {{a, 0.0}});  // refused
  cn::harmonic_map<cn::vec3>(g, {{a, {0, 0, 0}}});  // refused
  cn::laplacian(g, cn::cotangent);  // refused
}

// A graph of polys, without dual(m).
void polys_alone(const cn::trimesh& m) {
  const auto g = cn::only_dual_graph(m);
  cn::connected_components(g);  // refused
}

// Numbers instead of descriptors.
void numbers(const cn::trimesh& m) {
  cn::bfs(m, 0);  // refused
  cn::dijkstra(m, 0);  // refused
  cn::shortest_path(m, 0);  // refused
  cn::harmonic_map(m, 0);  // refused
  cn::quality(m, 0, cn::metric::area);  // refused
  cn::heat_geodesics(m, 0);  // refused
  cn::prepare_harmonic_map(m, {cn::vert_id{0}}).with_values({{0, 1.0}});  // refused
  cn::prepare_heat_geodesics(m).distance_from(0);  // refused
  cn::prepare_log_map(m).log_map_from(0);  // refused
  cn::prepare_parallel_transport(m).transport_from(0);  // refused
  cn::prepare_trace_geodesic(m).trace_from(0);  // refused
  cn::prepare_straighten(m).straighten(0);  // refused
  cn::prepare_exact_geodesics(m).distance_from({0, 1});  // refused
}

// Criteria for verts instead of polys, and faces of a surface.
void criteria(const cn::trimesh& m) {
  const auto at_verts = cn::make_vert_map<int>(m);
}

// A mesh instead of outlines.
void outlines(const cn::trimesh& m) {
}

// Without a back end.
void no_back_end(const cn::trimesh& m) {
  cn::tetrahedralize(m);  // refused
  cn::tetrahedralize(m, {.radius_edge = 2});  // refused
}

// A class that is not a format.
void no_format(const cn::trimesh& m, const stranger& other) {
  cn::load<cn::trimesh>("a", other);  // refused
  cn::load_text<cn::trimesh>("a", other);  // refused
  cn::save(m, "a", other);  // refused
  cn::save_text(m, other);  // refused
}
