// Chords and blocks of meshes of quads of other libraries, as of native ones, and edits of chords.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/layout.hpp>

#include <support/layouts.hpp>
#include <support/sheet_edits.hpp>

#include <doctest/doctest.h>

#include <algorithm>

namespace concino::testing {

/// Calls f(mesh of type M, native mesh) for all meshes of quads that are orientable.
template<class M, class F>
void for_each_foreign_layout(const F& f) {
  for (const auto& one : meshes_with_layouts<quadmesh>()) {
    INFO(one.name);
    if (one.is_orientable) f(convert<M>(one.mesh), one.mesh);
  }
}

/// Checks chords, singularities, separatrices and blocks.
template<class M>
void check_foreign_layouts() {
  for_each_foreign_layout<M>([](const M& m, const quadmesh& native) {
    CHECK(chords(m).size() == chords(native).size());
    const auto l = coarse_layout(m);
    expect_grids(m, l);
    CHECK(l.num_blocks == coarse_layout(native).num_blocks);
    CHECK(singular_verts(m).size() == singular_verts(native).size());
    CHECK(separatrices(m).size() == separatrices(native).size());
    const auto f = *facets(m).begin();
    const auto c = chord_of(m, f);
    CHECK(std::find(c.facets.begin(), c.facets.end(), f) != c.facets.end());
  });
}

/// Collapses and inserts chords at random, and checks the blocks afterwards.
template<class M>
void check_foreign_layer_edits() {
  for_each_foreign_layout<M>([](M m, const quadmesh&) {
    const auto made = edit_layers_at_random(m, 200, 1, 2 * num_polys(m) + 200);
    CHECK(made[0] > 0);
    CHECK(made[2] > 0);
    expect_grids(m, coarse_layout(m));
  });
}

}  // namespace concino::testing
