#include "call.hpp"

#include <concino/remesh.hpp>

void call_remesh() {
  call("adaptive_size", [](auto& m) { cn::adaptive_size(m, {.chord_error = 0.1}); }, triangles);
  call("decimate", [](auto& m) { cn::decimate(m, {.target_polys = 4}); }, triangles);
  call("improve", [](auto& m) { cn::improve(m); }, tets);
  call("remesh", [](auto& m) { cn::remesh(m, {.edge_length = 0.4}); }, triangles);
  call("smooth_points", [](auto& m) {
    cn::smooth_points(m);
    cn::smooth_points(m, {.slides = true}, [](cn::vert_id) { return false; }, [](cn::edge_id) { return false; }, [](cn::poly_id) { return 0; });
  }, kinds<cn::trimesh, cn::tetmesh>());
}
