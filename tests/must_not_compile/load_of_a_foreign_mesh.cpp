// expect in 10 lines: load<polygonmesh>.path.
// Files are read as meshes of this library; any other is made of one.
#include <concino/io.hpp>

struct foreign {};
auto refused() { return concino::load<foreign>("bunny.obj"); }
