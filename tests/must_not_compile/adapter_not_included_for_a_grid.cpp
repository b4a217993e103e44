// expect in 10 lines: #include <concino/adapters/openmesh.hpp>
#include <concino/generate.hpp>

struct foreign {};
auto refused() { return concino::make_grid<foreign>({.cells = {2, 2, 2}}); }
