// A half-edge mesh as taught in courses: vectors of structs, indices instead of pointers, `none` for no element. Deleted elements are marked and keep their
// place. A border has half-edges of its own, without a face.
#pragma once

#include <map>
#include <utility>
#include <vector>

namespace student {

constexpr unsigned none = ~0u;

struct Vertex { double x, y, z; unsigned halfedge = none; bool deleted = false; };
struct Face { unsigned halfedge = none; bool deleted = false; };
struct HalfEdge { unsigned origin = none, next = none, prev = none, face = none; bool deleted = false; };

class Mesh {
 public:
  std::vector<Vertex> vertices;
  std::vector<HalfEdge> halfedges;  // 2e and 2e + 1 are twins
  std::vector<Face> faces;
  unsigned deletedVertices = 0, deletedEdges = 0, deletedFaces = 0;

  static unsigned twin(unsigned h) { return h ^ 1; }
  unsigned target(unsigned h) const { return halfedges[twin(h)].origin; }

  Mesh(std::vector<Vertex> points, const std::vector<std::vector<unsigned>>& polygons) : vertices(std::move(points)) {
    std::map<std::pair<unsigned, unsigned>, unsigned> between;
    for (const auto& polygon : polygons) {
      const unsigned n = static_cast<unsigned>(polygon.size());
      std::vector<unsigned> ring;
      for (unsigned i = 0; i < n; ++i) ring.push_back(halfedge(between, polygon[i], polygon[(i + 1) % n]));
      for (unsigned i = 0; i < n; ++i) {
        link(ring[i], ring[(i + 1) % n]);
        halfedges[ring[i]].face = static_cast<unsigned>(faces.size());
        vertices[polygon[i]].halfedge = ring[i];
      }
      faces.push_back({ring[n - 1]});  // the one that leads to the first vertex
    }
    for (unsigned h = 0; h < static_cast<unsigned>(halfedges.size()); ++h) {
      if (halfedges[h].face != none) continue;
      unsigned out = twin(h);
      while (halfedges[out].face != none) out = twin(halfedges[out].prev);
      link(h, out);
    }
  }

  void deleteFace(unsigned f) {
    std::vector<unsigned> ring;
    unsigned h = faces[f].halfedge;
    do ring.push_back(h), h = halfedges[h].next;
    while (h != faces[f].halfedge);
    for (const unsigned r : ring) halfedges[r].face = none;
    for (const unsigned r : ring)
      if (halfedges[twin(r)].face == none) deleteEdge(r);
    faces[f].deleted = true;
    ++deletedFaces;
  }

  void deleteVertex(unsigned v) {  // for a vertex without edges
    vertices[v].deleted = true;
    ++deletedVertices;
  }

 private:
  unsigned halfedge(std::map<std::pair<unsigned, unsigned>, unsigned>& between, unsigned from, unsigned to) {
    const auto [at, is_new] = between.try_emplace({from, to}, static_cast<unsigned>(halfedges.size()));
    if (is_new) {
      between[{to, from}] = twin(at->second);
      halfedges.push_back({from});
      halfedges.push_back({to});
    }
    return at->second;
  }
  void link(unsigned h, unsigned next) {
    halfedges[h].next = next;
    halfedges[next].prev = h;
  }
  void deleteEdge(unsigned h) {
    for (const unsigned g : {h, twin(h)}) {
      unsigned& leaving = vertices[halfedges[g].origin].halfedge;
      const unsigned other = halfedges[twin(g)].next;
      if (leaving == g) leaving = other == g ? none : other;
    }
    const HalfEdge a = halfedges[h], b = halfedges[twin(h)];
    link(a.prev, b.next);
    link(b.prev, a.next);
    halfedges[h].deleted = halfedges[twin(h)].deleted = true;
    ++deletedEdges;
  }
};

}  // namespace student
