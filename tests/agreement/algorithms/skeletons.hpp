// Compares leaves, joints, bones, tubes and the nearest bones of graphs in space, and the skeletons of closed surfaces of triangles.
#pragma once

#include <agreement/algorithms/sizes.hpp>

#include <concino/skeleton.hpp>

#include <algorithm>

namespace concino::agreement {

struct bones_of {
  static constexpr const char* name = "bones";
  template<class M> static constexpr bool runs_on = EmbeddedGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const auto here = bones(n);
    const auto there = bones(m);
    expect(raw_numbers(leaves(n)) == native_numbers(both.verts, leaves(m)), "the leaves");
    expect(raw_numbers(joints(n)) == native_numbers(both.verts, joints(m)), "the joints");
    // The order of neighbours says in which direction a bone is walked along.
    const auto as_numbers = [](const auto& all, const auto& numbers_of) {
      std::vector<numbers> r;
      for (const auto& b : all) {
        const numbers walk = numbers_of(b.verts);
        r.push_back(std::min(walk, reversed(walk)));
      }
      std::sort(r.begin(), r.end());
      return r;
    };
    expect(as_numbers(here, [](const auto& v) { return raw_numbers(v); }) ==
               as_numbers(there, [&](const auto& v) { return native_numbers(both.verts, v); }),
           "the bones");
    if (both.verts.empty()) return true;
    double length_here = 0, length_there = 0;
    for (const auto& b : here) length_here += length(b);
    for (const auto& b : there) length_there += length(b);
    expect_close(length_here, length_there, length_here, "the length of all bones");
    const quadmesh around = tube(n, {.radius = 0.01}), same = tube(m, {.radius = 0.01});
    expect(num_verts(around) == num_verts(same) && num_polys(around) == num_polys(same), "the tube");
    const auto two_bones = bones(skeleton({{0, 0, 0}, {1, 0.2, 0.1}, {0.3, 1, 0.2}, {2, 1, 0}}, {{vert_id{0}, vert_id{1}}, {vert_id{2}, vert_id{3}}}));
    const auto nearest = nearest_bone(n, two_bones);
    const auto found = nearest_bone(m, two_bones);
    for (const auto v : both.verts.all) expect(nearest[v] == found[both.verts.to(v)], "the nearest bone");
    return true;
  }
};

struct skeletons {
  static constexpr const char* name = "skeleton_of";
  static constexpr bool needs_a_shape = true;
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    if (!in.closed || !in.manifold) return false;
    for (const auto p : both.polys.all) {
      std::size_t corners = 0;
      for ([[maybe_unused]] const auto v : adj_p2v(both.native, p)) ++corners;
      if (corners != 3) return false;
    }
    const auto here = skeleton_of(both.native);
    const auto there = skeleton_of(both.other);
    const auto origins = [](const auto& from, const auto& numbers_of) {
      std::vector<numbers> r;
      for (const auto& some : from) r.push_back(sorted(numbers_of(some)));
      std::sort(r.begin(), r.end());
      return r;
    };
    expect(origins(here.from, [](const auto& v) { return raw_numbers(v); }) ==
               origins(there.from, [&](const auto& v) { return native_numbers(both.verts, v); }),
           "the verts that became the nodes");
    expect(bones(here.skeleton).size() == bones(there.skeleton).size(), "as many bones");
    expect(leaves(here.skeleton).size() == leaves(there.skeleton).size(), "as many leaves");
    double length_here = 0, length_there = 0;
    for (const auto& b : bones(here.skeleton)) length_here += length(b);
    for (const auto& b : bones(there.skeleton)) length_there += length(b);
    expect_close(length_here, length_there, length_here, "the length of the skeleton");
    return true;
  }
};

}  // namespace concino::agreement
