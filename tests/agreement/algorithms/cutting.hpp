// Compares boundary_loops, tree_cotree, homology_generators and cut_along on surfaces.
#pragma once

#include <agreement/copies.hpp>
#include <agreement/matched.hpp>

#include <concino/graph/boundary_loops.hpp>
#include <concino/graph/cut_along.hpp>
#include <concino/graph/homology.hpp>

#include <support/disk.hpp>

#include <set>

namespace concino::agreement {

struct borders {
  static constexpr const char* name = "boundary_loops";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    const auto expected = boundary_loops(both.native);
    const auto found = boundary_loops(both.other);
    expect(expected.count == found.count, "as many borders");
    if (!in.manifold) return true;  // where borders touch, their division into loops depends on the order of the mesh
    std::multiset<numbers> a, b, edges_a, edges_b;
    for (const auto& w : expected.loops) a.insert(rotated(raw_numbers(w.verts))), edges_a.insert(rotated(raw_numbers(w.edges)));
    for (const auto& w : found.loops) {
      expect(w.is_closed(), "borders are closed");
      b.insert(rotated(native_numbers(both.verts, w.verts)));
      edges_b.insert(rotated(native_numbers(both.edges, w.edges)));
    }
    expect(a == b && edges_a == edges_b, "the same borders, walked in the same direction");
    return true;
  }
};

struct generators {
  static constexpr const char* name = "homology";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!in.closed) return false;
    const auto& m = both.other;
    const auto expected = tree_cotree(both.native);
    const auto found = tree_cotree(m);
    expect(expected.tree.size() == found.tree.size() && expected.cotree.size() == found.cotree.size() && expected.rest.size() == found.rest.size(),
           "trees of the same size");
    numbers all;
    for (const auto* part : {&found.tree, &found.cotree, &found.rest})
      for (const auto& e : *part) all.push_back(both.edges.back(e).raw());
    expect(sorted(all) == sorted(raw_numbers(edges(both.native))), "every edge in one of the parts");
    for (const bool from_root : {true, false}) {
      const auto loops = homology_generators(m, {.from_root = from_root});
      numbers a, b;  // the loops depend on the order of neighbours; their lengths do not
      for (const auto& w : homology_generators(both.native, {.from_root = from_root})) a.push_back(static_cast<unsigned>(w.edges.size()));
      for (const auto& w : loops) {
        expect(w.is_closed(), "generators are closed");
        b.push_back(static_cast<unsigned>(w.edges.size()));
      }
      expect(a.size() == b.size() && (!from_root || sorted(a) == sorted(b)), "generators of the same lengths");
      if constexpr (Embedded<std::remove_cvref_t<decltype(m)>>) {
        if (from_root && in.in_one_piece) {
          const auto disk = testing::topology_of(general_copy_of(cut_along(m, loops).surface));
          expect(disk.pieces == 1 && disk.chi == (loops.empty() ? 2 : 1), "cutting along the generators leaves a disk, or a sphere whole");
        }
      }
    }
    return true;
  }

  static polygonmesh general_copy_of(surface_arrays a) {
    if (a.arity > 0)
      for (std::size_t i = 0; i <= a.verts.size(); i += a.arity) a.offsets.push_back(static_cast<std::uint32_t>(i));
    a.arity = 0;
    return polygonmesh(std::move(a));
  }
};

struct cuts {
  static constexpr const char* name = "cut_along";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    std::vector<edge_t<typename B::native_mesh>> cut;
    std::vector<edge_t<M>> cut_there;
    for (const auto e : both.edges.all)
      if (e.raw() % 3 != 1) cut.push_back(e), cut_there.push_back(both.edges.to(e));
    const auto expected = cut_along(both.native, cut);
    const auto found = cut_along(both.other, cut_there);
    expect(expected.surface.points.size() == found.surface.points.size(), "as many verts after the cut");
    expect(raw_numbers(expected.polys) == native_numbers(both.polys, found.polys), "the same polys after the cut");
    numbers originals = native_numbers(both.verts, found.verts);
    expect(sorted(raw_numbers(expected.verts)) == sorted(originals), "copies of the same verts");
    // Copies are numbered in the order in which polys list their verts, so they are identified by their polys.
    std::vector<std::int64_t> twin(originals.size(), -1), back(originals.size(), -1);
    const auto ring = [](const surface_arrays& s, std::size_t p) {
      const std::size_t first = s.arity ? p * s.arity : s.offsets[p], last = s.arity ? first + s.arity : s.offsets[p + 1];
      return raw_numbers(std::vector<vert_id>(s.verts.begin() + std::ptrdiff_t(first), s.verts.begin() + std::ptrdiff_t(last)));
    };
    for (std::size_t p = 0; p < expected.polys.size(); ++p) {
      const numbers a = ring(expected.surface, p);
      numbers b = ring(found.surface, p);
      expect(a.size() == b.size(), "polys of as many verts");
      for (std::size_t turns = 0; turns < b.size() && originals[b[0]] != expected.verts[a[0]].raw(); ++turns) std::rotate(b.begin(), b.begin() + 1, b.end());
      for (std::size_t i = 0; i < a.size(); ++i) {
        expect(originals[b[i]] == expected.verts[a[i]].raw() && (twin[a[i]] < 0 || twin[a[i]] == b[i]) && (back[b[i]] < 0 || back[b[i]] == a[i]),
               "polys hang together in the same way after the cut");
        twin[a[i]] = b[i];
        back[b[i]] = a[i];
      }
    }
    return true;
  }
};

}  // namespace concino::agreement
