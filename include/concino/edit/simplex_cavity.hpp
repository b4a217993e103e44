// simplex_cavity: an edit of triangles or tets that is put together poly by poly, for operators of your own.
//
//   cn::simplex_cavity<M> c(m);
//   c.add_old(p);                                    // the polys that go; false: p is no simplex
//   c.add_point(x, {a, a, 0});                       // a new vert, with the values of vert a; a = c.vert(v) is the
//   number of v for (unsigned i = 0; i < c.size; ++i) c.add_new(0, c.corners(0)[i], c.added);  // old poly 0, with the
//   new vert instead of one corner c.keep(1);                                       // the first new poly has the
//   descriptor of the first old one c.apply(m);                                      // named properties follow, and an
//   open transaction can undo it
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>

namespace concino {

/// Needs:  EditableMesh M. Old and new polys cover the same region: their facets that have no second poly among them
///         are the same.
/// Result: apply(m) replaces the old polys by the new ones with one `rewire`. See the members.
/// Cost:   that of rewire, and of the properties of m; no allocation while there are few polys.
/// Errors: of apply: those of rewire; m is unchanged then, also if memory runs out.
template<EditableMesh M>
using simplex_cavity = detail::cavity_builder<M>;

}  // namespace concino
