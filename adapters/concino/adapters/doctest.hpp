// Conformance test for doctest: CHECKs in one line that a mesh type conforms.
// Needs: doctest (Debian: doctest-dev).
#pragma once

#include <concino/testing/conformance.hpp>

#include <doctest/doctest.h>

namespace concino {

/// Checks a mesh type with one of its meshes, in a test case of doctest.
/// Needs:  as conformance.
/// Result: none; the test case fails, with the report as its message, unless conformance(make, options) finds no
///         violation.
/// Cost:   as conformance.
/// Errors: as conformance.
template<class Make, class M = std::remove_cvref_t<std::invoke_result_t<const Make&>>>
void check_conformance(const Make& make, const conformance_options<M>& options = {}) {
  const conformance_report report = conformance(make, options);
  CHECK_MESSAGE(report.ok(), report.text());
}

}  // namespace concino
