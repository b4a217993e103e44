// Compares maps of disks to the plane and their distortion.
#pragma once

#include <agreement/matched.hpp>

#include <concino/parametrize.hpp>

namespace concino::agreement {

struct uv_maps {
  static constexpr const char* name = "uv maps";
  template<class M> static constexpr bool runs_on = SurfaceMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    const auto& n = both.native;
    const auto& m = both.other;
    if (in.closed || !in.manifold || !in.in_one_piece) return both.polys.all.size() > 0 && check_projection(both);
    const auto same = [&](const auto& here, const auto& there, const char* what) {
      double size = 0;
      for (const auto v : both.verts.all) size = std::max({size, std::abs(here[v][0]), std::abs(here[v][1])});
      for (const auto v : both.verts.all)
        for (std::size_t k = 0; k < 2; ++k) expect_close(here[v][k], there[both.verts.to(v)][k], 1e4 * size, what);
    };
    const auto circle = tutte(n);
    const auto circle_there = tutte(m);
    same(circle.uv, circle_there.uv, "tutte");
    expect(circle.attached.size() == circle_there.attached.size(), "the attached pieces");
    const auto conformal = lscm(n);
    const auto conformal_there = lscm(m);
    same(conformal, conformal_there, "lscm");
    same(spectral_conformal(n), spectral_conformal(m), "spectral_conformal");
    same(arap_map(n, {.max_iterations = 3}).uv, arap_map(m, {.max_iterations = 3}).uv, "arap_map");
    if (map_distortion(n, conformal).flipped == 0)
      same(injective_map(n, conformal, {.max_iterations = 3}).uv, injective_map(m, conformal_there, {.max_iterations = 3}).uv, "injective_map");
    const auto d = map_distortion(n, conformal);
    const auto e = map_distortion(m, conformal_there);
    expect(d.flipped == e.flipped, "as many flips");
    for (const auto p : both.polys.all) {
      expect_close(d.angle[p], e.angle[both.polys.to(p)], 1e4, "the change of angles");
      expect_close(d.area[p], e.area[both.polys.to(p)], 1e4, "the change of areas");
    }
    return true;
  }

 private:
  // Of surfaces that are no disks: the distortion of the map that leaves out z.
  template<class B>
  static bool check_projection(const B& both) {
    const auto& n = both.native;
    const auto& m = both.other;
    auto here = make_vert_map<uv_point>(n);
    auto there = make_vert_map<uv_point>(m);
    for (const auto v : both.verts.all) {
      here[v] = {to_vec3(point(n, v)).x, to_vec3(point(n, v)).y};
      there[both.verts.to(v)] = here[v];
    }
    const auto d = map_distortion(n, here);
    const auto e = map_distortion(m, there);
    expect_close(d.scale, e.scale, 1e4, "the scale");
    for (const auto p : both.polys.all) expect_close(d.area[p], e.area[both.polys.to(p)], 1e4, "the change of areas");
    return true;
  }
};

}  // namespace concino::agreement
