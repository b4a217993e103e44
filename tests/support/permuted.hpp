// The same mesh stored in another order: elements, faces and their orientation, and the first corner of each poly are permuted at random. A class that
// compares what functions say about both.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/generate.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::testing {

/// A mesh and where the elements of the original are in it.
template<class M>
struct permuted {
  M mesh;
  std::vector<vert_id> verts;
  std::vector<poly_id> polys;
};

inline std::vector<std::uint32_t> random_order(std::size_t n, std::mt19937& random) {
  std::vector<std::uint32_t> r(n);
  std::iota(r.begin(), r.end(), 0u);
  std::shuffle(r.begin(), r.end(), random);
  return r;
}

/// The 12 even permutations of the corners of a tet, or the 24 rotations of a hex.
template<std::size_t N>
std::vector<std::array<std::size_t, N>> rotations(const std::vector<std::array<std::size_t, N>>& generators) {
  std::array<std::size_t, N> identity;
  std::iota(identity.begin(), identity.end(), std::size_t{0});
  std::vector<std::array<std::size_t, N>> all{identity};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const auto& g : generators) {
      std::array<std::size_t, N> next{};
      for (std::size_t k = 0; k < N; ++k) next[k] = all[i][g[k]];
      if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
    }
  return all;
}
inline const std::vector<std::array<std::size_t, 4>>& tet_rotations() {
  static const auto all = rotations<4>({{1, 2, 0, 3}, {1, 0, 3, 2}});
  return all;
}
inline const std::vector<std::array<std::size_t, 8>>& hex_rotations() {
  static const auto all = rotations<8>({{1, 2, 3, 0, 5, 6, 7, 4}, {3, 2, 6, 7, 0, 1, 5, 4}});
  return all;
}

/// Stores m, which has no deleted elements, in another order.
template<class M>
permuted<M> permute(const M& m, unsigned seed) {
  std::mt19937 random(seed);
  const auto vert_at = random_order(num_verts(m), random), poly_at = random_order(num_polys(m), random);
  std::vector<vec3> points(num_verts(m));
  for (const vert_id v : verts(m)) points[vert_at[v.raw()]] = point(m, v);
  std::vector<poly_id> stored(num_polys(m));
  for (const poly_id p : polys(m)) stored[poly_at[p.raw()]] = p;
  const auto turned = [&](const auto& loop) {
    std::vector<vert_id> r;
    for (const vert_id v : loop) r.push_back(vert_id{vert_at[v.raw()]});
    std::rotate(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(random() % r.size()), r.end());
    return r;
  };
  const auto mesh = [&] {
    if constexpr (SurfaceMesh<M>) {
      surface_arrays a{points, {}, {}, 0};
      if constexpr (TriMesh<M>) a.arity = 3;
      else if constexpr (QuadMesh<M>) a.arity = 4;
      else a.offsets.push_back(0);
      for (const poly_id p : stored) {
        const auto r = turned(adj_p2v(m, p));
        a.verts.insert(a.verts.end(), r.begin(), r.end());
        if (a.arity == 0) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
      }
      return M(std::move(a));
    } else if constexpr (TetMesh<M> || HexMesh<M>) {
      cell_arrays a{points, {}, TetMesh<M> ? 4u : 8u};
      for (const poly_id p : stored) {
        std::vector<vert_id> r;
        for (const vert_id v : adj_p2v(m, p)) r.push_back(vert_id{vert_at[v.raw()]});
        const auto add = [&](const auto& all) {
          for (const std::size_t k : all[random() % all.size()]) a.verts.push_back(r[k]);
        };
        if constexpr (TetMesh<M>) add(tet_rotations());
        else add(hex_rotations());
      }
      return M(std::move(a));
    } else {
      const auto face_at = random_order(num_faces(m), random);
      std::vector<face_id> stored_faces(num_faces(m));
      for (const face_id f : faces(m)) stored_faces[face_at[f.raw()]] = f;
      polyhedra_arrays a;
      a.points = points;
      a.face_offsets.push_back(0);
      a.poly_offsets.push_back(0);
      std::vector<std::uint8_t> flipped(num_faces(m));
      for (const face_id f : stored_faces) {
        auto r = turned(adj_f2v(m, f));
        if (random() % 2) {
          std::reverse(r.begin(), r.end());
          flipped[f.raw()] = 1;
        }
        a.face_verts.insert(a.face_verts.end(), r.begin(), r.end());
        a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
      }
      for (const poly_id p : stored) {
        std::vector<face_id> around;
        for (const face_id f : adj_p2f(m, p)) around.push_back(f);
        std::shuffle(around.begin(), around.end(), random);
        for (const face_id f : around) {
          a.poly_faces.push_back(face_id{face_at[f.raw()]});
          a.outward.push_back(face_is_outward(m, p, f) != (flipped[f.raw()] == 1));
        }
        a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
      }
      return M(std::move(a));
    }
  };
  permuted<M> r{mesh(), {}, {}};
  for (const std::uint32_t i : vert_at) r.verts.push_back(vert_id{i});
  for (const std::uint32_t i : poly_at) r.polys.push_back(poly_id{i});
  return r;
}

/// A mesh as seen by a function: elements are named as in the original.
template<class M>
struct stored_mesh {
  const M& mesh;
  const std::vector<vert_id>& verts;
  const std::vector<poly_id>& polys;

  vert_id operator[](vert_id v) const { return verts[v.raw()]; }
  poly_id operator[](poly_id p) const { return polys[p.raw()]; }

  /// Pseudo-random values between -1 and 1 at the elements of the original.
  static double value(std::size_t i) { return 2 * (static_cast<double>(i * 2654435761u % 65521) / 65521) - 1; }
  vert_map<M, double> vert_values() const {
    auto u = make_vert_map<double>(mesh, 0.0);
    for (std::size_t i = 0; i < verts.size(); ++i) u[verts[i]] = value(i);
    return u;
  }
  poly_map<M, double> poly_values() const {
    auto u = make_poly_map<double>(mesh, 0.0);
    for (std::size_t i = 0; i < polys.size(); ++i) u[polys[i]] = value(i);
    return u;
  }
  poly_map<M, vec3> poly_vectors() const {
    auto u = make_poly_map<vec3>(mesh);
    for (std::size_t i = 0; i < polys.size(); ++i) u[polys[i]] = {value(3 * i), value(3 * i + 1), dimension_v<M> == 3 ? value(3 * i + 2) : 0};
    return u;
  }
  vert_map<M, double> smooth_values() const {
    auto u = make_vert_map<double>(mesh, 0.0);
    for (const vert_id v : concino::verts(mesh)) {
      const vec3 x = point(mesh, v);
      u[v] = std::sin(3 * x.x + 0.1) + std::cos(2 * x.y) * (1 + x.z) + 0.3 * x.x * x.y;
    }
    return u;
  }
};

/// Compares results on a mesh and on permuted copies.
template<class M>
class storage_check {
  const M& m_;
  std::string mesh_name_;
  std::vector<vert_id> own_verts_;
  std::vector<poly_id> own_polys_;
  std::vector<permuted<M>> copies_;

  static void append(double x, std::vector<double>& to) { to.push_back(x); }
  static void append(const vec3& x, std::vector<double>& to) { to.insert(to.end(), {x.x, x.y, x.z}); }
  static void append(const std::vector<double>& x, std::vector<double>& to) { to.insert(to.end(), x.begin(), x.end()); }

 public:
  storage_check(const char* mesh_name, const M& m, unsigned copies = 3) : m_(m), mesh_name_(mesh_name) {
    for (const vert_id v : concino::verts(m)) own_verts_.push_back(v);
    for (const poly_id p : concino::polys(m)) own_polys_.push_back(p);
    for (unsigned i = 1; i <= copies; ++i) copies_.push_back(permute(m, i));
  }

  const std::string& name() const { return mesh_name_; }
  stored_mesh<M> original() const { return {m_, own_verts_, own_polys_}; }

  /// compute(stored_mesh) returns numbers in an order that does not depend on storage. They are compared to 1e-10 of the largest and of scale, the size of
  /// quantities whose differences they are, where these may all be zero.
  void numbers(const std::string& what, const std::function<std::vector<double>(const stored_mesh<M>&)>& compute, double scale = 0) const {
    const std::vector<double> expected = compute(original());
    double largest = scale, error = 0;
    for (const double x : expected)
      if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
    for (const permuted<M>& copy : copies_) {
      const std::vector<double> found = compute({copy.mesh, copy.verts, copy.polys});
      if (found.size() != expected.size()) {
        FAIL_CHECK(mesh_name_ << ": " << what << ": " << found.size() << " numbers instead of " << expected.size());
        return;
      }
      for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i]))) continue;
        const double off = std::abs(found[i] - expected[i]);
        error = std::isfinite(off) ? std::max(error, off) : std::numeric_limits<double>::infinity();
      }
    }
    CHECK_MESSAGE(error <= 1e-10 * largest, mesh_name_ << ": " << what << ": differs by " << error << ", largest " << largest);
  }

  /// compute(stored_mesh) returns one number or vector, or a vector of numbers.
  template<class F>
  void number(const std::string& what, const F& compute, double scale = 0) const {
    numbers(what, [&](const stored_mesh<M>& s) {
      std::vector<double> r;
      append(compute(s), r);
      return r;
    }, scale);
  }
  /// compute(stored_mesh) returns a map of numbers or vectors at verts, or at polys.
  template<class F>
  void at_verts(const std::string& what, const F& compute, double scale = 0) const {
    numbers(what, [&](const stored_mesh<M>& s) {
      const auto map = compute(s);
      std::vector<double> r;
      for (const vert_id v : s.verts) append(map[v], r);
      return r;
    }, scale);
  }
  template<class F>
  void at_polys(const std::string& what, const F& compute, double scale = 0) const {
    numbers(what, [&](const stored_mesh<M>& s) {
      const auto map = compute(s);
      std::vector<double> r;
      for (const poly_id p : s.polys) append(map[p], r);
      return r;
    }, scale);
  }
  /// compute(stored_mesh, edge or face) returns a number or vector at each edge or face.
  template<class F>
  void at_edges(const std::string& what, const F& make, double scale = 0) const {
    numbers(what, [&](const stored_mesh<M>& s) {
      const auto of = make(s);
      return by_verts(s, edges(s.mesh), [&](edge_id e) { return adj_e2v(s.mesh, e); }, of);
    }, scale);
  }
  template<class F>
  void at_faces(const std::string& what, const F& make, double scale = 0) const {
    numbers(what, [&](const stored_mesh<M>& s) {
      const auto of = make(s);
      return by_verts(s, faces(s.mesh), [&](face_id f) { return adj_f2v(s.mesh, f); }, of);
    }, scale);
  }

 private:
  /// Values at elements, ordered by the verts that these have in the original.
  template<class R, class Loop, class F>
  static std::vector<double> by_verts(const stored_mesh<M>& s, const R& elements, const Loop& loop, const F& of) {
    std::vector<std::uint32_t> number(s.verts.size());
    for (std::size_t i = 0; i < s.verts.size(); ++i) number[s.verts[i].raw()] = static_cast<std::uint32_t>(i);
    std::map<std::vector<std::uint32_t>, std::vector<double>> sorted;
    for (const auto x : elements) {
      std::vector<std::uint32_t> key;
      for (const vert_id v : loop(x)) key.push_back(number[v.raw()]);
      std::sort(key.begin(), key.end());
      append(of(x), sorted[key]);
    }
    std::vector<double> r;
    for (const auto& [key, values] : sorted) r.insert(r.end(), values.begin(), values.end());
    return r;
  }
};

/// Small meshes of a kind: plane or with plane faces, and bent ones whose polygons or faces are not planar. use(storage_check).
template<class M, class Use>
void for_each_stored_mesh(const Use& use, std::size_t cells = dimension_v<M> == 2 ? 5 : 3) {
  constexpr bool is_surface = dimension_v<M> == 2;
  const auto regular = make_grid<M>({.cells = {cells, cells, cells}});
  use(storage_check<M>("regular", regular));
  auto bent = regular;
  jitter(bent, 0.15, {.keep_boundary = false, .in_plane = false});
  use(storage_check<M>("bent", bent));
  if constexpr (is_surface) {
    auto plane = regular;
    jitter(plane, 0.15);
    use(storage_check<M>("plane", plane));
  }
  if constexpr (std::is_same_v<M, polygonmesh> || std::is_same_v<M, polyhedralmesh>) {
    const box domain{{0, 0, 0}, {1, 1, is_surface ? 0 : 1}};
    const auto sites = random_points(is_surface ? 20 : 12, domain, 1);
    using simplex = std::conditional_t<is_surface, trimesh, tetmesh>;
    auto fine = make_grid<simplex>({.cells = {cells + is_surface, cells + is_surface, cells - !is_surface}});
    jitter(fine, 0.1, {.keep_boundary = false, .in_plane = false});
    if constexpr (is_surface) use(storage_check<M>("Voronoi", voronoi_polygons(sites, domain)));
    else use(storage_check<M>("Voronoi", voronoi_polyhedra(sites, domain)));
    use(storage_check<M>("dual", dual_mesh(fine)));
    use(storage_check<M>("agglomerates", agglomerate(fine, random_labels(fine, is_surface ? 8 : 6))));
    auto blocks = make_grid<std::conditional_t<is_surface, quadmesh, hexmesh>>({.cells = {4, 4, 2}});
    jitter(blocks, 0.1, {.keep_boundary = false, .in_plane = false});
    use(storage_check<M>("agglomerated blocks", agglomerate(blocks, random_labels(blocks, 4))));
  }
}

}  // namespace concino::testing
