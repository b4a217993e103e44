// Measures graph cuts: seconds for the best of two labels for each of 10^6 polys. Each poly prefers one label by a random cost, in one half of the mesh
// more often label 0, in the other more often label 1; different neighbours cost 0.3.
#include "support/kinds.hpp"

#include <concino/geometry/centroid.hpp>
#include <concino/graph/segment.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace {

namespace cn = concino;

/// A number in [0, 1) that differs from poly to poly.
double noise(std::size_t i) {
  std::uint64_t x = (static_cast<std::uint64_t>(i) + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

template<class M>
void segment(const bench::program& p, const std::string& name, const M& m) {
  const std::string work = "segment." + name;
  double middle = 0;
  for (const auto x : cn::polys(m)) middle += cn::vert_mean(m, x).x / static_cast<double>(cn::num_polys(m));
  auto first_costs = cn::make_poly_map<double>(m);  // of label 0; that of label 1 is the rest to 1
  for (const auto x : cn::polys(m)) first_costs[x] = 0.6 * noise(cn::index_of(m, x)) + (cn::vert_mean(m, x).x < middle ? 0 : 0.4);
  const auto cost = [&](const auto& x, int label) { return label == 0 ? first_costs[x] : 1 - first_costs[x]; };
  const auto cut = [&] {
    const auto found = cn::segment_polys(m, cost, {.labels = 2, .smoothness = 0.3});
    if (!(found.energy <= found.rounds.front())) throw std::runtime_error("segment: the energy has risen");
    return found.energy;
  };
  p.print(bench::compare(work, p.rounds, {{"concino", [&] { return bench::seconds_of(cut); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("segment.tri1m")) segment(p, "tri1m", cn::trimesh(p.data.tri1m()));
    if (p.wants("segment.tet1m")) segment(p, "tet1m", cn::tetmesh(p.data.tet1m()));
  });
}
