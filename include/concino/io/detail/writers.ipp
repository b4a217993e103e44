// The writers of all formats, in the compiled library only.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/write_hedra.hpp>
#include <concino/io/detail/write_medit.hpp>
#include <concino/io/detail/write_obj.hpp>
#include <concino/io/detail/write_off.hpp>

#ifdef CONCINO_COMPILED
namespace concino {

// They are inline, for files that include them; this makes the compiler write them here.
namespace {
[[gnu::used]] void (*const writers[])(write_context&, flat_mesh&) = {&hedra_format::write, &medit_format::write, &obj_format::write, &off_format::write};
}  // namespace

}  // namespace concino
#endif
