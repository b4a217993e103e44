// expect: -ffast-math lets the compiler reorder sums
#define __FAST_MATH__ 1
#include <concino/geometry/orientation.hpp>
