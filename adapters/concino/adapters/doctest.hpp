// One line for tests written with doctest (Debian: doctest-dev): CHECK that a mesh type conforms.
#pragma once

#include <concino/testing/conformance.hpp>

#include <doctest/doctest.h>

namespace concino {

/// Fails the test case, with the report, unless conformance(make, options) finds nothing.
template<class Make, class M = std::remove_cvref_t<std::invoke_result_t<const Make&>>>
void check_conformance(const Make& make, const conformance_options<M>& options = {}) {
  const conformance_report report = conformance(make, options);
  CHECK_MESSAGE(report.ok(), report.text());
}

}  // namespace concino
