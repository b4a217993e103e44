// expect in 10 lines: #include <concino/adapters/openmesh.hpp>
// The message is the same for calls with braces and options.
#include <concino/fields.hpp>

struct foreign {};
struct foreign_vert {};
auto refused(const foreign& m, foreign_vert v) { return concino::harmonic_map(m, {{v, 1.0}}, {.exponent = 2}); }
