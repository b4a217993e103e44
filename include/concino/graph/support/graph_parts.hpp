// Graphs as arguments, and lengths of their arcs: what adapters need that have searches of their own.
#pragma once

#include <concino/graph/detail/crossings.hpp>
#include <concino/graph/detail/graph_of.hpp>
