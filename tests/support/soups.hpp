// Random lists of polys over few verts: edges and faces with many polys, non-manifold verts, polys that share several facets, isolated verts. A mesh
// must be able to represent all of them.
#pragma once

#include <support/kinds.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace concino::testing {

inline std::vector<vec3> random_points(std::mt19937& random, std::size_t n) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<vec3> points(n);
  for (vec3& p : points) p = {unit(random), unit(random), unit(random)};
  return points;
}

/// k different numbers below n.
inline std::vector<unsigned> some_of(std::mt19937& random, unsigned n, unsigned k) {
  std::vector<unsigned> all(n);
  for (unsigned i = 0; i < n; ++i) all[i] = i;
  std::shuffle(all.begin(), all.end(), random);
  all.resize(k);
  return all;
}

/// Polys as input for a mesh: lists of verts, or for polyhedra lists of faces.
template<class M>
struct soup {
  std::vector<vec3> points;
  std::vector<std::vector<unsigned>> verts;                        // of polys; polyhedra: of faces
  std::vector<std::vector<std::pair<unsigned, bool>>> poly_faces;  // polyhedra only

  M mesh() const {
    if constexpr (std::same_as<M, polyhedralmesh>) return M(points, verts, poly_faces);
    else return M(points, verts);
  }
};

template<class M>
soup<M> random_soup(std::mt19937& random, unsigned vert_count, unsigned poly_count) {
  soup<M> s;
  s.points = random_points(random, vert_count);
  const auto size = [&] { return arity_v<M> ? static_cast<unsigned>(arity_v<M>) : std::min(vert_count, 3 + static_cast<unsigned>(random() % 4)); };
  if constexpr (std::same_as<M, polyhedralmesh>) {
    const unsigned face_count = 2 * poly_count + 1;
    for (unsigned f = 0; f < face_count; ++f) s.verts.push_back(some_of(random, vert_count, size()));
    for (unsigned p = 0; p < poly_count; ++p) {
      auto& faces = s.poly_faces.emplace_back();
      for (const unsigned f : some_of(random, face_count, 1 + static_cast<unsigned>(random() % std::min(face_count, 5u)))) faces.emplace_back(f, random() % 2 == 0);
    }
  } else {
    for (unsigned p = 0; p < poly_count; ++p) s.verts.push_back(some_of(random, vert_count, size()));
  }
  return s;
}

}  // namespace concino::testing
