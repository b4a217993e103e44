// The mesh families of docs/convergence.md: meshes of every kind of the unit square or cube, with about n cells along each edge.
#pragma once

#include <concino/generate.hpp>

#include <support/kinds.hpp>

#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace concino::testing {

enum class family { regular, perturbed, graded, voronoi, dual, agglomerates };

inline constexpr const char* name_of(family f) {
  constexpr const char* names[] = {"regular", "perturbed", "graded", "Voronoi", "dual", "agglomerates"};
  return names[static_cast<int>(f)];
}

template<class M> inline constexpr const char* kind_name = "";
template<> inline constexpr const char* kind_name<trimesh> = "triangles";
template<> inline constexpr const char* kind_name<quadmesh> = "quads";
template<> inline constexpr const char* kind_name<polygonmesh> = "polygons";
template<> inline constexpr const char* kind_name<tetmesh> = "tets";
template<> inline constexpr const char* kind_name<hexmesh> = "hexes";
template<> inline constexpr const char* kind_name<polyhedralmesh> = "polyhedra";

/// The families of a kind of mesh.
template<class M>
std::vector<family> families() {
  std::vector<family> r{family::regular, family::perturbed, family::graded};
  if constexpr (std::is_same_v<M, polygonmesh> || std::is_same_v<M, polyhedralmesh>) r.insert(r.end(), {family::voronoi, family::dual, family::agglomerates});
  return r;
}

/// The sizes of the meshes, in cells along each edge.
template<class M>
constexpr std::array<unsigned, 4> levels() {
  if constexpr (dimension_v<M> == 2) return {8, 16, 32, 64};
  else return {4, 8, 16, 32};
}

/// The mesh of family f with n cells along each edge. Voronoi cells and agglomerates are as many as the cells of such a grid.
template<class M>
M make_family(family f, std::size_t n) {
  constexpr bool is_surface = dimension_v<M> == 2;
  const auto simplices = [](std::size_t k) {  // no two of them are congruent
    using simplex = std::conditional_t<is_surface, trimesh, tetmesh>;
    auto m = make_grid<simplex>({.cells = {k, k, k}});
    jitter(m, is_surface ? 0.2 : 0.1);
    return m;
  };
  if constexpr (std::is_same_v<M, polygonmesh> || std::is_same_v<M, polyhedralmesh>) {
    if (f == family::voronoi) {
      const box domain{{0, 0, 0}, {1, 1, is_surface ? 0 : 1}};
      const auto sites = random_points(is_surface ? n * n : n * n * n, domain, n);
      if constexpr (is_surface) return voronoi_polygons(sites, domain);
      else return voronoi_polyhedra(sites, domain);
    }
    if (f == family::dual) return dual_mesh(simplices(n));
    if (f == family::agglomerates) {
      const auto fine = simplices(is_surface ? 2 * n : n);
      return agglomerate(fine, random_labels(fine, is_surface ? 8 : 6));
    }
  }
  auto m = make_grid<M>({.cells = {n, n, n}});
  if (f == family::perturbed) jitter(m, is_surface ? 0.2 : std::is_same_v<M, tetmesh> ? 0.1 : 0.15);
  if (f == family::graded) grade(m, {2, 1, 1});
  return m;
}

}  // namespace concino::testing
