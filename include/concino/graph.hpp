// Algorithms on the graph of verts and edges and on the graph of polys, one source for both.
#pragma once

#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>
