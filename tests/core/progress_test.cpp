#include <concino/core/progress.hpp>

#include <doctest/doctest.h>

TEST_CASE("progress: the callback is optional; false cancels, and the error names the operation") {
  concino::detail::report_progress({}, 0.5, "thinking");
  double heard = -1;
  const auto go_on = [&](double f, const char*) { heard = f; return true; };
  concino::detail::report_progress(go_on, 0.25, "thinking");
  CHECK(heard == 0.25);
  const auto stop = [](double, const char*) { return false; };
  CHECK_THROWS_WITH_AS(concino::detail::report_progress(stop, 0.5, "thinking"), "thinking: stopped by the progress callback", concino::cancelled);
}
