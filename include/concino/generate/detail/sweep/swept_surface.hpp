// The verts and polys of a surface that moves, as flat arrays, and the volume between its layers.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/message.hpp>
#include <concino/core/parallel.hpp>
#include <concino/generate/detail/common/num_poly_corners.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// The volume that a surface makes when it moves: hexes of quads, else polyhedra.
template<class M> using swept_mesh = std::conditional_t<arity_v<M> == 4, hexmesh, polyhedralmesh>;

/// A surface that moves. Verts, edges and polys are numbered in the order of the mesh; edges in the order of the polys
/// at them.
struct swept_surface {
  struct ends {
    std::uint32_t from, to;
    friend bool operator==(const ends&, const ends&) = default;
  };
  std::vector<vec3> points;
  std::vector<std::uint32_t> vert_index, poly_index;  // index_of in the mesh, by number
  std::vector<std::uint32_t> offsets{0}, verts;  // polys are counter-clockwise seen from where they move to
  std::vector<std::uint32_t> edges;              // parallel to verts: twice the edge to the next vert, plus 1 if it
                                                 // runs the other way
  std::vector<ends> edge_ends;

  std::size_t num_polys() const { return poly_index.size(); }
};

/// How the layers of verts are numbered: all verts of the first layer, then those that move in each other layer. If the
/// layers are closed, the last layer is the first.
struct sweep_layers {
  std::size_t num_verts, num_layers;  // of the surface; of cells
  bool closed = false;
  std::vector<std::uint32_t> moving = {};  // by number of a vert: its number among those that move, ~0u if it stays in
                                           // its place; empty if all move
  std::size_t num_moving = num_verts;

  std::size_t num_levels() const { return closed ? num_layers : num_layers + 1; }
  std::size_t size() const { return num_verts + (num_levels() - 1) * num_moving; }
  bool moves(std::uint32_t v) const { return moving.empty() || moving[v] != ~0u; }
  vert_id number(std::size_t level, std::uint32_t v) const {
    if (level == 0 || (closed && level == num_layers) || !moves(v)) return vert_id{v};
    return vert_id{num_verts + (level - 1) * num_moving + (moving.empty() ? v : moving[v])};
  }
};

/// The points of a mesh and the numbers of its verts.
/// Errors: invalid_mesh that names a vert whose point is not finite.
template<class M>
std::vector<std::uint32_t> read_swept_verts(const char* caller, const M& m, swept_surface& s) {
  std::vector<std::uint32_t> number(vert_index_bound(m));
  s.points.reserve(num_verts(m)), s.vert_index.reserve(num_verts(m));
  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    const vec3 x = to_vec3(point(m, v));
    if (!is_finite(x)) core::throw_joined<invalid_mesh>({caller, ": the point of vert ", i, " is not finite"});
    number[i] = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back(x), s.vert_index.push_back(static_cast<std::uint32_t>(i));
  }
  return number;
}

/// Pairs the polys at each edge.
class sweep_edges {
  struct user {
    std::uint32_t number = ~0u, poly = 0;
    bool reversed = false, is_full = false;
  };
  std::vector<user> users_;  // by edge index

 public:
  explicit sweep_edges(std::size_t bound) : users_(bound) {}
  /// The entry of swept_surface::edges for an edge of the poly with index `poly`, which was reversed or not.
  /// Errors: invalid_mesh or invalid_argument that names the polys at an edge if they do not run along it in opposite
  ///         directions.
  std::uint32_t add(const char* caller, swept_surface& s, std::size_t edge, const swept_surface::ends& ends,
                    std::size_t poly, bool reversed);
};

/// Reads the polys. is_reversed(p) says whether p is clockwise seen from where it moves to.
template<class M, class IsReversed>
swept_surface read_swept_surface(const char* caller, const M& m, const IsReversed& is_reversed) {
  swept_surface s;
  const std::vector<std::uint32_t> number = read_swept_verts(caller, m, s);
  sweep_edges at_edges(edge_index_bound(m));
  s.poly_index.reserve(num_polys(m)), s.offsets.reserve(num_polys(m) + 1);
  std::vector<std::size_t> edges_of_poly;
  for (const poly_t<M> p : polys(m)) {
    const bool reversed = is_reversed(p);
    const std::size_t first = s.verts.size(), index = index_of(m, p);
    edges_of_poly.clear();
    for (const auto& [e, from, to] : oriented_edges(m, p)) {
      s.verts.push_back(number[index_of(m, from)]);
      edges_of_poly.push_back(index_of(m, e));
    }
    if (reversed && !edges_of_poly.empty()) {
      std::reverse(s.verts.begin() + static_cast<std::ptrdiff_t>(first) + 1, s.verts.end());
      std::reverse(edges_of_poly.begin(), edges_of_poly.end());
    }
    const std::size_t n = edges_of_poly.size();
    for (std::size_t k = 0; k < n; ++k)
      s.edges.push_back(at_edges.add(caller, s, edges_of_poly[k],
                                     {s.verts[first + k], s.verts[first + (k + 1 == n ? 0 : k + 1)]}, index, reversed));
    s.poly_index.push_back(static_cast<std::uint32_t>(index));
    s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
  }
  return s;
}

/// Errors: invalid_argument that names the option `option` if a volume of so many layers, of a surface of so many
///         elements, has too many elements.
void check_sweep_counts(const char* caller, const char* option, std::size_t num_layers, std::size_t num_verts,
                        std::size_t num_polys, std::size_t num_corners);

/// The cells between the layers, without points. Cells of the first layer come first, in the order of the polys.
cell_arrays swept_hexes(const swept_surface& s, const sweep_layers& layers);
polyhedra_arrays swept_polyhedra(const swept_surface& s, const sweep_layers& layers);

/// The origins of the verts and polys of the volume.
correspondence swept_origins(const swept_surface& s, const sweep_layers& layers);

/// Constructs the volume. at(level, v): the point of vert number v in a layer of verts. Layers of cells go from level k
/// to k + 1.
template<class M, class At>
swept_mesh<M> construct_swept(const M& m, const swept_surface& s, const sweep_layers& layers, const At& at,
                              bool properties, correspondence* c) {
  std::vector<vec3> points(layers.size());
  parallel_for(s.points.size(), [&](std::size_t v) {
    const auto n = static_cast<std::uint32_t>(v);
    points[v] = at(std::size_t{0}, n);
    if (layers.moves(n))
      for (std::size_t level = 1; level < layers.num_levels(); ++level)
        points[layers.number(level, n).raw()] = at(level, n);
  });
  swept_mesh<M> result = [&] {
    auto a = [&] {
      if constexpr (arity_v<M> == 4) return swept_hexes(s, layers);  // the polys are quads
      else return swept_polyhedra(s, layers);
    }();
    a.points = std::move(points);
    return swept_mesh<M>(std::move(a));
  }();
  correspondence from;
  if constexpr (ShowsProperties<M>) {
    if (properties && traits<M>::properties(m).size() > 0) {
      from = swept_origins(s, layers);
      traits<swept_mesh<M>>::properties(result).transfer_verts_and_polys(traits<M>::properties(m), from);
    }
  }
  if (c) *c = from.verts.size() > 0 ? std::move(from) : swept_origins(s, layers);
  return result;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/sweep/swept_surface.ipp>
#endif
