// expect: fixed number of verts: make m a polygonmesh or polyhedralmesh
#include <concino/edit/merge_polys.hpp>
#include <concino/mesh/quadmesh.hpp>

auto refused(concino::quadmesh& m) { return concino::merge_polys(m, concino::edge_id{0}); }
