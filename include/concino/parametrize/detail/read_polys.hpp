// Reads the polys of a surface of any type into flat arrays, and checks whether they are a disk.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/parametrize/detail/flat_polys.hpp>
#include <concino/parametrize/uv_map.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// What a surface must be for maps to the plane.
template<class M>
concept can_be_mapped = requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>;

/// u[x] is a point of the plane.
template<class U, class X> concept gives_uv = requires(const std::remove_cvref_t<U>& u, const X& x) {
  { u[x][0] } -> std::convertible_to<double>;
  { u[x][1] } -> std::convertible_to<double>;
};

/// Flat arrays and the verts of the mesh by their numbers there. Verts of no poly have none.
template<class M, class Flat>
struct polys_of_mesh {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Flat flat;
  std::vector<vert_t<M>> verts;
  std::vector<std::uint32_t> number;  // by index of the vert

  explicit polys_of_mesh(const M& m) : number(vert_index_bound(m), none) {
    for (const vert_t<M> v : concino::verts(m)) number[index_of(m, v)] = none - 1;
    flat.first.reserve(num_polys(m) + 1);
    for (const poly_t<M> p : polys(m)) {
      for (const vert_t<M> v : adj_p2v(m, p)) {
        std::uint32_t& n = number[index_of(m, v)];
        if (n >= none - 1) {
          n = static_cast<std::uint32_t>(verts.size());
          verts.push_back(v);
          flat.points.push_back(to_vec3(point(m, v)));
          flat.vert_index.push_back(static_cast<std::uint32_t>(index_of(m, v)));
        }
        flat.corners.push_back(n);
      }
      flat.first.push_back(static_cast<std::uint32_t>(flat.corners.size()));
      flat.poly_index.push_back(static_cast<std::uint32_t>(index_of(m, p)));
    }
  }

  /// The number of a vert.      Errors: invalid_mesh if it is no vert of a poly.
  std::uint32_t number_of(const M& m, const vert_t<M>& v, const char* caller) const {
    const bool is_known = contains(m, v) && index_of(m, v) < number.size() && number[index_of(m, v)] < none - 1;
    if (!is_known)
      core::throw_joined<invalid_mesh>({caller, ": a position is given at what is no vert of a poly of the mesh"});
    return number[index_of(m, v)];
  }

  /// Positions that are given at verts, each of them once, by number.
  /// Errors: invalid_argument if one is not finite, or a vert has two; those of number_of.
  template<class D>
  std::vector<std::pair<std::uint32_t, uv_point>> positions(const M& m, const D& pairs, const char* caller) const {
    std::vector<std::pair<std::uint32_t, uv_point>> result;
    std::vector<unsigned char> is_known(verts.size());
    for (const auto& [vert, x] : pairs) {
      const std::uint32_t n = number_of(m, vert, caller);
      check_position({x[0], x[1]}, is_known[n], flat.vert_index[n], caller);
      is_known[n] = 1;
      result.push_back({n, {static_cast<double>(x[0]), static_cast<double>(x[1])}});
    }
    return result;
  }

  /// The map of these positions; verts of no poly are at the origin.
  uv_map<M> map_of(const M& m, const std::vector<uv_point>& positions) const {
    auto uv = make_vert_map<uv_point>(m, uv_point{0, 0});
    for (std::size_t n = 0; n < verts.size(); ++n) uv[verts[n]] = positions[n];
    return uv;
  }

 private:
  static void check_position(const uv_point& x, bool is_known, std::uint32_t v, const char* caller) {
    if (is_known)
      core::throw_joined<invalid_argument>({caller, ": vert ", v, " is given two positions"});
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]))
      core::throw_joined<invalid_argument>({caller, ": the position of vert ", v, " is not finite"});
  }
};

/// A disk in a mesh.      Errors: as make_disk.
template<class M>
polys_of_mesh<M, flat_disk> read_disk(const M& m, const char* caller) {
  polys_of_mesh<M, flat_disk> disk(m);
  make_disk(disk.flat, caller);
  return disk;
}

/// Pairs of a vert and a point of the plane, in braces or a container.
template<class D, class M>
concept gives_positions = requires(const D& d) {
  requires std::convertible_to<decltype((*d.begin()).first), vert_t<M>>;
  requires std::convertible_to<decltype((*d.begin()).second[0]), double>;
  (*d.begin()).second[1];
};

}  // namespace concino::detail
