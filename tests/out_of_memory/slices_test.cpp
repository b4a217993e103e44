// If an allocation fails while slices are read or written, nothing leaks and no file changes.
#include <concino/io/slices.hpp>

#include <support/failing_allocations.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <string>

TEST_CASE("reading and writing slices with failing allocations") {
  const concino::testing::temporary_folder folder;
  const std::string text =
      "$$HEADERSTART\n$$ASCII\n$$UNITS/0.5\n$$LABEL/3,a part with a name of some length\n$$UNKNOWN/1\n$$HEADEREND\n$$GEOMETRYSTART\n"
      "$$LAYER/3\n$$POLYLINE/3,1,4,0,0,1,0,0,1,0,0\n$$POLYLINE/4,0,3,1,1,2,2,3,3\n$$HATCHES/3,2,0,1,2,3,4,5,6,7\n$$LAYER/4\n$$GEOMETRYEND\n";
  concino::testing::write_file(folder / "a.cli", text);
  const concino::slices s = concino::load_slices(folder / "a.cli");
  auto result = concino::testing::for_each_failing_allocation([&](const auto& attempt) {
    concino::load_report report;
    bool is_same = true;
    attempt([&] { is_same = concino::load_slices(folder / "a.cli", {.report = &report}) == s; });
    CHECK(is_same);
  });
  CHECK(result.failed > 10);
  CHECK(result.leaks == 0);
  result = concino::testing::for_each_failing_allocation([&](const auto& attempt) {
    const bool failed = attempt([&] { concino::save_slices(s, folder / "b.cli"); });
    CHECK(folder.num_files() == (failed ? 1 : 2));
  });
  CHECK(result.failed > 2);
  CHECK(result.leaks == 0);
}
