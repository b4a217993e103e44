// Measures the dual of a large triangle mesh against a floor that walks around its verts; the dual of a tet mesh and subdivisions, quads of
// triangles, tets of hexes, shells, voxels and boundary surfaces against building the result alone.
#include "support/arrays_of.hpp"
#include "support/kinds.hpp"

#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/offset_shell.hpp>
#include <concino/generate/quads_from_triangles.hpp>
#include <concino/generate/subdivide_1_to_4.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/subdivide_loop.hpp>
#include <concino/generate/subdivide_midpoint.hpp>
#include <concino/generate/to_tets.hpp>
#include <concino/generate/voxel_hexes.hpp>

#include <stdexcept>

namespace {

using bench::u32;
namespace floors = bench::floors;
namespace cn = concino;

/// The dual of a closed, manifold, consistently oriented triangle mesh, with all its adjacencies.
floors::surface<0> dual_of(const floors::surface<3>& m) {
  const u32 nv = m.num_verts(), np = m.num_polys();
  floors::surface<0> d;
  d.points.resize(3 * np);
  for (u32 p = 0; p < np; ++p)
    for (u32 k = 0; k < 3; ++k)
      d.points[3 * p + k] = (m.points[3 * m.p2v[3 * p] + k] + m.points[3 * m.p2v[3 * p + 1] + k] + m.points[3 * m.p2v[3 * p + 2] + k]) / 3;
  d.p_off.resize(nv + 1);
  d.p2v.resize(3 * np);
  u32 n = 0;
  for (u32 v = 0; v < nv; ++v) {
    d.p_off[v] = n;
    const u32 start = m.v2p[m.vp_off[v]];
    u32 p = start;
    do {
      d.p2v[n++] = p;
      const u32 i = m.p2v[3 * p] == v ? 0 : m.p2v[3 * p + 1] == v ? 1 : 2;
      p = m.p2p[3 * p + (i + 2) % 3];
    } while (p != start);
  }
  d.p_off[nv] = n;
  floors::build(d);
  return d;
}

void expect_equal(const floors::surface<0>& f, const cn::polygonmesh& m) {
  bool same = f.num_polys() == cn::num_polys(m) && f.num_edges() == cn::num_edges(m) && f.num_verts() == cn::num_verts(m);
  std::vector<u32> left, right;
  for (u32 p = 0; same && p < f.num_polys(); ++p) {
    left.assign(f.p2v.data() + f.first(p), f.p2v.data() + f.last(p));
    right.clear();
    for (const cn::vert_id v : cn::adj_p2v(m, cn::poly_id{p})) right.push_back(v.raw());
    std::rotate(left.begin(), std::min_element(left.begin(), left.end()), left.end());
    std::rotate(right.begin(), std::min_element(right.begin(), right.end()), right.end());
    same = left == right;
  }
  if (!same) throw std::runtime_error("dual.tri1m: the floor's mesh and the library's differ");
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto timed = [](auto work) { return [work] { return bench::seconds_of(work); }; };
    if (p.wants("dual.tri1m")) {
      const auto a = p.data.tri1m();
      const auto f = bench::built<3>(a);
      const cn::trimesh m(a);
      const auto floor = [&] { return dual_of(f); };
      const auto ours = [&] { return cn::dual_mesh(m); };
      expect_equal(floor(), ours());
      p.print(bench::compare("dual.tri1m", p.rounds, {{"floor", timed(floor)}, {"concino", timed(ours)}}));
    }
    if (p.wants("dual.tet200k")) {
      const cn::tetmesh m(p.data.tet200k());
      const auto ours = [&] { return cn::dual_mesh(m); };
      const cn::polyhedra_arrays a = bench::arrays_of(ours());
      p.print(bench::compare("dual.tet200k", p.rounds,
                             {{"concino", timed(ours)}, {"build-alone", timed([&] { return cn::polyhedralmesh(cn::polyhedra_arrays(a)); })}}));
    }
    const auto against_building = [&](const char* name, const auto& mesh, const auto& subdivide) {
      if (!p.wants(name)) return;
      const auto m = mesh();
      using result = decltype(subdivide(m));
      const auto ours = [&] { return subdivide(m); };
      const auto a = bench::arrays_of(ours());
      p.print(bench::compare(name, p.rounds, {{"concino", timed(ours)}, {"build-alone", timed([&] { return result(std::remove_cvref_t<decltype(a)>(a)); })}}));
    };
    const auto triangles = [&] { return cn::trimesh(p.data.tri1m()); };
    against_building("subdivide.1-to-4.tri1m", triangles, [](const auto& m) { return cn::subdivide_1_to_4(m); });
    against_building("subdivide.loop.tri1m", triangles, [](const auto& m) { return cn::subdivide_loop(m); });
    against_building("subdivide.catmull-clark.tri1m", triangles, [](const auto& m) { return cn::subdivide_catmull_clark(m); });
    const auto bunny4 = [&] { return cn::trimesh(bench::split_triangles(p.data.bunny())); };  // to 457,000 triangles
    against_building("subdivide.1-to-4.bunny4", bunny4, [](const auto& m) { return cn::subdivide_1_to_4(m); });
    against_building("subdivide.loop.bunny4", bunny4, [](const auto& m) { return cn::subdivide_loop(m); });
    const auto bunny = [&] { return cn::trimesh(p.data.bunny16()); };
    against_building("quads-from-triangles.bunny16", bunny, [](const auto& m) { return cn::quads_from_triangles(m); });
    against_building("shell.bunny16", bunny, [](const auto& m) {
      std::vector<cn::poly_id> inverted;
      return cn::offset_shell(m, 1e-3, 2, {.inverted = &inverted});
    });
    against_building("voxels.bunny16", bunny, [](const auto& m) { return cn::voxel_hexes(m, 64); });
    const auto hexes = [&] { return cn::polyhedralmesh(p.data.hex216k()); };
    against_building("to-tets.hex216k", hexes, [](const auto& m) { return cn::to_tets(m); });
    const auto tets = [&] { return cn::tetmesh(p.data.tet200k()); };
    against_building("boundary-surface.tet200k", tets, [](const auto& m) { return cn::boundary_surface(m); });
    against_building("subdivide.midpoint.tet200k", tets, [](const auto& m) { return cn::subdivide_midpoint(m); });
  });
}
