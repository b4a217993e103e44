// The readers of all formats, in the compiled library only.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/read_hedra.hpp>
#include <concino/io/detail/read_medit.hpp>
#include <concino/io/detail/read_obj.hpp>
#include <concino/io/detail/read_off.hpp>

#ifdef CONCINO_COMPILED
namespace concino {

template void hedra_format::read<volume_contents>(const read_context&, volume_contents&);
template void medit_format::read<file_contents>(const read_context&, file_contents&);
template void medit_format::read<volume_contents>(const read_context&, volume_contents&);

// They are inline, for files that include them; this makes the compiler write them here.
namespace {
[[gnu::used]] void (*const readers[])(const read_context&, file_contents&) = {&obj_format::read, &off_format::read};
}  // namespace

}  // namespace concino
#endif
