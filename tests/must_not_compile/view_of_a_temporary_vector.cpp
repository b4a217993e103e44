// expect in 10 lines: give the array a name
#include <concino/adapters/span.hpp>

#include <vector>

auto fine(std::span<const double> points, const std::vector<int>& polys) { return concino::view_tri(points, polys); }
auto dangling(const std::vector<int>& polys) { return concino::view_tri(std::vector<double>(9), polys); }
