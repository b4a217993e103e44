// The linker symbol whose name encodes the compile flags of the library; see compiled.hpp.
#pragma once

#include <concino/core/compiled.hpp>

#ifdef CONCINO_COMPILED

namespace concino::compile_this_file_and_concino_compiled_with_the_same_flags_such_as_mavx2 {

template<int World, int Major, int Minor>
template<int Bytes>
template<int IndexBytes>
const char eigen_version<World, Major, Minor>::max_align_bytes<Bytes>::index_bytes<IndexBytes>::reference = 0;

template struct eigen_version<EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION>::max_align_bytes<
    EIGEN_MAX_ALIGN_BYTES>::index_bytes<sizeof(EIGEN_DEFAULT_DENSE_INDEX_TYPE)>;

}  // namespace concino::compile_this_file_and_concino_compiled_with_the_same_flags_such_as_mavx2

#endif
