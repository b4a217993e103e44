// A volume mesh of another program, in the manner of OpenVolumeMesh: face f has the half-faces 2f and 2f + 1, and each cell at it has one of them.
#pragma once

#include <array>
#include <vector>

namespace hfm {

struct VertexHandle { int idx; };
struct FaceHandle { int idx; };
struct HalfFaceHandle {
  int idx;
  FaceHandle face() const { return {idx / 2}; }
  bool isOpposite() const { return idx % 2 != 0; }  // its vertices run in the opposite order of the face's
};
struct CellHandle { int idx; };

class PolyhedralMesh {
  std::vector<std::array<float, 3>> points_;
  std::vector<std::vector<VertexHandle>> faces_;
  std::vector<std::vector<HalfFaceHandle>> cells_;

 public:
  VertexHandle addVertex(float x, float y, float z) {
    points_.push_back({x, y, z});
    return {static_cast<int>(points_.size()) - 1};
  }
  FaceHandle addFace(const std::vector<int>& corners) {
    faces_.emplace_back();
    for (const int v : corners) faces_.back().push_back({v});
    return {static_cast<int>(faces_.size()) - 1};
  }
  CellHandle addCell(const std::vector<int>& halfFaces) {
    cells_.emplace_back();
    for (const int h : halfFaces) cells_.back().push_back({h});
    return {static_cast<int>(cells_.size()) - 1};
  }
  const std::vector<std::array<float, 3>>& points() const { return points_; }
  const std::vector<std::vector<VertexHandle>>& faces() const { return faces_; }
  const std::vector<std::vector<HalfFaceHandle>>& cells() const { return cells_; }
};

}  // namespace hfm
