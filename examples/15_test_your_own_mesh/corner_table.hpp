// A triangle mesh of another program: a corner table (Rossignac 2001), which stores the vertex and the opposite corner of each corner.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

struct CornerTable {
  std::vector<float> G;  // coordinates of the vertices
  std::vector<unsigned> V;  // the vertex of each corner
  std::vector<int> O;       // the corner opposite to each corner, in the triangle behind the edge that it faces, or -1

  static unsigned next(unsigned c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static unsigned previous(unsigned c) { return next(next(c)); }

  CornerTable(std::vector<float> coordinates, std::vector<unsigned> corners) : G(std::move(coordinates)), V(std::move(corners)), O(V.size(), -1) {
    std::map<std::pair<unsigned, unsigned>, unsigned> faced;
    for (unsigned c = 0; c < V.size(); ++c) faced[{V[next(c)], V[previous(c)]}] = c;
    for (unsigned c = 0; c < V.size(); ++c) {
      const auto across = faced.find({V[previous(c)], V[next(c)]});
      if (across != faced.end()) O[c] = static_cast<int>(across->second);
    }
  }
};
