// cavity: a few polys of a mesh, and those that take their place. The verb `rewire` replaces the ones by the others;
// see editable.hpp. Here are the types for given descriptors; cavity<M> in mesh_traits.hpp is that of a mesh.
#pragma once

#include <concino/concepts/ranges.hpp>

namespace concino {

struct vec3;  // <concino/core/vec3.hpp>

/// What `rewire` replaces: a few polys of a mesh, and the polys that take their place. All arrays belong to the caller.
/// In surfaces, tets and hexes `ends[k]` is the number of corners of the new polys 0 .. k. In meshes of general
/// polyhedra corners are those of faces, which run counter-clockwise seen from outside their poly; `ends` are where
/// faces end in `corners`, `poly_ends` where polys end in `ends`.
template<class Vert, class Poly>
struct cavity_of {
  id_span<Poly> polys = {};           // old polys, which are removed
  id_span<Vert> verts = {};           // the existing verts of old and new polys, each once
  id_span<vec3> points = {};          // of new verts, which are numbered after `verts`
  id_span<unsigned> corners = {};     // of the new polys, one after another: numbers of `verts` and then of `points`
  id_span<unsigned> ends = {};
  id_span<unsigned> poly_ends = {};   // of general polyhedra only
  std::size_t kept = 0;               // this many new polys have the descriptors of the first old ones
  std::size_t removed = 0;            // this many verts, the last ones of `verts`, are removed: no poly has them
                                      // afterwards
};

/// Where `rewire` writes the descriptors of new verts and of all new polys, in the order of the cavity.
template<class Vert, class Poly>
struct cavity_result_of {
  Vert* verts = nullptr;
  Poly* polys = nullptr;
};

}  // namespace concino
