// Measures tetrahedralize by TetGen beside TetGen alone and beside TetGen with building a mesh of its tets, as wall-clock time, since TetGen runs in a
// child process. The check of the surface does not count; standard error has its time, and that of the verification.
#include "../support/program.hpp"

#include <concino/adapters/tetgen.hpp>
#include <concino/mesh.hpp>

#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void compare_filling(const bench::program& p, const std::string& work, const bench::surface_arrays& a, const concino::tetrahedralize_options& options) {
  if (!p.wants(work)) return;
  const concino::trimesh m(a);
  concino::tetrahedralize_input input{a.points, {}, 0, {}};
  for (std::size_t i = 0; i < a.verts.size(); i += 3) input.triangles.push_back({a.verts[i].raw(), a.verts[i + 1].raw(), a.verts[i + 2].raw()});
  input.surface_triangles = input.triangles.size();
  const auto tetgen_alone = [&](bool with_mesh) {
    const concino::detail::tetgen_input given{input, options};
    tetgenio in, out;
    given.fill(in);
    std::string switches = given.switches();
    const double start = now();
    ::tetrahedralize(switches.data(), &in, &out);
    concino::tetmesh mesh;
    if (with_mesh) {
      concino::cell_arrays cells;
      for (int i = 0; i < out.numberofpoints; ++i) cells.points.push_back({out.pointlist[3 * i], out.pointlist[3 * i + 1], out.pointlist[3 * i + 2]});
      for (int i = 0; i < out.numberoftetrahedra; ++i)
        for (const int k : {0, 1, 3, 2}) cells.verts.push_back(concino::vert_id{static_cast<std::uint32_t>(out.tetrahedronlist[4 * i + k])});
      mesh = concino::tetmesh(std::move(cells));
    }
    return now() - start;
  };
  concino::tetrahedralize_report report;
  const auto ours = [&] {
    const double start = now();
    const auto tets = concino::tetrahedralize(m, concino::tetgen, options);
    const double seconds = now() - start;
    report = tets.report;
    return seconds - report.seconds_of_check;
  };
  p.print(bench::compare(work, p.rounds, {{"tetgen", [&] { return tetgen_alone(false); }}, {"tetgen_with_mesh", [&] { return tetgen_alone(true); }}, {"concino", ours}}));
  std::fprintf(stderr, "%s: check %.3f s, TetGen %.3f s, verification %.3f s\n", work.c_str(), report.seconds_of_check, report.seconds_of_back_end, report.seconds_of_verification);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    compare_filling(p, "tetrahedralize.bunny", p.data.bunny(), {});
    compare_filling(p, "tetrahedralize.quality.bunny", p.data.bunny(), {.radius_edge = 1.4});
  });
}
