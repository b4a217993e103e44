// expect in 10 lines: #include <concino/adapters/openmesh.hpp>
// Braces and options do not hide what is wrong.
#include <concino/fields.hpp>

struct foreign {};
struct foreign_vert {};
auto refused(const foreign& m, foreign_vert v) { return concino::harmonic_map(m, {{v, 1.0}}, {.exponent = 2}); }
