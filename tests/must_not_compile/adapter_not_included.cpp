// expect in 10 lines: #include <concino/adapters/openmesh.hpp>
#include <concino/graph.hpp>

struct foreign {};
struct foreign_vert {};
auto refused(const foreign& m, foreign_vert v) { return concino::dijkstra(m, v); }
