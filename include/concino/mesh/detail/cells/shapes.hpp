// Tables of tetrahedra and hexahedra: the local verts of their edges and faces, and the faces at each edge. The order
// of verts is that of VTK and MEDIT; faces run counter-clockwise seen from outside.
#pragma once

#include <cstdint>

namespace concino::detail {

struct tet_shape {
  static constexpr unsigned verts = 4, edges = 6, faces = 4, face_verts = 3;
  static constexpr std::uint8_t face_vert[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  static constexpr std::uint8_t edge_vert[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
};

struct hex_shape {
  static constexpr unsigned verts = 8, edges = 12, faces = 6, face_verts = 4;
  static constexpr std::uint8_t face_vert[6][4] = {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7},
                                                   {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}};
  static constexpr std::uint8_t edge_vert[12][2] = {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {4, 5}, {5, 6},
                                                    {6, 7}, {4, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
};

/// Tables that follow from the two above, computed at compile time.
template<class Shape>
struct shape_tables {
  static constexpr unsigned valence = 3;  // number of edges, and of faces, at a vert of either shape

  std::uint8_t face_edge[Shape::faces][Shape::face_verts] = {};  // from its i-th vert to the next
  std::uint8_t edge_face[Shape::edges][2] = {};
  std::uint8_t vert_edge[Shape::verts][valence] = {};
  std::uint8_t vert_face[Shape::verts][valence] = {};
  std::uint8_t vert_far[Shape::verts][valence] = {};                               // the other ends of vert_edge
  // the verts that follow it in vert_face
  std::uint8_t vert_face_vert[Shape::verts][valence][Shape::face_verts - 1] = {};
  std::uint8_t vert_face_edge[Shape::verts][valence][2] = {};  // the positions in vert_edge of the first and last of
                                                               // them

  constexpr shape_tables() {
    for (unsigned f = 0; f < Shape::faces; ++f)
      for (unsigned i = 0; i < Shape::face_verts; ++i) {
        const unsigned a = Shape::face_vert[f][i], b = Shape::face_vert[f][(i + 1) % Shape::face_verts];
        for (unsigned e = 0; e < Shape::edges; ++e)
          if ((Shape::edge_vert[e][0] == a && Shape::edge_vert[e][1] == b) ||
              (Shape::edge_vert[e][0] == b && Shape::edge_vert[e][1] == a))
            face_edge[f][i] = static_cast<std::uint8_t>(e);
      }
    for (unsigned e = 0; e < Shape::edges; ++e) {
      unsigned n = 0;
      for (unsigned f = 0; f < Shape::faces; ++f)
        for (unsigned i = 0; i < Shape::face_verts; ++i)
          if (face_edge[f][i] == e) edge_face[e][n++] = static_cast<std::uint8_t>(f);
    }
    for (unsigned v = 0; v < Shape::verts; ++v) {
      unsigned n = 0;
      for (unsigned e = 0; e < Shape::edges; ++e)
        if (Shape::edge_vert[e][0] == v || Shape::edge_vert[e][1] == v)
          vert_edge[v][n++] = static_cast<std::uint8_t>(e);
      n = 0;
      for (unsigned f = 0; f < Shape::faces; ++f)
        for (unsigned i = 0; i < Shape::face_verts; ++i)
          if (Shape::face_vert[f][i] == v) {
            for (unsigned j = 1; j < Shape::face_verts; ++j)
              vert_face_vert[v][n][j - 1] = Shape::face_vert[f][(i + j) % Shape::face_verts];
            vert_face[v][n++] = static_cast<std::uint8_t>(f);
          }
      for (unsigned j = 0; j < valence; ++j)
        vert_far[v][j] = Shape::edge_vert[vert_edge[v][j]][Shape::edge_vert[vert_edge[v][j]][0] == v];
      for (unsigned k = 0; k < valence; ++k)
        for (unsigned j = 0; j < valence; ++j) {
          if (vert_far[v][j] == vert_face_vert[v][k][0]) vert_face_edge[v][k][0] = static_cast<std::uint8_t>(j);
          if (vert_far[v][j] == vert_face_vert[v][k][Shape::face_verts - 2])
            vert_face_edge[v][k][1] = static_cast<std::uint8_t>(j);
        }
    }
  }
};

template<class Shape>
inline constexpr shape_tables<Shape> shape_v{};

}  // namespace concino::detail
