// The volume of one poly of polyhedra_arrays.
#pragma once

#include <concino/io/detail/cells/oriented_faces.hpp>

namespace concino::testing {

inline double six_times_poly_volume(polyhedra_arrays m, std::size_t p) { return concino::detail::six_times_poly_volume(concino::detail::face_lister<vert_id>()(m, p), m.points); }

}  // namespace concino::testing
