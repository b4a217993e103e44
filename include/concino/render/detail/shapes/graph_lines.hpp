// Divides the edges of a graph into lines, so that few tubes draw them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/drawable.hpp>
#include <concino/render/tubes.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A graph with verts numbered from 0.
struct flat_graph {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
  bool lone_verts = false;  // verts without edges are drawn
};

/// Lines that have each edge once, and the vert of each of their points.
struct graph_lines {
  flat_lines lines;
  std::vector<std::uint32_t> verts;

  void end_line(const flat_graph& g, bool closed);
};

/// Trails that go straight on where they can. They begin at verts where an odd number of edges meet, and then go round
/// what is left.
/// Cost:   O(verts + edges): at a vert at most 16 edges are compared.
graph_lines graph_lines_of(const flat_graph& g);

/// Tubes along all edges; options.values and options.radii are by vert.
drawable tubes_of(const flat_graph& g, const tube_options& options, const char* caller);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/graph_lines.ipp>
#endif
