#include <support/native_tables.hpp>

#ifndef __clang__
CONCINO_TEST_NATIVE_TABLES();
#endif

CONCINO_TEST_WHOLE_MESHES();
