#include "call.hpp"

#include <concino/fields.hpp>
#include <concino/fields/eigenfunctions.hpp>
#include <concino/operators/gradient.hpp>

namespace {

constexpr cn::vert_id a{0}, b{3};

void call_problems() {
  call("prepare_harmonic_map", [](auto& m) { cn::prepare_harmonic_map(m, {a, b}); }, all);
  call("harmonic_map", [](auto& m) { cn::harmonic_map(m, {{a, 0.0}, {b, 1.0}}); }, all);
  call("prepare_poisson", [](auto& m) { cn::prepare_poisson(m, {a}); }, all);
  call("poisson", [](auto& m) { cn::poisson(m, heights(m), {.values = {{a, 0.0}}}); }, all);
  call("prepare_heat_flow", [](auto& m) { cn::prepare_heat_flow(m, 0.1); }, all);
  call("heat_flow", [](auto& m) { cn::heat_flow(m, heights(m), 0.1); }, all);
  call("prepare_smooth", [](auto& m) { cn::prepare_smooth(m, 0.1); }, all);
  call("smooth", [](auto& m) { cn::smooth(m, heights(m), 0.1); }, all);
  call("prepare_heat_geodesics", [](auto& m) { cn::prepare_heat_geodesics(m); }, all);
  call("heat_geodesics", [](auto& m) { cn::heat_geodesics(m, {a}); }, all);
  call("eigenfunctions", [](auto& m) { cn::eigenfunctions(m, 1, cn::lobpcg); }, all);
  call("hodge_decomposition", [](auto& m) { cn::hodge_decomposition(m, cn::gradient(m, heights(m))); }, kinds<cn::trimesh, cn::tetmesh>());
  call("hodge_decomposition", [](auto& m) { cn::hodge_decomposition(m, cn::make_edge_map<double>(m, 1.0)); }, triangles);
  call("form_vectors", [](auto& m) { cn::form_vectors(m, cn::make_edge_map<double>(m, 1.0)); }, triangles);
}

void call_geodesics() {
  call("prepare_exact_geodesics", [](auto& m) { cn::prepare_exact_geodesics(m); }, triangles);
  call("exact_geodesics", [](auto& m) { cn::exact_geodesics(m, {a}); }, triangles);
  call("prepare_log_map", [](auto& m) { cn::prepare_log_map(m); }, surfaces);
  call("log_map", [](auto& m) { cn::log_map(m, a); }, surfaces);
  call("prepare_parallel_transport", [](auto& m) { cn::prepare_parallel_transport(m); }, surfaces);
  call("parallel_transport", [](auto& m) { cn::parallel_transport(m, {{a, cn::tangent_vector{1, 0}}}); }, surfaces);
}

void call_topology() {
  call("contour_tree", [](auto& m) { cn::contour_tree(m, heights(m)); }, all);
  call("reeb_graph", [](auto& m) { cn::reeb_graph(m, heights(m)); }, all);
  call("critical_points", [](auto& m) { cn::critical_points(m, heights(m)); }, all);
  call("persistence", [](auto& m) { cn::persistence(m, heights(m)); }, all);
  call("regions_of_maxima", [](auto& m) { cn::regions_of_maxima(m, heights(m)); }, all);
  call("regions_of_minima", [](auto& m) { cn::regions_of_minima(m, heights(m)); }, all);
  call("simplified", [](auto& m) { cn::simplified(m, heights(m), {.minima_below = 0.1}); }, all);
  call("simplified_on_cells", [](auto& m) { cn::simplified_on_cells(m, heights(m), {.below = 0.1}); }, surfaces);
}

}  // namespace

void call_fields() {
  call_problems();
  call_geodesics();
  call_topology();
  call("normalized", [](auto& m) {
    cn::normalized(m, heights(m));
    cn::normalized(m, cn::make_poly_map<double>(m, 1.0));
    cn::normalized(m, cn::gradient(m, heights(m)));
  }, all);
  call("statistics", [](auto& m) { cn::statistics(m, heights(m)); }, all);
  call("to_polys", [](auto& m) { cn::to_polys(m, heights(m)); }, all);
  call("resample", [](auto& m) {
    cn::resample(m, heights(m), m);
    cn::resample(m, cn::make_poly_map<double>(m, 1.0), m);
  }, all);
}
