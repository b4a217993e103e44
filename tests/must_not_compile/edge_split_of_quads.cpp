// expect: quads or hexes: make m a polygonmesh or polyhedralmesh
#include <concino/edit/edge_split.hpp>
#include <concino/mesh/quadmesh.hpp>

auto refused(concino::quadmesh& m) { return concino::edge_split(m, concino::edge_id{0}); }
