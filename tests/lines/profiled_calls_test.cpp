// integral_lines and evenly_spaced_lines open scopes in a profiler.
#include <concino/lines/evenly_spaced_lines.hpp>
#include <concino/lines/field_at_verts.hpp>
#include <concino/lines/integral_line.hpp>

#include <support/kinds.hpp>
#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: integral_lines and evenly_spaced_lines open scopes") {
  const auto m = grid<trimesh>(3);
  const auto g = make_poly_map<vec3>(m, vec3{1, 0, 0});
  const auto h = make_vert_map<vec3>(m, vec3{1, 0, 0});
  profiler p;
  integral_lines(m, g, polys(m), {.profiler = &p});
  integral_lines(m, field_at_verts(h), polys(m), {.profiler = &p});
  evenly_spaced_lines(m, g, {.distance = 0.3, .profiler = &p});
  CHECK(names_of(p) == names{"integral_lines", "-integral_lines", "evenly_spaced_lines", "-evenly_spaced_lines"});
  CHECK(p.entries()[0].calls == 2);
}
