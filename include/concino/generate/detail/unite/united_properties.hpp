// The properties of a mesh that was made of two.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/property_set.hpp>

namespace concino::detail {

/// Transfers the properties of the second mesh. Where `to` has one of that name, values of elements that have origins
/// in the first mesh remain.
/// Errors: invalid_argument if properties of the same name have values of different types.
void add_united_properties(const property_set& second, const correspondence& from_first,
                           const correspondence& from_second, property_set& to);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/unite/united_properties.ipp>
#endif
