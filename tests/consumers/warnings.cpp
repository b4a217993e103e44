// A user's program compiled with full optimisation and all warnings as errors, with concino by -I. Some warnings come only from optimised
// templates, so it passes arrays of many types and checks the results. The code is not in main, which runs once and is optimised less.
#include <concino/adapters/span.hpp>
#include <concino/mesh/view_arrays.hpp>

#include <vector>

std::size_t num_polys_of(std::vector<double>& xyz, std::vector<int>& ints, std::vector<long>& longs, std::vector<unsigned>& unsigneds);
std::size_t num_polys_of(std::vector<double>& xyz, std::vector<int>& ints, std::vector<long>& longs, std::vector<unsigned>& unsigneds) {
  using namespace concino;
  return num_polys(view_tri(xyz, ints)) + num_polys(view_tri(xyz, longs)) + num_polys(view_quad(xyz, unsigneds)) +
         num_polys(view_polygons(xyz, ints, ints)) + num_polys(view_tet(xyz, ints));
}
