#include "call.hpp"

#include <concino/lines.hpp>
#include <concino/operators/gradient.hpp>

void call_lines() {
  call("integral_line", [](auto& m) {
    cn::integral_line(m, cn::gradient(m, heights(m)), first(cn::polys(m)));
    const auto h = cn::vert_gradient(m, heights(m));
    cn::integral_line(m, cn::field_at_verts(h), first(cn::polys(m)));
  }, all);
  call("integral_lines", [](auto& m) {
    const std::vector starts{first(cn::polys(m))};
    cn::integral_lines(m, cn::gradient(m, heights(m)), starts);
    const auto h = cn::vert_gradient(m, heights(m));
    cn::integral_lines(m, cn::field_at_verts(h), starts);
  }, all);
  call("starts_around", [](auto& m) { cn::starts_around(m, first(cn::polys(m))); }, all);
  call("evenly_spaced_lines", [](auto& m) { cn::evenly_spaced_lines(m, cn::gradient(m, heights(m)), {.distance = 0.3}); }, surfaces);
  call("karcher_mean", [](auto& m) { cn::karcher_mean(m, {cn::vert_id{0}, cn::vert_id{1}}); }, surfaces);
  call("prepare_straighten", [](auto& m) { cn::prepare_straighten(m); }, surfaces);
  call("straighten", [](auto& m) {
    const auto [a, b] = cn::end_verts(m, first(cn::edges(m)));
    cn::straighten(m, {a, b});
  }, surfaces);
  call("prepare_trace_geodesic", [](auto& m) { cn::prepare_trace_geodesic(m); }, surfaces);
  call("trace_geodesic", [](auto& m) { cn::trace_geodesic(m, cn::vert_id{0}, cn::vec3{1, 1, 0}, 0.3); }, surfaces);
}
