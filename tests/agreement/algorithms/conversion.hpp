// Compares convert to the native kind that can hold any poly, with correspondence and values.
#pragma once

#include <agreement/matched.hpp>

#include <concino/convert.hpp>

namespace concino::agreement {

struct conversions {
  static constexpr const char* name = "convert";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    using to = std::conditional_t<dimension_v<M> == 2, polygonmesh, polyhedralmesh>;
    const auto& m = both.other;
    const auto c = convert_with_correspondence<to>(m);
    expect(num_verts(c.mesh) == num_verts(both.native) && num_edges(c.mesh) == num_edges(both.native) && num_polys(c.mesh) == num_polys(both.native), "as many elements");
    auto given = make_poly_map<int>(m, -1);
    auto taken = make_poly_map<int>(c.mesh, -1);
    for (const auto p : both.polys.all) {
      const auto& q = both.polys.to(p);
      given[q] = static_cast<int>(p.raw());
      numbers expected, found;
      for (const auto v : adj_p2v(both.native, p)) expected.push_back(c.vert_of(both.verts.to(v)).raw());
      for (const auto v : adj_p2v(c.mesh, c.poly_of(q))) found.push_back(v.raw());
      expect(sorted(expected) == sorted(found), "a poly of the same verts");
    }
    c.transfer(given, taken);
    for (const auto p : both.polys.all) expect(taken[c.poly_of(both.polys.to(p))] == static_cast<int>(p.raw()), "values come along");
    for (const auto v : both.verts.all) expect(to_vec3(point(c.mesh, c.vert_of(both.verts.to(v)))) == to_vec3(point(both.native, v)), "points are where they were");
    return true;
  }
};

}  // namespace concino::agreement
