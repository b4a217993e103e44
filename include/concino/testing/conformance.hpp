// conformance(factory): a test kit that checks whether a mesh type or an adapter is correct. Use it in the tests of
// your adapter.
//
// In addition to the laws of the concepts (numbered in their headers) it checks:
//   KIT1  M, const M, M& and const M& model the same concepts
//   KIT2  a range does not change while others are computed, is the same when computed again, and its iterators are
//         independent
//   KIT3  two threads that read a const mesh at the same time get the same results as one
//   KIT4  set_point moves its vert and no other
//   KIT5  algorithms give the same results as on the mesh converted to a native mesh
//   KIT6  removed elements are gone, added elements exist, and no other descriptor changes; editing with valid
//         arguments does not throw
//   KIT7  in a volume, as constructed, the sum over the faces of a poly of centroid times outward vector, three times
//         its volume, is positive
// and it rewires polys of editable meshes, which must be as the laws ED1 .. ED5 say, and edits edges by operators of
// the mesh itself, if it has some (ED6).
#pragma once

#include <concino/core/message.hpp>
#include <concino/testing/detail/edit_checks.hpp>
#include <concino/testing/detail/operator_checks.hpp>
#include <concino/testing/detail/oracle.hpp>
#include <concino/testing/detail/outward_checks.hpp>
#include <concino/testing/detail/range_checks.hpp>
#include <concino/testing/detail/rewire_checks.hpp>
#include <concino/validate/check_laws.hpp>

#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace concino {

/// The result of conformance().
struct conformance_report {
  struct finding {
    std::string law;      // "PG3", "KIT2"
    std::string state;    // of the mesh: "as constructed", "after every third poly was removed", or the name that the
                          // caller gave it
    std::string what;     // a sentence
    std::string witness;  // the elements: "v7 v9"
  };
  std::vector<std::string> models;  // the concepts that M models
  std::vector<std::string> states;  // the states of the mesh that were checked
  std::vector<finding> findings;

  bool ok() const { return findings.empty(); }
  /// The report as text.
  std::string text() const {
    std::string s = "models:";
    for (const std::string& c : models) s += concino::core::joined({" ", c});
    s += "\nstates:";
    for (std::size_t i = 0; i < states.size(); ++i) s += concino::core::joined({i ? ", " : " ", states[i]});
    s += "\n";
    if (ok()) s += "all laws hold\n";
    for (const finding& f : findings)
      s += concino::core::joined({f.law, ", ", f.state, ": ", f.what, f.witness.empty() ? "" : " [", f.witness,
                                  f.witness.empty() ? "" : "]", "\n"});
    return s;
  }
};

/// An additional state of the mesh to check.
template<class M>
struct conformance_state {
  std::string name;    // "after a flip"
  void (*apply)(M&);  // changes a new mesh into this state
};

template<class M>
struct conformance_options {
  std::vector<conformance_state<M>> states = {};  // to check, in addition to the states after edits
  bool algorithms = true;                         // whether KIT5 is checked; it takes most of the time to compile and
                                                  // to run
  bool turned_polys = false;                      // whether polys of the data may be turned inside out, so that KIT7 is
                                                  // not checked
};

namespace testing::detail {

struct named_concept { const char* name; bool in_all_forms, in_any_form; };

// One line per concept; each of the four forms of M is tested separately.
#define CONCINO_FORMS_OF(concept_name)                                                                          \
  named_concept {                                                                                               \
#concept_name, concept_name < M>&& concept_name < const M>&& concept_name < M&>&& concept_name < const M&>, \
        concept_name < M> || concept_name < const M> || concept_name < M&> || concept_name < const M&>          \
  }
template<class M>
std::vector<named_concept> forms() {
  return {CONCINO_FORMS_OF(PrimalGraph),       CONCINO_FORMS_OF(DualGraph),     CONCINO_FORMS_OF(SurfaceMesh),
          CONCINO_FORMS_OF(VolumeMesh),        CONCINO_FORMS_OF(AnyMesh),       CONCINO_FORMS_OF(TriMesh),
          CONCINO_FORMS_OF(QuadMesh),          CONCINO_FORMS_OF(TetMesh),       CONCINO_FORMS_OF(HexMesh),
          CONCINO_FORMS_OF(Embedded),          CONCINO_FORMS_OF(MutablePoints), CONCINO_FORMS_OF(EditableSurfaceMesh),
          CONCINO_FORMS_OF(EditableVolumeMesh)};
}
#undef CONCINO_FORMS_OF

template<class M>
void check_state(const M& m, const std::string& state, bool algorithms, conformance_report& report) {
  report.states.push_back(state);
  const auto keep = [&](const std::vector<broken_law>& broken) {
    for (const broken_law& b : broken) report.findings.push_back({b.law, state, b.what, b.witness});
    return broken.empty();
  };
  // Each check relies on the previous ones, so it stops at the first that fails.
  if (!keep(check_laws(m))) return;
  const auto guarded = [&](const char* law, const auto& check) {
    concino::detail::law_log log;
    try {
      check(log);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      log.add(law, concino::core::joined({"throws: ", e.what()}), "");
    }
    return keep(log.take());
  };
  if (!guarded("KIT2", [&](auto& log) { check_ranges(m, log); })) return;
  if (!guarded("KIT3", [&](auto& log) { check_threads(m, log); })) return;
  if constexpr (EmbeddedMesh<M>)
    if (algorithms) guarded("KIT5", [&](auto& log) { check_against_native(m, log); });
}

}  // namespace testing::detail

/// Checks a mesh type on one of its meshes.
/// Needs:  make() returns the same mesh at every call. It should have verts without polys, a boundary and several
///         components, if its type can.
/// Result: the states that were checked and the findings; report.text() is a text for people. The mesh is checked as
///         make() returns it, and in the states of the options. If the traits have add_vert, add_poly, remove_poly or
///         remove_vert, it is also checked after these edits.
/// Cost:   some tens of passes over the mesh, and make() once per state. A mesh of a few hundred elements reveals as
///         much as one of a million.
/// Errors: std::bad_alloc is passed on, and so are exceptions of make(). Any other exception of the mesh becomes a
///         finding.
template<class Make, class M = std::remove_cvref_t<std::invoke_result_t<const Make&>>>
  requires PrimalGraph<M> || DualGraph<M>
conformance_report conformance(const Make& make, const conformance_options<M>& options = {}) {
  namespace kit = testing::detail;
  conformance_report report;
  for (const kit::named_concept& c : kit::forms<M>()) {
    if (c.in_any_form) report.models.push_back(c.name);
    if (c.in_any_form != c.in_all_forms)
      report.findings.push_back(
          {"KIT1", "as constructed",
           concino::core::joined({c.name, " holds for some of M, const M, M& and const M&, not for all"}), ""});
  }
  {
    const M m = make();
    kit::check_state(m, "as constructed", options.algorithms, report);
    if constexpr (VolumeMesh<M> && Embedded<M>)  // polygons have no outside
      if (report.ok() && !options.turned_polys) kit::check_outward(m, "as constructed", report.findings);
  }
  if (!report.ok()) return report;

  const auto edited = [&](const std::string& state, const auto& edit) {
    M m = make();
    concino::detail::law_log log;
    try {
      edit(m, log);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      log.add("KIT6", concino::core::joined({"editing throws: ", e.what()}), "");
    }
    for (const broken_law& b : log.take()) report.findings.push_back({b.law, state, b.what, b.witness});
    kit::check_state(m, state, options.algorithms, report);
  };
  if constexpr (MutablePoints<M> && !is_view_v<M>)
    edited("after all points were moved", [](M& m, auto& log) { kit::check_point_edits(m, log); });
  if constexpr (requirement::has_remove_poly<M>)
    edited("after every third poly was removed", [](M& m, auto& log) { kit::remove_polys(m, log); });
  if constexpr (requirement::has_remove_vert<M> && requirement::has_remove_poly<M>)
    edited("after a vert was removed", [](M& m, auto&) {
      for (const vert_t<M> v : verts(m)) return remove_vert(m, v);
    });
  if constexpr (requirement::has_add_vert<M> && requirement::has_add_poly<M>)
    edited("after a poly was added", [](M& m, auto& log) { kit::add_one(m, log); });
  if constexpr (EditableMesh<M> && !is_view_v<M>)
    edited("after polys were rewired", [](M& m, auto& log) { kit::rewire_polys(m, log); });
  if constexpr (kit::has_own_operators<M>)
    edited("after an edge was edited", [&](M& m, auto& log) { kit::check_own_operators(m, make, log); });
  for (const auto& state : options.states) edited(state.name, [&](M& m, auto&) { state.apply(m); });
  return report;
}

}  // namespace concino
