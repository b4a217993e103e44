// A triangle mesh as others wrote it: a corner table (Rossignac 2001), two arrays and a handful of functions.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

struct CornerTable {
  std::vector<float> G;  // coordinates of the vertices
  std::vector<unsigned> V;  // of each corner: its vertex
  std::vector<int> O;       // of each corner: the corner on the other side of the edge that it faces, or -1

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
