// The gradients at the corners of triangles and tets, for mesh types with only such polys. Same values as
// corner_gradients, up to rounding, without arrays of variable size.
#pragma once

#include <concino/operators/corner_gradients.hpp>

#include <array>

namespace concino {

/// The gradients at the corners of one triangle or tet. One object serves for many polys, like corner_gradients.
///
/// The gradient of corner i is normal to the opposite facet, and its length is one over the height above it. In a
/// triangle it is the opposite edge, rotated by 90 degrees about the normal and divided by twice the area. In a tet it
/// is the cross product of two edges of that facet over six times the volume.
template<EmbeddedMesh M>
  requires(TriMesh<M> || TetMesh<M>)
struct simplex_gradients {
  static constexpr std::size_t corners = static_cast<std::size_t>(arity_v<M>);

  std::array<vert_t<M>, corners> verts;
  std::array<vec3, corners> gradient;  // not finite where the poly has no measure
  double measure = 0;                  // area, or volume: negative for an inverted tet

  void visit(const M& m, const poly_t<M>& p) {
    std::array<vec3, corners> x;
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m, p))
      if (n < corners) {
        verts[n] = v;
        x[n++] = to_vec3(point(m, v));
      }
    const vec3 a = x[1] - x[0], b = x[2] - x[0];
    if constexpr (corners == 3) {
      const vec3 normal = cross(a, b);
      const double doubled = norm(normal), factor = 1 / doubled;
      const vec3 scaled_normal = factor * (factor * normal);  // in this order: the square of an area may overflow or
                                                              // underflow
      gradient[0] = cross(x[1] - x[2], scaled_normal);
      gradient[1] = cross(b, scaled_normal);
      gradient[2] = cross(scaled_normal, a);
      measure = 0.5 * doubled;
    } else {
      const vec3 c = x[3] - x[0], facet = cross(b, c);
      const double product = dot(a, facet), factor = 1 / product;
      gradient[0] = factor * cross(x[3] - x[1], x[2] - x[1]);
      gradient[1] = factor * facet;
      gradient[2] = factor * cross(c, a);
      gradient[3] = factor * cross(a, b);
      measure = product / 6;
    }
  }

  /// Whether the poly visited last has a measure and finite points. Without a measure there was a division by 0.
  bool has_gradients() const {
    vec3 sum = gradient[0];
    for (std::size_t i = 1; i < corners; ++i) sum += gradient[i];
    return std::isfinite(sum.x + sum.y + sum.z);
  }
};

template<class M> struct poly_gradients_of { using type = corner_gradients<M>; };
template<class M>
  requires TriMesh<M> || TetMesh<M>
struct poly_gradients_of<M> { using type = simplex_gradients<M>; };

/// The faster of the two types for M.
template<class M> using poly_gradients = typename poly_gradients_of<M>::type;

}  // namespace concino
