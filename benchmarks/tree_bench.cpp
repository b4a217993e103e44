// Measures trees over the polys of surfaces and volumes: building a tree, and 100,000 queries of each kind. peers/cgal_tree_bench.cpp measures the peer.
#include "support/kinds.hpp"
#include "support/queries.hpp"

#include <concino/geometry/self_intersections.hpp>
#include <concino/mesh.hpp>

namespace {

template<class M>
void questions(const bench::program& p, const std::string& name, const M& m) {
  const auto row = [&](const std::string& work, auto run) {
    if (p.wants(work + "." + name)) p.print(bench::compare(work + "." + name, p.rounds, {{"concino", [&] { return bench::seconds_of(run); }}}));
  };
  const std::size_t n = p.data.tiny ? 100 : 100000;
  const auto near = bench::places_near(m, n, 0.1), within = bench::places_near(m, n, -0.01);
  row("tree.build", [&] { return concino::bounding_tree(m); });
  const auto tree = concino::bounding_tree(m);
  row("tree.closest", [&] { return bench::sum_of_distances(tree, near); });
  row("tree.ray", [&] { return bench::rays_that_hit(tree, near); });
  row("tree.inside", [&] {
    std::size_t inside = 0;
    for (const auto& x : near) inside += tree.is_inside(x);
    return inside;
  });
  if constexpr (concino::VolumeMesh<M>) {
    row("tree.locate", [&] {
      std::size_t found = 0;
      for (const auto& x : within) found += tree.locate(x).has_value();
      if (2 * found < within.size()) throw std::runtime_error("tree.locate." + name + ": most points are in no poly");
      return found;
    });
  } else {
    row("self-intersections", [&] { return concino::self_intersections(m); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto any = [&](const std::string& name) {
      for (const char* work : {"tree.build.", "tree.closest.", "tree.ray.", "tree.inside.", "tree.locate.", "self-intersections."})
        if (p.wants(work + name)) return true;
      return false;
    };
    if (any("tri1m")) questions(p, "tri1m", concino::trimesh(p.data.tri1m()));
    if (any("poly228k")) questions(p, "poly228k", concino::polygonmesh(p.data.poly228k()));
    if (any("tet1m")) questions(p, "tet1m", concino::tetmesh(p.data.tet1m()));
    if (any("hex216k")) questions(p, "hex216k", concino::polyhedralmesh(p.data.hex216k()));
    if (any("dual200k")) questions(p, "dual200k", concino::polyhedralmesh(p.data.dual200k()));
  });
}
