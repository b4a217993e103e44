// The polys of two meshes that share verts, in the arrays of one mesh.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/support/face_merger.hpp>
#include <concino/mesh/support/native_mesh_of.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace concino::detail {

template<class A, class B>
using united_mesh =
    typename core::native_mesh_of<dimension_v<A>, arity_v<A> == arity_v<B> ? static_cast<int>(arity_v<A>) : 0>::type;

/// The points of a mesh, and by index of a vert its position in the order of verts(m).
template<class M>
std::vector<std::uint32_t> read_points(const M& m, std::vector<vec3>& points) {
  std::vector<std::uint32_t> position(vert_index_bound(m), ~0u);
  points.reserve(num_verts(m));
  for (const vert_t<M> v : verts(m)) {
    position[index_of(m, v)] = static_cast<std::uint32_t>(points.size());
    points.push_back(to_vec3(point(m, v)));
  }
  return position;
}

/// Errors: invalid_argument that names a poly of m of which two verts became one; number: the new number of each vert,
///         by index.
template<class M>
void check_verts_differ(const M& m, const std::vector<std::uint32_t>& number, std::size_t num_verts) {
  std::vector<std::uint32_t> last_poly(num_verts, ~0u);
  std::uint32_t count = 0;
  for (const poly_t<M> p : polys(m)) {
    for (const vert_t<M> v : adj_p2v(m, p)) {
      std::uint32_t& last = last_poly[number[index_of(m, v)]];
      if (last == count)
        core::throw_joined<invalid_argument>({"unite: two verts of poly ", index_of(m, p),
                                              " of the second mesh, among them vert ", index_of(m, v),
                                              ", would become one vert of the first; choose a smaller tolerance"});
      last = count;
    }
    ++count;
  }
}

/// Appends the polys of m, whose verts have new numbers, by index.
template<class M, class Arrays>
void append_polys(const M& m, const std::vector<std::uint32_t>& number, Arrays& a) {
  for (const poly_t<M> p : polys(m)) {
    for (const vert_t<M> v : adj_p2v(m, p)) a.verts.push_back(vert_id{number[index_of(m, v)]});
    if constexpr (std::is_same_v<Arrays, surface_arrays>)  // only surfaces have polys of several sizes in such lists
      if (a.arity == 0) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
}
template<class M>
void append_polyhedra(const M& m, const std::vector<std::uint32_t>& number, face_merger& merger, polyhedra_arrays& a) {
  std::vector<face_merger::merged_face> merged(face_index_bound(m));
  std::vector<vert_id> corners;
  for (const face_t<M> f : faces(m)) {
    corners.clear();
    for (const vert_t<M> v : adj_f2v(m, f)) corners.push_back(vert_id{number[index_of(m, v)]});
    merged[index_of(m, f)] = merger.add(corners.data(), corners.size());
  }
  for (const poly_t<M> p : polys(m)) {
    for (const face_t<M> f : adj_p2f(m, p)) {
      const face_merger::merged_face at = merged[index_of(m, f)];
      a.poly_faces.push_back(at.face);
      a.outward.push_back(face_is_outward(m, p, f) == (at.order > 0));
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
}

/// The polys of both meshes, without points.
template<class A, class B>
auto united_arrays(const A& a, const std::vector<std::uint32_t>& number_a, const B& b,
                   const std::vector<std::uint32_t>& number_b, std::size_t num_verts) {
  using to = united_mesh<A, B>;
  if constexpr (std::is_same_v<to, polyhedralmesh>) {  // other meshes are lists of verts of polys
    face_merger merger(num_verts);
    polyhedra_arrays arrays;
    arrays.poly_offsets.push_back(0);
    append_polyhedra(a, number_a, merger, arrays);
    append_polyhedra(b, number_b, merger, arrays);
    merger.finish(arrays);
    return arrays;
  } else {
    std::conditional_t<dimension_v<to> == 2, surface_arrays, cell_arrays> arrays;
    arrays.arity = static_cast<std::uint32_t>(arity_v<to>);
    arrays.verts.reserve((num_polys(a) + num_polys(b)) * (arrays.arity ? arrays.arity : 4));
    if constexpr (std::is_same_v<to, polygonmesh>) arrays.offsets.push_back(0);  // the others have polys of one size
    append_polys(a, number_a, arrays);
    append_polys(b, number_b, arrays);
    return arrays;
  }
}

/// The origins in m of the elements of the united mesh; its verts have new numbers, by index, and its polys are
/// numbered from first_poly on.
template<class M, class To>
correspondence origins_in(const M& m, const std::vector<std::uint32_t>& number, std::size_t first_poly,
                          const To& united) {
  std::vector<std::uint32_t> of_verts(vert_index_bound(united), element_origins::none),
      of_polys(poly_index_bound(united), element_origins::none);
  for (const vert_t<M> v : verts(m)) {
    std::uint32_t& origin = of_verts[number[index_of(m, v)]];
    if (origin == element_origins::none) origin = static_cast<std::uint32_t>(index_of(m, v));
  }
  for (const poly_t<M> p : polys(m)) of_polys[first_poly++] = static_cast<std::uint32_t>(index_of(m, p));
  correspondence c;
  c.verts = element_origins(std::move(of_verts)), c.polys = element_origins(std::move(of_polys));
  match_edges_and_faces(m, united, c);
  if constexpr (NumbersCorners<M> && NumbersCorners<To>) c.corners = match_corners(m, united, c.verts, c.polys);
  return c;
}

}  // namespace concino::detail
