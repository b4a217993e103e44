// load, save and their relatives open scopes in a profiler.
#include <concino/io/load.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/obj.hpp>
#include <concino/io/save.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/io/slices.hpp>

#include <support/kinds.hpp>
#include <support/profiled.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: functions that load and save open scopes, and one for each step") {
  const temporary_folder folder;
  const auto m = grid<trimesh>(2);
  profiler p;
  save(m, folder / "a.obj", {.profiler = &p});
  const std::string text = save_text(m, file_format::obj, {.profiler = &p});
  load<trimesh>(folder / "a.obj", {.profiler = &p});
  load_text<trimesh>(text, file_format::obj, {.profiler = &p});
  load_any(folder / "a.obj", {.profiler = &p});
  CHECK(names_of(p) == names{"save", "-writing", "save_text", "-writing", "load", "-reading", "load_text", "-reading", "load_any", "-reading"});
  load_obj<trimesh>(folder / "a.obj", {.profiler = &p});
  save_obj(m, folder / "a.obj", {.profiler = &p});
  CHECK(p.entries()[0].calls == 2);  // as save
  CHECK(p.entries()[4].calls == 2);  // as load
}

TEST_CASE("profiler: functions that load and save skeletons and slices open scopes") {
  const temporary_folder folder;
  profiler p;
  const skeleton k = load_skeleton_text("ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n2\n0 0 0 0 1 1 1\n1 1 0 0 1 1 0\n", {.profiler = &p});
  save_skeleton(k, folder / "a.skel", {.profiler = &p});
  load_skeleton(folder / "a.skel", {.profiler = &p});
  save_skeleton_text(k, {.format = format_id(file_format::skel), .profiler = &p});
  slices one;
  one.layers.resize(1);
  save_slices(one, folder / "a.cli", {.profiler = &p});
  const slices s = load_slices(folder / "a.cli", {.profiler = &p});
  load_slices_text(save_slices_text(s, {.profiler = &p}), {.profiler = &p});
  CHECK(names_of(p) == names{"load_skeleton_text", "-reading", "save_skeleton", "-writing", "load_skeleton", "-reading", "save_skeleton_text", "-writing",
                            "save_slices", "-writing", "load_slices", "-reading", "save_slices_text", "-writing", "load_slices_text", "-reading"});
}
