// The origins of elements of a mesh that was subdivided twice.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/element_origins.hpp>

namespace concino::detail {

/// The origins, in the first of three meshes, of the elements of the third: `first` are those of the second mesh,
/// `second` those of the third in the second. Weights are multiplied.
correspondence composed_origins(const correspondence& first, const correspondence& second);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/subdivide/composed_origins.ipp>
#endif
