// Models: meshes as users write them, user_mesh::surface and user_mesh::volume of support/user_mesh.hpp, which search all elements for adjacencies.
#pragma once

#include <agreement/run.hpp>

#include <support/user_mesh.hpp>

namespace concino::agreement {

template<class K>
struct own_surface {
  using kind = K;
  static constexpr const char* column = "your mesh";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = false;

  template<class F>
  static void with(const input<surface_arrays>& in, F&& f) {
    const K m(in.arrays);
    std::vector<std::array<double, 3>> x;
    std::vector<user_mesh::polygon> rings;
    for (const auto v : verts(m)) x.push_back({point(m, v)[0], point(m, v)[1], point(m, v)[2]});
    for (const auto p : polys(m)) {
      rings.emplace_back();
      for (const auto v : adj_p2v(m, p)) rings.back().push_back(static_cast<int>(v.raw()));
    }
    f(user_mesh::surface(x, rings));
  }
};

template<class K>
struct own_volume {
  using kind = K;
  static constexpr const char* column = "your mesh";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = false;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    const K m(in.arrays);
    std::vector<std::array<double, 3>> x;
    std::vector<user_mesh::polygon> rings;
    std::vector<std::vector<std::pair<int, bool>>> cells;
    for (const auto v : verts(m)) x.push_back({point(m, v)[0], point(m, v)[1], point(m, v)[2]});
    for (const auto q : faces(m)) {
      rings.emplace_back();
      for (const auto v : adj_f2v(m, q)) rings.back().push_back(static_cast<int>(v.raw()));
    }
    for (const auto p : polys(m)) {
      cells.emplace_back();
      for (const auto q : adj_p2f(m, p)) cells.back().emplace_back(static_cast<int>(q.raw()), face_is_outward(m, p, q));
    }
    f(user_mesh::volume(x, rings, cells));
  }
};

using own_meshes = models<own_surface<trimesh>, own_volume<polyhedralmesh>>;

}  // namespace concino::agreement
