// The input of `rewire` by local numbers: the verts of a cavity are 0, 1, 2, ... in the order in which the cavity lists
// them, new ones after the existing ones.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/error.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/message.hpp>
#include <concino/core/small_array.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/detail/rows/alive_elements.hpp>

#include <algorithm>
#include <cstdint>

namespace concino::detail {

using native_cavity = cavity_of<vert_id, poly_id>;
using native_cavity_result = cavity_result_of<vert_id, poly_id>;

/// The verts of a cavity by local numbers.
class cavity_verts {
  id_span<vert_id> verts_;
  core::local_numbers numbers_;
  vert_id repeated_;

 public:
  static constexpr unsigned none = core::local_numbers::none;

  explicit cavity_verts(id_span<vert_id> verts) : verts_(verts) {
    for (const vert_id v : verts)
      if (const unsigned next = numbers_.size(); numbers_.add(v.raw()) != next && repeated_.is_none()) repeated_ = v;
  }

  vert_id operator[](unsigned local) const { return verts_[local]; }
  unsigned size() const { return static_cast<unsigned>(verts_.size()); }

  /// The local number of a vert, or `none`.
  unsigned local(vert_id v) const { return numbers_.find(v.raw()); }

  /// A vert that is listed twice, or a vert id of none.
  vert_id repeated() const { return repeated_; }
};

/// Checks the lists of a cavity: elements exist and are listed once, the new polys have the right number of different
/// verts.
/// Errors: invalid_mesh.
void check_cavity(const native_cavity& c, const cavity_verts& local, const alive_elements<vert_id>& verts,
                  const alive_elements<poly_id>& polys, unsigned arity);

/// The same for a mesh of general polyhedra.
void check_cavity_of_polyhedra(const native_cavity& c, const cavity_verts& local, const alive_elements<vert_id>& verts,
                               const alive_elements<poly_id>& polys);

/// invalid_mesh for a new poly with two faces on the same verts; `face` is the second.
[[noreturn]] void repeated_cavity_face(std::size_t poly, std::size_t face);

/// invalid_mesh for a cavity whose list of verts lacks a vert of old poly p.
[[noreturn]] void missing_cavity_vert(poly_id p, vert_id v);

/// invalid_mesh for a vert that is to be removed but keeps a poly.
[[noreturn]] void removed_vert_in_use(vert_id v);

/// invalid_mesh for a vert that is to be removed but has a face without polys.
[[noreturn]] void removed_vert_with_face(vert_id v);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/edits/cavity_input.ipp>
#endif
