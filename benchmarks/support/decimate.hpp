// Decimation of a surface to a tenth of its triangles, by the library and a peer. Each run works on a copy of the mesh, which is made before the clock starts.
// Beside the times, standard error says how far each result is from the input, by the library's hausdorff_distance.
#pragma once

#include "program.hpp"

#include <concino/mesh.hpp>
#include <concino/remesh.hpp>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace bench {

/// The CPU seconds that decimate(mesh) takes on a copy of m.
template<class M, class Decimate>
double seconds_of_decimation(const M& m, const Decimate& decimate) {
  auto copy = std::make_unique<M>(m);
  return seconds_of([&] { return decimate(*copy); });
}

/// Peer: static decimate(m, target number of triangles), which returns a number that depends on the result, and to_concino(m).
template<class Peer, class PeerMesh>
void compare_decimation(const program& p, const char* name, const std::string& data, const surface_arrays& arrays, const PeerMesh& theirs) {
  const std::string work = "decimate.tenth." + data;
  if (!p.wants(work)) return;
  const concino::trimesh ours(arrays);
  const std::size_t target = concino::num_polys(ours) / 10;
  const auto mine = [target](concino::trimesh& m) { return concino::decimate(m, {.target_polys = target, .measure_error = false}).num_collapses; };
  const auto peer = [target](PeerMesh& m) { return Peer::decimate(m, target); };
  p.print(compare(work, p.rounds, {{name, [&] { return seconds_of_decimation(theirs, peer); }}, {"concino", [&] { return seconds_of_decimation(ours, mine); }}}));
  auto a = ours;
  mine(a);
  auto b = theirs;
  peer(b);
  const auto other = Peer::to_concino(b);
  if (concino::num_polys(other) > target + target / 20) throw std::runtime_error(work + ": " + name + " did not reach the target");
  std::fprintf(stderr, "%s: errors %.3g (concino, %zu triangles), %.3g (%s, %zu triangles)\n", work.c_str(), concino::hausdorff_distance(ours, a).upper,
               concino::num_polys(a), concino::hausdorff_distance(ours, other).upper, name, concino::num_polys(other));
}

}  // namespace bench
