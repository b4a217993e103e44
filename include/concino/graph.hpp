// Algorithms on the primal graph (verts and edges) and on the dual graph (polys), with one implementation for both.
// Algorithms of Boost.Graph are not included, because they take long to compile: see <concino/graph/boost.hpp>.
#pragma once

#include <concino/graph/bfs.hpp>
#include <concino/graph/boundary_loops.hpp>
#include <concino/graph/boundary_verts.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/cut_along.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/graph/edge_walk.hpp>
#include <concino/graph/grow_regions.hpp>
#include <concino/graph/homology.hpp>
#include <concino/graph/predecessors.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/graph/spanning_tree.hpp>
#include <concino/graph/tree_cotree.hpp>
