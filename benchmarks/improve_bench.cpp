// Measures the improvement of tets and the smoothing of points. The floor computes the value that is improved for every poly a hundred times.
#include "support/kinds.hpp"

#include <concino/mesh.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/quality.hpp>
#include <concino/remesh.hpp>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace {

using concino::metric;

/// The CPU seconds that edit(mesh) takes on a copy of m.
template<class M, class Edit>
double seconds_on_copy(const M& m, const Edit& edit) {
  auto copy = std::make_unique<M>(m);
  return bench::seconds_of([&] { return edit(*copy); });
}

template<class M, class Edit>
void compare_improvement(const bench::program& p, const std::string& work, const M& m, metric what, const Edit& edit) {
  if (!p.wants(work)) return;
  const auto floor = [&] {
    double sum = 0;
    for (unsigned i = 0; i < 100; ++i) sum += concino::worst(m, what).value;
    return sum;
  };
  p.print(bench::compare(work, std::min(p.rounds, 3), {{"floor", [&] { return bench::seconds_of(floor); }}, {"concino", [&] { return seconds_on_copy(m, edit); }}}));
  M after = m;
  const auto num_moves = edit(after);
  const double worst = concino::worst(m, what).value, best = concino::worst(after, what).value;
  std::fprintf(stderr, "%s: %zu polys, worst %.3g -> %zu polys, worst %.3g\n", work.c_str(), concino::num_polys(m), worst, concino::num_polys(after), best);
  if (best < worst || (num_moves > 0 && best == worst)) throw std::runtime_error(work + ": nothing became better");
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    concino::tetmesh tets(p.data.tet200k());
    concino::jitter(tets, 0.3);
    for (const int angle : {15, 30})
      compare_improvement(p, "improve.tet200k." + std::to_string(angle), tets, metric::scaled_jacobian,
                          [angle](concino::tetmesh& m) { return concino::improve(m, {.min_dihedral_deg = double(angle)}).num_moves; });
    concino::hexmesh hexes(bench::hex_grid(p.data.tiny ? 3 : 50));
    concino::jitter(hexes, 0.3);
    compare_improvement(p, "smooth_points.hex125k", hexes, metric::scaled_jacobian, [](concino::hexmesh& m) { return concino::smooth_points(m).num_moves; });
    compare_improvement(p, "smooth_points.hex125k.slides", hexes, metric::scaled_jacobian, [](concino::hexmesh& m) { return concino::smooth_points(m, {.slides = true}).num_moves; });
    concino::trimesh triangles(p.data.bunny16());
    compare_improvement(p, "smooth_points.bunny16", triangles, metric::mean_ratio, [](concino::trimesh& m) { return concino::smooth_points(m).num_moves; });
  });
}
