// Compares check_laws and validate.
#pragma once

#include <agreement/matched.hpp>

#include <concino/validate.hpp>

#include <set>

namespace concino::agreement {

struct laws {
  static constexpr const char* name = "check_laws";
  template<class M> static constexpr bool runs_on = PrimalGraph<M> || DualGraph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto broken_by = [](const auto& m) {
      std::multiset<std::string> r;
      for (const auto& b : check_laws(m)) r.insert(b.law);
      return r;
    };
    const auto found = broken_by(both.other);
    if (found.empty()) return true;
    for (const auto& b : check_laws(both.other)) MESSAGE(b.law << ": " << b.what);
    expect(found == broken_by(both.native), "no law is broken but those that the arrays break");
    return true;
  }
};

struct defects {
  static constexpr const char* name = "validate";
  template<class M> static constexpr bool runs_on = AnyMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto expected = validate(both.native);
    const auto found = validate(both.other);
    // The reference has no arity, and so no order of corners. The shape of a hex that seems to be listed in another order is not compared.
    const bool other_order = found.count(defect_kind::corner_order) > 0;
    for (std::size_t k = 0; k < num_defect_kinds; ++k) {
      const auto kind = static_cast<defect_kind>(k);
      if (kind == defect_kind::corner_order) continue;
      const bool is_shape = kind == defect_kind::non_finite_point || kind == defect_kind::inverted_cell || kind == defect_kind::zero_size ||
                            kind == defect_kind::self_touching || kind == defect_kind::non_planar;
      if (is_shape && other_order) continue;
      const std::size_t n = is_shape && !Embedded<typename B::other_mesh> ? 0 : expected.count(kind);
      INFO(std::string(defect_name(kind)));
      expect(found.count(kind) == n, "as many defects of each kind");
    }
    const auto& a = expected.facts;
    const auto& b = found.facts;
    expect(a.manifold == b.manifold && a.orientable == b.orientable && a.closed == b.closed && a.components == b.components &&
               a.boundary_loops == b.boundary_loops && a.euler_characteristic == b.euler_characteristic && a.genus == b.genus,
           "the same facts");
    std::set<unsigned> lonely_here, lonely_there;
    for (const auto& d : expected)
      if (d.kind == defect_kind::isolated_vert) lonely_here.insert(std::get<0>(d.element).raw());
    for (const auto& d : found)
      if (d.kind == defect_kind::isolated_vert) lonely_there.insert(both.verts.back(std::get<0>(d.element)).raw());
    expect(lonely_here == lonely_there, "the same isolated verts");
    return true;
  }
};

}  // namespace concino::agreement
