// Links the installed library and calls every public function of every module.
#include "call.hpp"

void call_convert(), call_core(), call_deform(), call_directions(), call_edit(), call_fields(), call_generate(), call_geometry(), call_graph(), call_io(), call_layout(), call_level_sets(), call_lines(),
    call_mesh(), call_operators(), call_optimize(), call_parametrize(), call_print(), call_quality(), call_remesh(), call_render(), call_repair(), call_skeleton(), call_solve(), call_testing(), call_validate();

int main() {
  for (const auto calls :
       {call_convert, call_core, call_deform, call_directions, call_edit, call_fields, call_generate, call_geometry, call_graph, call_io, call_layout, call_level_sets, call_lines, call_mesh,
        call_operators, call_optimize, call_parametrize, call_print, call_quality, call_remesh, call_render, call_repair, call_skeleton, call_solve, call_testing, call_validate})
    calls();
  std::printf("%d calls, %d failed\n", num_calls, num_failures);
  return num_failures == 0 ? 0 : 1;
}
