// A surface mesh of another program: winged edges (Baumgart 1975), with integers for all elements.
#pragma once

#include <map>
#include <utility>
#include <vector>

namespace wings {

struct Edge {
  int start, end;
  int left = -1, right = -1;            // faces; -1: none
  int left_next = -1, right_next = -1;  // the next edge around the left face and around the right face
};

class Mesh {
  std::vector<double> xyz_;
  std::vector<Edge> edges_;
  std::vector<int> vertex_edge_, face_edge_;

  Edge& edge(int e) { return edges_[static_cast<std::size_t>(e)]; }

 public:
  Mesh(std::vector<double> xyz, const std::vector<std::vector<int>>& faces) : xyz_(std::move(xyz)), vertex_edge_(xyz_.size() / 3, -1) {
    std::map<std::pair<int, int>, int> made;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto& corners = faces[f];
      std::vector<int> around;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const int a = corners[i], b = corners[(i + 1) % corners.size()];
        const auto [at, fresh] = made.insert({{a < b ? a : b, a < b ? b : a}, static_cast<int>(edges_.size())});
        if (fresh) edges_.push_back({a, b});
        Edge& e = edge(at->second);
        (e.start == a ? e.left : e.right) = static_cast<int>(f);
        vertex_edge_[static_cast<std::size_t>(a)] = at->second;
        around.push_back(at->second);
      }
      for (std::size_t i = 0; i < corners.size(); ++i) {
        Edge& e = edge(around[i]);
        (e.start == corners[i] ? e.left_next : e.right_next) = around[(i + 1) % around.size()];
      }
      face_edge_.push_back(around[0]);
    }
    std::map<int, int> border;  // the edge that leaves a vertex along the border
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e].left < 0) border[edges_[e].start] = static_cast<int>(e);
      if (edges_[e].right < 0) border[edges_[e].end] = static_cast<int>(e);
    }
    for (Edge& e : edges_) {
      if (e.left < 0) e.left_next = border[e.end];
      if (e.right < 0) e.right_next = border[e.start];
    }
  }
  int vertices() const { return static_cast<int>(vertex_edge_.size()); }
  int edges() const { return static_cast<int>(edges_.size()); }
  int faces() const { return static_cast<int>(face_edge_.size()); }
  const Edge& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
  int edgeAtVertex(int v) const { return vertex_edge_[static_cast<std::size_t>(v)]; }  // -1: none
  int edgeAtFace(int f) const { return face_edge_[static_cast<std::size_t>(f)]; }
  const double* coordinates(int v) const { return &xyz_[3 * static_cast<std::size_t>(v)]; }
};

}  // namespace wings
