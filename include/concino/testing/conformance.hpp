// conformance(factory): is this mesh, or this adapter, right? For the tests of anybody who adapts a mesh type.
//
// Beside the laws of the concepts (numbered in their headers) it checks:
//   KIT1  the concepts that M models are those of const M, M& and const M&
//   KIT2  a range stays what it is while others are asked for, differs in nothing when asked again, and its iterators do not disturb each other
//   KIT3  two threads that read a const mesh at once get the answers that one gets
//   KIT4  set_point moves the vert it is given, and no other
//   KIT5  algorithms give what they give on the same mesh converted to this library's own
//   KIT6  what was removed is gone, what was added is there, and no other element is renamed; editing throws nothing on sound arguments
#pragma once

#include <concino/core/message.hpp>
#include <concino/testing/detail/edit_checks.hpp>
#include <concino/testing/detail/oracle.hpp>
#include <concino/testing/detail/range_checks.hpp>
#include <concino/validate/check_laws.hpp>

#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace concino {

/// What conformance() found.
struct conformance_report {
  struct finding {
    std::string law;      // "PG3", "KIT2"
    std::string state;    // of the mesh: "as made", "after every third poly was removed", or the name that the caller gave it
    std::string what;     // a sentence
    std::string witness;  // the elements: "v7 v9"
  };
  std::vector<std::string> models;  // the concepts that M models
  std::vector<std::string> states;  // that were looked at
  std::vector<finding> findings;

  bool ok() const { return findings.empty(); }
  /// A page for people.
  std::string text() const {
    std::string s = "models:";
    for (const std::string& c : models) s += concino::core::joined({" ", c});
    s += "\nlooked at:";
    for (std::size_t i = 0; i < states.size(); ++i) s += concino::core::joined({i ? ", " : " ", states[i]});
    s += "\n";
    if (ok()) s += "all laws hold\n";
    for (const finding& f : findings) s += concino::core::joined({f.law, ", ", f.state, ": ", f.what, f.witness.empty() ? "" : " [", f.witness,
                                                        f.witness.empty() ? "" : "]", "\n"});
    return s;
  }
};

/// Another state that the mesh can be brought into.
template<class M>
struct conformance_state {
  std::string name;    // "after a flip"
  void (*apply)(M&);  // from the mesh as made
};

template<class M>
struct conformance_options {
  std::vector<conformance_state<M>> states = {};  // looked at besides those that edits lead to
  bool algorithms = true;                         // whether KIT5 is checked; it takes most of the time to compile and to run
};

namespace testing::detail {

struct named_concept { const char* name; bool in_all_forms, in_any_form; };

// One line per concept; each form is asked by itself.
#define CONCINO_FORMS_OF(concept_name)                                                                                     \
  named_concept {                                                                                                          \
    #concept_name, concept_name<M> && concept_name<const M> && concept_name<M&> && concept_name<const M&>,                 \
        concept_name<M> || concept_name<const M> || concept_name<M&> || concept_name<const M&>                             \
  }
template<class M>
std::vector<named_concept> forms() {
  return {CONCINO_FORMS_OF(PrimalGraph), CONCINO_FORMS_OF(DualGraph), CONCINO_FORMS_OF(SurfaceMesh), CONCINO_FORMS_OF(VolumeMesh), CONCINO_FORMS_OF(AnyMesh),
          CONCINO_FORMS_OF(TriMesh),     CONCINO_FORMS_OF(QuadMesh),  CONCINO_FORMS_OF(TetMesh),     CONCINO_FORMS_OF(HexMesh),    CONCINO_FORMS_OF(Embedded),
          CONCINO_FORMS_OF(MutablePoints)};
}
#undef CONCINO_FORMS_OF

template<class M>
void check_state(const M& m, const std::string& state, bool algorithms, conformance_report& report) {
  report.states.push_back(state);
  const auto keep = [&](const std::vector<broken_law>& broken) {
    for (const broken_law& b : broken) report.findings.push_back({b.law, state, b.what, b.witness});
    return broken.empty();
  };
  // What follows trusts what came before: nothing is run on a mesh that is known to be wrong.
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

/// Checks a mesh type by one of its meshes.
/// Needs:  make() returns a mesh, the same at every call; it should have verts without polys, a border and several pieces where its type can.
/// Result: what was looked at and what was found; report.text() says it in words. As made, and, where the traits offer add_vert, add_poly,
///         remove_poly or remove_vert, in the states that these lead to, and in those of the options.
/// Cost:   some tens of walks over the mesh, and make() once a state; a mesh of a few hundred elements finds what one of a million does.
/// Errors: std::bad_alloc passes, and so does what make() throws. All else that the mesh throws is a finding.
template<class Make, class M = std::remove_cvref_t<std::invoke_result_t<const Make&>>>
  requires PrimalGraph<M> || DualGraph<M>
conformance_report conformance(const Make& make, const conformance_options<M>& options = {}) {
  namespace kit = testing::detail;
  conformance_report report;
  for (const kit::named_concept& c : kit::forms<M>()) {
    if (c.in_any_form) report.models.push_back(c.name);
    if (c.in_any_form != c.in_all_forms)
      report.findings.push_back({"KIT1", "as made", concino::core::joined({c.name, " holds for some of M, const M, M& and const M&, not for all"}), ""});
  }
  {
    const M m = make();
    kit::check_state(m, "as made", options.algorithms, report);
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
  if constexpr (MutablePoints<M> && !is_view_v<M>) edited("after all points were moved", [](M& m, auto& log) { kit::check_points(m, log); });
  if constexpr (requirement::has_remove_poly<M>) edited("after every third poly was removed", [](M& m, auto& log) { kit::remove_polys(m, log); });
  if constexpr (requirement::has_remove_vert<M> && requirement::has_remove_poly<M>)
    edited("after a vert was removed", [](M& m, auto&) {
      for (const vert_t<M> v : verts(m)) return remove_vert(m, v);
    });
  if constexpr (requirement::has_add_vert<M> && requirement::has_add_poly<M>)
    edited("after a poly was added", [](M& m, auto& log) { kit::add_one(m, log); });
  for (const auto& state : options.states) edited(state.name, [&](M& m, auto&) { state.apply(m); });
  return report;
}

}  // namespace concino
