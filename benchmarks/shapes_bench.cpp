// Measures circles, kernels and widths of all polys of a mesh, the bones of a graph and a tube around it: seconds.
#include "support/kinds.hpp"

#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/width.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/quality/poly_quality.hpp>
#include <concino/skeleton/bones.hpp>
#include <concino/skeleton/tube.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace {

namespace cn = concino;

/// The sum of a number of each poly.
template<class M, class F>
void sum(const bench::program& p, const std::string& work, const M& m, const F& number_of) {
  if (!p.wants(work)) return;
  const auto all = [&] {
    double total = 0;
    for (const auto x : cn::polys(m)) total += number_of(x);
    return total;
  };
  if (!(all() > 0)) throw std::runtime_error(work + ": the sum is not positive");
  p.print(bench::compare(work, p.rounds, {{"concino", [&] { return bench::seconds_of(all); }}}));
}

/// A binary tree of n nodes, with radii.
cn::skeleton branched(std::size_t n) {
  std::vector<cn::vec3> points;
  std::vector<std::array<cn::vert_id, 2>> edges;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    points.push_back({std::sin(0.7 * t) * t, std::cos(1.3 * t) * t, t});
    if (i % 8 != 0 || i == 0) {
      if (i > 0) edges.push_back({cn::vert_id{static_cast<unsigned>(i - 1)}, cn::vert_id{static_cast<unsigned>(i)}});
    } else {
      edges.push_back({cn::vert_id{static_cast<unsigned>((i - 8) / 2)}, cn::vert_id{static_cast<unsigned>(i)}});
    }
  }
  return cn::skeleton(points, edges, std::vector<double>(n, 0.1));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("shapes.")) {
      const cn::polygonmesh m(p.data.poly228k());
      sum(p, "shapes.inscribed-circle.poly228k", m, [&](const auto x) { return cn::inscribed_circle(m, x).radius; });
      sum(p, "shapes.enclosing-circle.poly228k", m, [&](const auto x) { return cn::enclosing_circle(m, x).radius; });
      sum(p, "shapes.kernel.poly228k", m, [&](const auto x) { return cn::kernel(m, x).area; });
      sum(p, "shapes.width.poly228k", m, [&](const auto x) { return cn::width(m, x).width; });
      const cn::polyhedralmesh cells(p.data.dual200k());
      sum(p, "shapes.kernel.dual200k", cells, [&](const auto x) { return cn::kernel(cells, x).volume; });
      sum(p, "shapes.width.dual200k", cells, [&](const auto x) { return cn::width(cells, x).width; });
    }
    const auto k = branched(p.data.tiny ? 100 : 100'000);
    const auto along = [&] { return cn::bones(k).size(); };
    const auto around = [&] { return cn::num_polys(cn::tube(k)); };
    if (p.wants("bones.tree100k")) p.print(bench::compare("bones.tree100k", p.rounds, {{"concino", [&] { return bench::seconds_of(along); }}}));
    if (p.wants("tube.tree100k")) p.print(bench::compare("tube.tree100k", p.rounds, {{"concino", [&] { return bench::seconds_of(around); }}}));
  });
}
