#include "call.hpp"

#include <concino/directions.hpp>

#include <type_traits>
#include <utility>
#include <vector>

void call_directions() {
  call("frame_field", [](auto& m) { cn::frame_field(m); }, volumes);
  call("singular_edges", [](auto& m) { cn::singular_edges(cn::frame_field(m)); }, volumes);
  call("direction_field", [](auto& m) { cn::direction_field(m); }, surfaces);
  call("singularities", [](auto& m) { cn::singularities(cn::direction_field(m)); }, surfaces);
  call("boundary_turns", [](auto& m) { cn::boundary_turns(cn::direction_field(m)); }, surfaces);
  call("trivial_connection", [](auto& m) {
    const std::vector<std::pair<cn::vert_t<std::remove_cvref_t<decltype(m)>>, int>> none;  // a grid has one loop of the boundary, with what is left
    cn::trivial_connection(m, none);
  }, surfaces);
  call("load_rosy", [] { cn::save_rosy(cn::rosy{4, {{1, 0, 0}}}, "field.rosy"); cn::load_rosy("field.rosy"); });
  call("load_rosy_text", [] { cn::load_rosy_text("1 4\n1 0 0\n"); });
  call("save_rosy", [] { cn::save_rosy(cn::rosy{4, {{1, 0, 0}}}, "field.rosy"); });
  call("principal_curvatures", [](auto& m) { cn::principal_curvatures(m); }, surfaces);
  call("direction_field", [](auto& m) { cn::direction_field(m); }, surfaces);
  call("singularities", [](auto& m) { cn::singularities(cn::direction_field(m)); }, surfaces);
  call("boundary_turns", [](auto& m) { cn::boundary_turns(cn::direction_field(m)); }, surfaces);
  call("stripes", [](auto& m) { cn::stripes(m, cn::direction_field(m, {.symmetry = 2}), 1); }, surfaces);
  call("stripe_lines", [](auto& m) { cn::stripe_lines(cn::stripes(m, cn::direction_field(m, {.symmetry = 2}), 1)); }, surfaces);
}
