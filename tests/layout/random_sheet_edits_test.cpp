// Random collapses, insertions and pillows on quads and hexes of the corpus: laws and Euler characteristics hold.
#include <concino/layout.hpp>

#include <support/layouts.hpp>
#include <support/sheet_edits.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("random edits of chords and sheets keep laws", M, quadmesh, hexmesh) {
  for (const auto& one : meshes_with_layouts<M>(long_run())) {
    INFO(one.name);
    M m = one.mesh;
    const unsigned num_edits = one.name.find('/') != std::string::npos && long_run() ? 1000 : 200;
    const auto made = edit_layers_at_random(m, num_edits, 1, 2 * num_polys(m) + 200);
    CHECK(made[2] > 0);
    const auto facts = validate(m).facts, facts_before = validate(one.mesh).facts;
    CHECK(facts.components == facts_before.components);
    CHECK(facts.closed == facts_before.closed);
    CHECK(facts.manifold == facts_before.manifold);
    const auto l = coarse_layout(m);
    expect_grids(m, l);
  }
}
