#include "call.hpp"

#include <concino/parametrize.hpp>

void call_parametrize() {
  call("tutte", [](auto& m) { cn::tutte(m); }, surfaces);
  call("lscm", [](auto& m) { cn::lscm(m); }, surfaces);
  call("spectral_conformal", [](auto& m) { cn::spectral_conformal(m); }, surfaces);
  call("arap_map", [](auto& m) { cn::arap_map(m); }, surfaces);
  call("injective_map", [](auto& m) { cn::injective_map(m); }, surfaces);
  call("map_distortion", [](auto& m) { cn::map_distortion(m, cn::make_vert_map<cn::uv_point>(m)); }, surfaces);
  call("uv_at_corners", [](auto& m) { cn::uv_at_corners(m, cn::polys(m), m, cn::make_vert_map<cn::uv_point>(m)); }, surfaces);
}
