// If an allocation fails while a skeleton is read or written, nothing leaks and no file changes.
#include <concino/io/skeleton.hpp>

#include <support/failing_allocations.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

TEST_CASE("reading and writing skeletons with failing allocations") {
  const concino::testing::temporary_folder folder;
  concino::testing::write_file(folder / "a.skel",
                               "ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n4\n10 0 0 0 0.5 2 -3 7\n7 1 0 0 0.25 1 10\n-3 0 1 0 0.125 1 10\n8 5 5 5 1e-3 0\n");
  const concino::skeleton k = concino::load_skeleton(folder / "a.skel");
  auto result = concino::testing::for_each_failing_allocation([&](const auto& attempt) {
    concino::load_report report;
    bool is_same = true;
    attempt([&] { is_same = concino::load_skeleton(folder / "a.skel", {.report = &report}) == k; });
    CHECK(is_same);
  });
  CHECK(result.failed > 10);
  CHECK(result.leaks == 0);
  result = concino::testing::for_each_failing_allocation([&](const auto& attempt) {
    const bool failed = attempt([&] { concino::save_skeleton(k, folder / "b.cg"); });
    CHECK(folder.num_files() == (failed ? 1 : 2));
  });
  CHECK(result.failed > 2);
  CHECK(result.leaks == 0);
}
