// Each call below has one mistake and is rejected by a deleted overload that says what to write; check.cmake checks each line.
#include <concino/concepts/archetypes.hpp>
#include <concino/convert.hpp>
#include <concino/deform.hpp>
#include <concino/directions.hpp>
#include <concino/edit.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/graph/min_cut.hpp>
#include <concino/graph/segment.hpp>
#include <concino/graph/segment_by_shape.hpp>
#include <concino/io.hpp>
#include <concino/layout.hpp>
#include <concino/level_sets.hpp>
#include <concino/lines.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/parametrize.hpp>
#include <concino/print.hpp>
#include <concino/quality.hpp>
#include <concino/remesh.hpp>
#include <concino/repair.hpp>
#include <concino/render.hpp>
#include <concino/skeleton.hpp>
#include <concino/validate.hpp>

namespace cn = concino;

struct stranger {};
cn::trimesh made();

// The adapter is not included.
void no_adapter(const stranger& other) {
  cn::bfs(other);  // refused
  cn::bfs_forest(other);  // refused
  cn::dijkstra(other);  // refused
  cn::shortest_path(other);  // refused
  cn::grow_regions(other);  // refused
  cn::min_cut(other);  // refused
  cn::segment_polys(other);  // refused
  cn::segment_verts(other);  // refused
  cn::segment_by_shape(other);  // refused
  cn::connected_components(other);  // refused
  cn::spanning_tree(other);  // refused
  cn::tree_cotree(other);  // refused
  cn::homology_generators(other);  // refused
  cn::boundary_loops(other);  // refused
  cn::boundary_verts(other);  // refused
  cn::cut_along(other);  // refused
  cn::submesh(other);  // refused
  cn::boundary(other);  // refused
  cn::prepare_harmonic_map(other);  // refused
  cn::harmonic_map(other);  // refused
  cn::prepare_poisson(other);  // refused
  cn::poisson(other);  // refused
  cn::prepare_heat_flow(other);  // refused
  cn::heat_flow(other);  // refused
  cn::prepare_smooth(other);  // refused
  cn::smooth(other);  // refused
  cn::agglomerate(other);  // refused
  cn::dual_mesh(other);  // refused
  cn::voronoi_polyhedra({{0, 0, 0}}, other);  // refused
  cn::catmull_clark_limit(other);  // refused
  cn::loop_limit(other);  // refused
  cn::quads_from_triangles(other);  // refused
  cn::subdivide_1_to_4(other);  // refused
  cn::subdivide_1_to_8(other);  // refused
  cn::subdivide_barycentric(other);  // refused
  cn::subdivide_catmull_clark(other);  // refused
  cn::subdivide_loop(other);  // refused
  cn::subdivide_midpoint(other);  // refused
  cn::subdivide_root3(other);  // refused
  cn::to_tets(other);  // refused
  cn::to_triangles(other);  // refused
  cn::boundary_surface(other);  // refused
  cn::tetrahedralize(other);  // refused
  cn::extrude(other);  // refused
  cn::revolve(other);  // refused
  cn::unite(other);  // refused
  cn::chord_of(other);  // refused
  cn::chords(other);  // refused
  cn::sheet_of(other);  // refused
  cn::sheets(other);  // refused
  cn::singular_verts(other);  // refused
  cn::singular_edges(other);  // refused
  cn::separatrices(other);  // refused
  cn::coarse_layout(other);  // refused
  cn::repaired(other);  // refused
  cn::repair(other);  // refused
  cn::voxel_hexes(other);  // refused
  cn::offset_shell(other);  // refused
  cn::grade(other);  // refused
  cn::jitter(other);  // refused
  cn::random_labels(other);  // refused
  cn::bounding_box(other);  // refused
  cn::bounding_tree(other);  // refused
  cn::centroid(other);  // refused
  cn::circumcentre(other);  // refused
  cn::enclosing_ball(other);  // refused
  cn::enclosing_circle(other);  // refused
  cn::inscribed_circle(other);  // refused
  cn::kernel(other);  // refused
  cn::width(other);  // refused
  cn::centroids(other);  // refused
  cn::corner_angle(other);  // refused
  cn::angle_defects(other);  // refused
  cn::dihedral_angle(other);  // refused
  cn::dihedral_angles(other);  // refused
  cn::edge_length(other);  // refused
  cn::edge_lengths(other);  // refused
  cn::area(other);  // refused
  cn::volume(other);  // refused
  cn::measure(other);  // refused
  cn::outward_vector(other);  // refused
  cn::for_each_outer_polygon(other);  // refused
  cn::for_each_visible_polygon(other);  // refused
  cn::measures(other);  // refused
  cn::total_measure(other);  // refused
  cn::quality(other);  // refused
  cn::worst(other);  // refused
  cn::isolines(other);  // refused
  cn::isosurface(other);  // refused
  cn::slice(other);  // refused
  cn::slice_mesh(other);  // refused
  cn::heights(other);  // refused
  cn::clip(other);  // refused
  cn::split(other);  // refused
  cn::measure_between(other);  // refused
  cn::to_verts(other);  // refused
  cn::embed_isolines(other);  // refused
  cn::embed_isosurface(other);  // refused
  cn::embed_path(other);  // refused
  cn::decimate(other, {});  // refused
  cn::adaptive_size(other, {});  // refused
  cn::remesh(other, {});  // refused
  cn::improve(other);  // refused
  cn::smooth_points(other);  // refused
  cn::histogram(other);  // refused
  cn::normal(other);  // refused
  cn::vert_normal(other);  // refused
  cn::poly_normals(other);  // refused
  cn::face_normals(other);  // refused
  cn::vert_normals(other);  // refused
  cn::surface_normals(other);  // refused
  cn::self_intersections(other);  // refused
  cn::divergence(other);  // refused
  cn::divergence_matrix(other);  // refused
  cn::gradient(other);  // refused
  cn::vert_gradient(other);  // refused
  cn::rotated(other);  // refused
  cn::gradient_matrix(other);  // refused
  cn::laplacian(other);  // refused
  cn::vert_masses(other);  // refused
  cn::mass_matrix(other);  // refused
  cn::poly_masses(other);  // refused
  cn::poly_mass_matrix(other);  // refused
  cn::vert_gradient_matrix(other);  // refused
  cn::save(other);  // refused
  cn::save_pvtu(other);  // refused
  cn::save_text(other);  // refused
  cn::save_field(0, other);  // refused
  cn::load_vert_field<double>(other);  // refused
  cn::load_poly_field<double>(other);  // refused
  cn::ambient_occlusion(other);  // refused
  cn::ambient_occlusion_at_verts(other);  // refused
  cn::make_drawable(other);  // refused
  cn::make_arrows(other);  // refused
  cn::make_balls(other);  // refused
  cn::make_graph_tubes(other);  // refused
  cn::scene().add(other);  // refused
  cn::make_tubes(other);  // refused
  cn::visible_polys(other);  // refused
  cn::visible_facets(other);  // refused
  cn::visible_faces(other);  // refused
  cn::exposed_facets(other);  // refused
  cn::overhangs(other);  // refused
  cn::leaves(other);  // refused
  cn::joints(other);  // refused
  cn::bones(other);  // refused
  cn::respace(other);  // refused
  cn::tube(other);  // refused
  cn::nearest_bone(other);  // refused
  cn::skeleton_of(other);  // refused
  cn::tutte(other);  // refused
  cn::lscm(other);  // refused
  cn::spectral_conformal(other);  // refused
  cn::arap_map(other);  // refused
  cn::injective_map(other);  // refused
  cn::map_distortion(other);  // refused
  cn::uv_at_corners(other);  // refused
  cn::direction_field(other);  // refused
  cn::singularities(other);  // refused
  cn::trivial_connection(other);  // refused
  cn::cage_coordinates(other);  // refused
  cn::green_coordinates(other);  // refused
  cn::harmonic_coordinates(other);  // refused
  cn::skin(other);  // refused
  cn::prepare_deform(other);  // refused
  cn::frame_field(other);  // refused
  cn::principal_curvatures(other);  // refused
  cn::stripes(other);  // refused
  cn::biharmonic_deform(other);  // refused
  cn::laplacian_deform(other);  // refused
  cn::heat_weights(other);  // refused
  cn::bounded_biharmonic_weights(other);  // refused
  cn::transfer_weights(other);  // refused
  cn::best_build_direction(other);  // refused
  cn::height_map(other);  // refused
  cn::shadow_on_plate(other);  // refused
  cn::thin_walls(other, 1);  // refused
  cn::narrow_gaps(other, 1);  // refused
  cn::validate(other);  // refused
  cn::check_laws(other);  // refused
  cn::convert<cn::polygonmesh>(other);  // refused
  cn::prepare_exact_geodesics(other);  // refused
  cn::exact_geodesics(other);  // refused
  cn::critical_points(other);  // refused
  cn::lowest_element(other);  // refused
  cn::integral_line(other);  // refused
  cn::integral_lines(other);  // refused
  cn::starts_around(other);  // refused
  cn::evenly_spaced_lines(other);  // refused
  cn::simplified(other);  // refused
  cn::simplified_on_cells(other);  // refused
  cn::regions_of_maxima(other);  // refused
  cn::regions_of_minima(other);  // refused
  cn::persistence(other);  // refused
  cn::hodge_decomposition(other);  // refused
  cn::form_vectors(other);  // refused
  cn::resample(other);  // refused
  cn::to_polys(other);  // refused
  cn::statistics(other);  // refused
  cn::normalized(other);  // refused
  cn::contour_tree(other);  // refused
  cn::reeb_graph(other);  // refused
  cn::prepare_heat_geodesics(other);  // refused
  cn::heat_geodesics(other);  // refused
  cn::prepare_log_map(other);  // refused
  cn::log_map(other);  // refused
  cn::prepare_parallel_transport(other);  // refused
  cn::parallel_transport(other);  // refused
  cn::prepare_trace_geodesic(other);  // refused
  cn::trace_geodesic(other);  // refused
  cn::karcher_mean(other);  // refused
  cn::prepare_straighten(other);  // refused
  cn::straighten(other);  // refused
  cn::primal(other);  // refused
  cn::dual(other);  // refused
  cn::with_points(other);  // refused
  cn::make_vert_map<int>(other);  // refused
  cn::make_edge_map<int>(other);  // refused
  cn::make_face_map<int>(other);  // refused
  cn::make_facet_map<int>(other);  // refused
  cn::make_corner_map<int>(other);  // refused
  cn::make_poly_map<int>(other);  // refused
  cn::convert_with_correspondence<cn::polygonmesh>(other);  // refused
}

// A temporary mesh.
void temporary() {
  cn::bfs(made());  // refused
  cn::bfs_forest(made());  // refused
  cn::dijkstra(made());  // refused
  cn::grow_regions(made());  // refused
  cn::min_cut(made());  // refused
  cn::segment_polys(made());  // refused
  cn::segment_verts(made());  // refused
  cn::segment_by_shape(made());  // refused
  cn::coarse_layout(made());  // refused
  cn::connected_components(made());  // refused
  cn::prepare_harmonic_map(made());  // refused
  cn::harmonic_map(made());  // refused
  cn::harmonic_coordinates(made());  // refused
  cn::skin(made());  // refused
  cn::prepare_deform(made());  // refused
  cn::frame_field(made());  // refused
  cn::principal_curvatures(made());  // refused
  cn::stripes(made());  // refused
  cn::biharmonic_deform(made());  // refused
  cn::laplacian_deform(made());  // refused
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
  cn::tutte(made());  // refused
  cn::lscm(made());  // refused
  cn::spectral_conformal(made());  // refused
  cn::arap_map(made());  // refused
  cn::injective_map(made());  // refused
  cn::direction_field(made());  // refused
  cn::trivial_connection(made());  // refused
  cn::map_distortion(made());  // refused
  cn::uv_at_corners(made());  // refused
  cn::make_poly_map<int>(made());  // refused
  cn::convert_with_correspondence<cn::polygonmesh>(made());  // refused
}

// The verts have no points.
void no_points(const cn::trimesh& m) {
  const auto pure = cn::only_surface_mesh(m);
  cn::dijkstra(pure, pure.vert(cn::vert_id{0}));  // refused
  cn::shortest_path(pure, pure.vert(cn::vert_id{0}), pure.vert(cn::vert_id{1}));  // refused
  cn::spanning_tree(pure);  // refused
  cn::cut_along(pure);  // refused
  cn::segment_by_shape(pure);  // refused
  cn::prepare_poisson(pure);  // refused
  cn::poisson(pure);  // refused
  cn::agglomerate(pure);  // refused
  cn::dual_mesh(pure);  // refused
  cn::voronoi_polyhedra({{0, 0, 0}}, pure);  // refused
  cn::catmull_clark_limit(pure);  // refused
  cn::loop_limit(pure);  // refused
  cn::quads_from_triangles(pure);  // refused
  cn::subdivide_1_to_4(pure);  // refused
  cn::subdivide_1_to_8(pure);  // refused
  cn::subdivide_barycentric(pure);  // refused
  cn::subdivide_catmull_clark(pure);  // refused
  cn::subdivide_loop(pure);  // refused
  cn::subdivide_midpoint(pure);  // refused
  cn::subdivide_root3(pure);  // refused
  cn::to_tets(pure);  // refused
  cn::to_triangles(pure);  // refused
  cn::boundary_surface(pure);  // refused
  cn::tetrahedralize(pure);  // refused
  cn::extrude(pure);  // refused
  cn::revolve(pure);  // refused
  cn::unite(pure);  // refused
  cn::coarse_layout(pure);  // refused
  cn::repaired(pure);  // refused
  cn::repair(pure);  // refused
  cn::voxel_hexes(pure);  // refused
  cn::offset_shell(pure);  // refused
  cn::grade(pure);  // refused
  cn::jitter(pure);  // refused
  cn::bounding_box(pure);  // refused
  cn::bounding_tree(pure);  // refused
  cn::centroid(pure);  // refused
  cn::circumcentre(pure);  // refused
  cn::enclosing_ball(pure);  // refused
  cn::enclosing_circle(pure);  // refused
  cn::inscribed_circle(pure);  // refused
  cn::kernel(pure);  // refused
  cn::width(pure);  // refused
  cn::centroids(pure);  // refused
  cn::corner_angle(pure);  // refused
  cn::angle_defects(pure);  // refused
  cn::dihedral_angle(pure);  // refused
  cn::dihedral_angles(pure);  // refused
  cn::adaptive_size(pure);  // refused
  cn::edge_length(pure);  // refused
  cn::edge_lengths(pure);  // refused
  cn::area(pure);  // refused
  cn::volume(pure);  // refused
  cn::measure(pure);  // refused
  cn::outward_vector(pure);  // refused
  cn::measures(pure);  // refused
  cn::total_measure(pure);  // refused
  cn::quality(pure, cn::metric::area);  // refused
  cn::worst(pure, cn::metric::area);  // refused
  cn::histogram(pure, cn::metric::area);  // refused
  cn::normal(pure);  // refused
  cn::vert_normal(pure);  // refused
  cn::poly_normals(pure);  // refused
  cn::face_normals(pure);  // refused
  cn::vert_normals(pure);  // refused
  cn::surface_normals(pure);  // refused
  cn::overhangs(pure);  // refused
  cn::bones(pure);  // refused
  cn::respace(pure);  // refused
  cn::tube(pure);  // refused
  cn::nearest_bone(pure);  // refused
  cn::skeleton_of(pure);  // refused
  cn::tutte(pure);  // refused
  cn::lscm(pure);  // refused
  cn::spectral_conformal(pure);  // refused
  cn::arap_map(pure);  // refused
  cn::injective_map(pure);  // refused
  cn::map_distortion(pure);  // refused
  cn::direction_field(pure);  // refused
  cn::trivial_connection(pure);  // refused
  cn::cage_coordinates(pure);  // refused
  cn::green_coordinates(pure);  // refused
  cn::harmonic_coordinates(pure);  // refused
  cn::skin(pure);  // refused
  cn::prepare_deform(pure);  // refused
  cn::frame_field(pure);  // refused
  cn::principal_curvatures(pure);  // refused
  cn::stripes(pure);  // refused
  cn::biharmonic_deform(pure);  // refused
  cn::laplacian_deform(pure);  // refused
  cn::heat_weights(pure);  // refused
  cn::bounded_biharmonic_weights(pure);  // refused
  cn::transfer_weights(pure);  // refused
  cn::best_build_direction(pure);  // refused
  cn::height_map(pure);  // refused
  cn::shadow_on_plate(pure);  // refused
  cn::thin_walls(pure, 1);  // refused
  cn::narrow_gaps(pure, 1);  // refused
  cn::self_intersections(pure);  // refused
  cn::divergence(pure);  // refused
  cn::divergence_matrix(pure);  // refused
  cn::gradient(pure);  // refused
  cn::vert_gradient(pure);  // refused
  cn::hodge_decomposition(pure);  // refused
  cn::form_vectors(pure);  // refused
  cn::resample(pure);  // refused
  cn::to_polys(pure);  // refused
  cn::statistics(pure);  // refused
  cn::rotated(pure);  // refused
  cn::gradient_matrix(pure);  // refused
  cn::vert_masses(pure);  // refused
  cn::mass_matrix(pure);  // refused
  cn::poly_masses(pure);  // refused
  cn::poly_mass_matrix(pure);  // refused
  cn::vert_gradient_matrix(pure);  // refused
  cn::save(pure);  // refused
  cn::save_pvtu(pure);  // refused
  cn::save_text(pure);  // refused
  cn::ambient_occlusion(pure);  // refused
  cn::ambient_occlusion_at_verts(pure);  // refused
  cn::make_drawable(pure);  // refused
  cn::make_arrows(pure);  // refused
  cn::make_balls(pure);  // refused
  cn::make_graph_tubes(pure);  // refused
  cn::scene().add(pure);  // refused
  cn::make_tubes(pure);  // refused
  cn::convert<cn::polygonmesh>(pure);  // refused
  cn::prepare_exact_geodesics(pure);  // refused
  cn::exact_geodesics(pure);  // refused
  cn::prepare_heat_geodesics(pure);  // refused
  cn::heat_geodesics(pure);  // refused
  cn::prepare_log_map(pure);  // refused
  cn::log_map(pure);  // refused
  cn::lowest_element(pure);  // refused
  cn::integral_line(pure);  // refused
  cn::integral_lines(pure);  // refused
  cn::starts_around(pure);  // refused
  cn::evenly_spaced_lines(pure);  // refused
  cn::prepare_parallel_transport(pure);  // refused
  cn::parallel_transport(pure);  // refused
  cn::prepare_trace_geodesic(pure);  // refused
  cn::trace_geodesic(pure);  // refused
  cn::karcher_mean(pure);  // refused
  cn::prepare_straighten(pure);  // refused
  cn::straighten(pure);  // refused
  cn::convert_with_correspondence<cn::polygonmesh>(pure);  // refused
  cn::isolines(pure);  // refused
  cn::isosurface(pure);  // refused
  cn::slice(pure);  // refused
  cn::slice_mesh(pure);  // refused
  cn::heights(pure);  // refused
  cn::clip(pure);  // refused
  cn::split(pure);  // refused
  cn::measure_between(pure);  // refused
  cn::to_verts(pure);  // refused
}

// Level sets of what is not a number at each vert.
void no_values(const cn::trimesh& m, const cn::tetmesh& t) {
  const auto colours = cn::make_vert_map<cn::vec3>(m);
  cn::isolines(m, colours, 0.5);  // refused
  cn::isosurface(t, colours, 0.5);  // refused
  cn::clip(m, colours, 0.5);  // refused
  cn::split(m, colours, 0.5);  // refused
  cn::measure_between(m, colours, {0.0, 1.0});  // refused
}

// A graph, for which no discretisation is the default.
void bare_graph(const cn::trimesh& m) {
  const auto g = cn::primal(m);
  const cn::vert_id a{0};
  const auto f = cn::make_vert_map<double>(m);
  cn::laplacian(g);  // refused
  cn::harmonic_map(g, {{a, 0.0}});  // refused
  cn::harmonic_map<cn::vec3>(g, {{a, {0, 0, 0}}});  // refused
  cn::prepare_harmonic_map(g, {a});  // refused
  cn::smooth(g, f, 1);  // refused
  cn::prepare_smooth(g, 1);  // refused
  cn::heat_flow(g, f, 1);  // refused
  cn::prepare_heat_flow(g, 1);  // refused
  cn::laplacian(g, cn::cotangent);  // refused
}

// A graph of polys, without dual(m).
void polys_alone(const cn::trimesh& m) {
  const auto g = cn::only_dual_graph(m);
  cn::bfs_forest(g);  // refused
  cn::connected_components(g);  // refused
  cn::spanning_tree(g);  // refused
}

// Numbers instead of descriptors.
void numbers(const cn::trimesh& m) {
  cn::bfs(m, 0);  // refused
  cn::dijkstra(m, 0);  // refused
  cn::shortest_path(m, 0);  // refused
  cn::grow_regions(m, 0);  // refused
  cn::min_cut(m, 0);  // refused
  cn::prepare_harmonic_map(m, 0);  // refused
  cn::harmonic_map(m, 0);  // refused
  cn::prepare_deform(m, 0);  // refused
  cn::prepare_poisson(m, 0);  // refused
  cn::centroid(m, 0);  // refused
  cn::circumcentre(m, 0);  // refused
  cn::enclosing_ball(m, 0);  // refused
  cn::enclosing_circle(m, 0);  // refused
  cn::inscribed_circle(m, 0);  // refused
  cn::kernel(m, 0);  // refused
  cn::width(m, 0);  // refused
  cn::corner_angle(m, 0);  // refused
  cn::dihedral_angle(m, 0);  // refused
  cn::edge_length(m, 0);  // refused
  cn::area(m, 0);  // refused
  cn::quality(m, 0, cn::metric::area);  // refused
  cn::chord_of(m, 0);  // refused
  cn::sheet_of(m, 0);  // refused
  cn::volume(m, 0);  // refused
  cn::measure(m, 0);  // refused
  cn::outward_vector(m, 0);  // refused
  cn::normal(m, 0);  // refused
  cn::vert_normal(m, 0);  // refused
  cn::prepare_exact_geodesics(m, 0);  // refused
  cn::exact_geodesics(m, 0);  // refused
  cn::prepare_heat_geodesics(m, 0);  // refused
  cn::heat_geodesics(m, 0);  // refused
  cn::log_map(m, 0);  // refused
  cn::parallel_transport(m, 0);  // refused
  cn::trace_geodesic(m, 0);  // refused
  cn::karcher_mean(m, {0, 1});  // refused
  cn::straighten(m, {0, 1});  // refused
  cn::integral_line(m, cn::make_poly_map<cn::vec3>(m), 0);  // refused
  cn::integral_line(m, cn::make_poly_map<cn::vec3>(m), cn::edge_point<cn::trimesh>{cn::edge_id{0}, 0.5});  // refused
  cn::starts_around(m, 0);  // refused
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
  cn::visible_polys(m, cn::labeled(at_verts, {1}));  // refused
  cn::visible_facets(m, cn::labeled(at_verts, {1}));  // refused
  cn::visible_faces(m, cn::labeled(at_verts, {1}));  // refused
  cn::exposed_facets(m, cn::labeled(at_verts, {1}));  // refused
  cn::visible_faces(m, cn::below('x', 1));  // refused
}

// A mesh instead of outlines.
void outlines(const cn::trimesh& m) {
  cn::triangulate(m);  // refused
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
  cn::save_pvtu(m, "a", other);  // refused
  cn::load_slice<stranger>("a", 0, 1);  // refused
}

// No back end.
void no_clipper(const cn::slices& s, const cn::slice_layer& layer, const cn::planar_regions& r, const cn::trimesh& m) {
  cn::layer_regions(layer);  // refused
  cn::region_union(r, r);  // refused
  cn::region_difference(r, r);  // refused
  cn::region_intersection(r, r);  // refused
  cn::region_offset(r, 1);  // refused
  cn::thicken(layer.open, 1);  // refused
  cn::slices_to_mesh(s);  // refused
  cn::slices_to_volume(s);  // refused
  cn::shadow_on_plate(m);  // refused
}
