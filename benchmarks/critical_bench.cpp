// Measures what tells the shape of a function: its critical points and pairs of extrema and saddles, for a rough function with many of them; contour trees against
// Reeb graphs of the same function, which are equal.
#include "support/kinds.hpp"

#include <concino/fields/contour_tree.hpp>
#include <concino/fields/critical_points.hpp>
#include <concino/fields/persistence.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace {

namespace floors = bench::floors;
namespace cn = concino;

/// Waves with disturbances that do not depend on the order of the verts.
template<class M>
auto rough_values(const M& m) {
  auto u = cn::make_vert_map<double>(m);
  for (const auto v : cn::verts(m)) {
    const cn::vec3 x = cn::to_vec3(cn::point(m, v));
    u[v] = std::sin(9 * x.x) * std::cos(7 * x.y) + 0.2 * std::sin(51 * x.x + 40 * x.z) + 0.01 * std::sin(1e5 * (x.x + 1.3 * x.y + 1.7 * x.z));
  }
  return u;
}

template<class M>
void critical(const bench::program& p, const std::string& name, const M& m) {
  const std::string work = "critical." + name;
  const auto u = rough_values(m);
  const auto points = cn::critical_points(m, u);
  const auto pairs = cn::persistence(m, u);
  if (points.count[0] != pairs.minima.size()) throw std::runtime_error(work + ": not every minimum is in one pair");
  p.print(bench::compare(work, p.rounds, {{"concino", [&] {
                                            return bench::seconds_of([&] { return cn::critical_points(m, u).verts.size() + cn::persistence(m, u).minima.size(); });
                                          }}}));
}

template<class M>
void contour(const bench::program& p, const std::string& name, const M& m) {
  const std::string work = "contour." + name;
  const auto u = rough_values(m);
  if (cn::contour_tree(m, u).arcs.size() != cn::reeb_graph(m, u).arcs.size()) throw std::runtime_error(work + ": the tree and the graph differ");
  const auto timed = [](auto f) { return [f] { return bench::seconds_of(f); }; };
  p.print(bench::compare(work, p.rounds, {{"concino", timed([&] { return cn::contour_tree(m, u); })}, {"reeb", timed([&] { return cn::reeb_graph(m, u); })}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("critical.tri1m")) critical(p, "tri1m", cn::trimesh(p.data.tri1m()));
    if (p.wants("contour.tet1m")) contour(p, "tet1m", cn::tetmesh(p.data.tet1m()));
    if (p.wants("critical.tet1m")) critical(p, "tet1m", cn::tetmesh(p.data.tet1m()));
  });
}
