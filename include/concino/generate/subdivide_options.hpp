// The options of all subdivisions, and the edges that smooth subdivisions keep sharp.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/element_origins.hpp>

#include <concepts>

namespace concino {

struct subdivide_options {
  unsigned times = 1;                                 // how often the mesh is subdivided, 1 or more
  bool properties = true;                             // whether named properties are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the elements of m of which those of
                                                      // the result were made
};

namespace requirement {

/// creases[e] says whether the surface has a crease along edge e.
template<class C, class M>
concept is_crease_map = ReadableMap<C, edge_t<M>> && requires(const C& creases, const edge_t<M>& e) {
  { creases[e] } -> std::convertible_to<bool>;
};

}  // namespace requirement

}  // namespace concino
