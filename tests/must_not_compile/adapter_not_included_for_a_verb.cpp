// expect in 10 lines: #include <concino/adapters/openmesh.hpp>
// The verb is declared behind many includes, which g++ lists before it prints the line.
#include <concino/fields.hpp>

struct foreign {};
auto refused(const foreign& m) { return concino::verts(m); }
