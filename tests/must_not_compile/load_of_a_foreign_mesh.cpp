// expect in 10 lines: load<polygonmesh>.path.
// Files are only read as meshes of this library, which can be converted to others.
#include <concino/io.hpp>

struct foreign {};
auto refused() { return concino::load<foreign>("bunny.obj"); }
