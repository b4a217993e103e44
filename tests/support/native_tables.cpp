#include <support/native_tables.hpp>

#ifndef __clang__
CONCINO_TEST_NATIVE_TABLES();
#endif
