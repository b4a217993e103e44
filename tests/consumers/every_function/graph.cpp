#include "call.hpp"

#include <concino/generate/torus.hpp>
#include <concino/graph.hpp>
#include <concino/graph/boost.hpp>
#include <concino/graph/boundary_verts.hpp>
#include <concino/graph/min_cut.hpp>
#include <concino/graph/property_map.hpp>
#include <concino/graph/segment.hpp>
#include <concino/graph/segment_by_shape.hpp>

void call_graph() {
  const cn::vert_id a{0}, b{3};
  call("bfs", [&](auto& m) {
    cn::bfs(m, a);
    cn::bfs(m, {first(cn::polys(m))});
  }, all);
  call("bfs_forest", [&](auto& m) { cn::bfs_forest(m); }, all);
  call("dijkstra", [&](auto& m) { cn::dijkstra(m, a); }, all);
  call("shortest_path", [&](auto& m) { cn::shortest_path(m, a, b); }, all);
  call("path_to", [&](auto& m) {
    auto from = cn::make_vert_map<cn::vert_id>(m);
    cn::bfs(m, a, {.predecessors = &from});
    cn::path_to(from, b);
  }, all);
  call("grow_regions", [&](auto& m) { cn::grow_regions(m, {a, b}, [](auto&&...) { return 1.0; }); }, all);
  call("min_cut", [&](auto& m) { cn::min_cut(m, a, b, [](auto&&...) { return 1.0; }); }, all);
  call("segment_polys", [&](auto& m) { cn::segment_polys(m, [](auto, int l) { return l; }, {.labels = 3}); }, all);
  call("segment_verts", [&](auto& m) { cn::segment_verts(m, [](auto, int l) { return l; }); }, all);
  call("segment_by_shape", [&](auto& m) { cn::segment_by_shape(m, {.labels = 2, .likeness = cn::part_likeness::distance}); }, all);
  call("connected_components", [&](auto& m) { cn::connected_components(m); }, all);
  call("spanning_tree", [&](auto& m) { cn::spanning_tree(m); }, all);
  call("boundary_verts", [&](auto& m) { cn::boundary_verts(m); }, all);
  call("boundary_loops", [&](auto& m) { cn::boundary_loops(m); }, surfaces);
  call("cut_along", [&](auto& m) { cn::cut_along(m, {first(cn::edges(m))}); }, surfaces);
  call("tree_cotree", [&](auto& m) { cn::tree_cotree(cn::make_torus<std::remove_reference_t<decltype(m)>>({.cells = {4, 4}})); }, surfaces);
  call("homology_generators", [&](auto& m) { cn::homology_generators(cn::make_torus<std::remove_reference_t<decltype(m)>>({.cells = {4, 4}})); }, surfaces);
  call("boost_map", [&](auto& m) {
    auto u = heights(m);
    cn::boost_map(u);
  }, all);
  call("boost_weights", [&](auto& m) { cn::boost_weights(cn::primal(m), [](auto, auto) { return 1.0; }); }, all);
  call("boost_edge_map", [&](auto& m) { cn::boost_edge_map<double>(cn::primal(m)); }, all);
  call("directed", [&](auto& m) {
    const auto g = cn::primal(m);
    cn::directed(g);
  }, all);
  call("as_map", [&](auto& m) {
    auto u = heights(m);
    cn::as_map(cn::boost_map(u));
  }, all);
}
