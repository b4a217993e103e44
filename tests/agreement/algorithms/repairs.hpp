// Repairs give the same mesh.
#pragma once

#include <agreement/algorithms/generated.hpp>

#include <concino/repair/repair.hpp>

namespace concino::agreement {

struct repairs {
  static constexpr const char* name = "repair";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    bool any = false;
    for (const repair_options& o : {repair_options{}, repair_options{.merge_within = 0.0, .split_non_manifold = true, .orient = true}})
      any = expect_same_polys([&] { return repaired(both.native, o).mesh; }, [&] { return repaired(both.other, o).mesh; }) || any;
    return any;
  }
};

}  // namespace concino::agreement
