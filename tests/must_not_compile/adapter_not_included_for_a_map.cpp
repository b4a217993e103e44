// expect in 10 lines: #include <concino/adapters/openmesh.hpp>
#include <concino/mesh.hpp>

struct foreign {};
auto refused(const foreign& m) { return concino::make_vert_map<double>(m); }
