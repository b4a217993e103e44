// A stranger's program that is compiled with all optimisation and every warning an error, concino by -I. Some warnings come only where
// templates are used and optimised, so it hands in arrays of many types, which are checked. Not in main: it runs once, and is optimised less.
#include <concino/adapters/span.hpp>
#include <concino/mesh/view_arrays.hpp>

#include <vector>

std::size_t num_polys_of(std::vector<double>& xyz, std::vector<int>& ints, std::vector<long>& longs, std::vector<unsigned>& unsigneds);
std::size_t num_polys_of(std::vector<double>& xyz, std::vector<int>& ints, std::vector<long>& longs, std::vector<unsigned>& unsigneds) {
  using namespace concino;
  return num_polys(view_tri(xyz, ints)) + num_polys(view_tri(xyz, longs)) + num_polys(view_quad(xyz, unsigneds)) +
         num_polys(view_polygons(xyz, ints, ints)) + num_polys(view_tet(xyz, ints));
}
