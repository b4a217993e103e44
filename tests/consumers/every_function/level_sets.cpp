#include "call.hpp"

#include <concino/level_sets.hpp>

void call_level_sets() {
  const cn::plane half{{0, 1, 0}, 0.4};
  call("clip", [&](auto& m) {
    cn::clip(m, half);
    cn::clip(m, heights(m), 0.4);
  }, all);
  call("split", [&](auto& m) {
    cn::split(m, half);
    cn::split(m, heights(m), 0.4);
  }, all);
  call("slice", [&](auto& m) { cn::slice(m, half); }, all);
  call("isolines", [](auto& m) { cn::isolines(m, heights(m), {0.4}); }, surfaces);
  call("isosurface", [](auto& m) {
    cn::isosurface(m, heights(m), {0.4});
    cn::isosurface<cn::trimesh>(m, heights(m), {0.4});
  }, volumes);
  call("embed_isolines", [](auto& m) { cn::embed_isolines(m, heights(m), 0.4); }, kinds<cn::trimesh, cn::polygonmesh>());
  call("embed_isosurface", [](auto& m) { cn::embed_isosurface(m, heights(m), 0.4); }, kinds<cn::tetmesh, cn::polyhedralmesh>());
  call("embed_path", [](auto& m) {
    const auto [a, b] = cn::end_verts(m, first(cn::edges(m)));
    cn::embed_path(m, std::vector{a, b});
  }, kinds<cn::trimesh, cn::polygonmesh>());
  call("measure_between", [](auto& m) { cn::measure_between(m, heights(m), {0.2, 0.4}); }, all);
  call("to_verts", [](auto& m) { cn::to_verts(m, cn::make_poly_map<double>(m, 1.0)); }, all);
}
