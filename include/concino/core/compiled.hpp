// Selects header-only use or the compiled library, for code that does not depend on the mesh type. x.hpp declares it
// and x.ipp defines it. By default x.hpp includes x.ipp. The library concino::compiled contains the same files; targets
// that link it have CONCINO_COMPILED defined, and include none of them.
#pragma once

#ifdef CONCINO_COMPILED

#define CONCINO_INLINE

#include <cstddef>

#if defined(_GLIBCXX_DEBUG) || (defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI)
#error "concino::compiled was built with the usual types of the standard library: link concino::concino, which is header-only, or drop _GLIBCXX_DEBUG and _GLIBCXX_USE_CXX11_ABI=0"
#endif

// Only these two headers of Eigen/Core: they define what memory Eigen allocates, and take a tenth of the compile time.
#include <Eigen/src/Core/util/Macros.h>

#include <Eigen/src/Core/util/ConfigureVectorization.h>

/// The symbol that the linker reports if a file and the library were compiled with flags for which Eigen's memory
/// layout or alignment differs, such as -mavx2: such programs would corrupt memory. The library defines the symbol for
/// the flags with which it was built.
namespace concino::compile_this_file_and_concino_compiled_with_the_same_flags_such_as_mavx2 {

template<int World, int Major, int Minor>
struct eigen_version {
  template<int Bytes>
  struct max_align_bytes {
    template<int IndexBytes>
    struct index_bytes {
      static const char reference;
    };
  };
};

using of_this_file = eigen_version<EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION>::max_align_bytes<
    EIGEN_MAX_ALIGN_BYTES>::index_bytes<sizeof(EIGEN_DEFAULT_DENSE_INDEX_TYPE)>;

// One in each file: of an inline variable the linker would keep the first one and see no mismatch.
[[gnu::used]] static const char* const guard = &of_this_file::reference;

}  // namespace concino::compile_this_file_and_concino_compiled_with_the_same_flags_such_as_mavx2

#else

#define CONCINO_INLINE inline

#endif
