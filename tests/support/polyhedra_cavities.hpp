// Random cavities of general polyhedra for `rewire`.
#pragma once

#include <concino/mesh.hpp>

#include <support/cavities.hpp>
#include <support/soups.hpp>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace concino::testing {

using cycle = std::vector<unsigned>;

/// Begins with the smallest vert.
inline cycle rotated(cycle v) {
  std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
  return v;
}
inline cycle reversed(cycle v) {
  std::reverse(v.begin(), v.end());
  return v;
}

/// The verts of face f, counter-clockwise seen from outside p.
inline cycle outward_face(const polyhedralmesh& m, poly_id p, face_id f) {
  const cycle v = raw(adj_f2v(m, f));
  return face_is_outward(m, p, f) ? v : reversed(v);
}

/// Adds a poly with these faces.
inline void add_polyhedron(owned_cavity& c, const std::vector<cycle>& faces) {
  for (const cycle& v : faces) c.add_poly(v);
  c.poly_ends.push_back(static_cast<unsigned>(c.ends.size()));
}

inline unsigned local_number(const owned_cavity& c, unsigned v) {
  return static_cast<unsigned>(std::find(c.verts.begin(), c.verts.end(), vert_id{v}) - c.verts.begin());
}

/// The outward faces of old poly p, by the numbers of the verts in the cavity.
inline std::vector<cycle> local_faces(const owned_cavity& c, const polyhedralmesh& m, poly_id p) {
  std::vector<cycle> all;
  for (const auto f : adj_p2f(m, p)) {
    all.push_back(outward_face(m, p, f));
    for (unsigned& v : all.back()) v = local_number(c, v);
  }
  return all;
}

/// Polys made of faces of the old ones, in any direction, and of new faces.
inline owned_cavity random_polyhedra(const polyhedralmesh& m, std::mt19937& random) {
  owned_cavity c;
  std::vector<poly_id> polys;
  for (const auto p : concino::polys(m)) polys.push_back(p);
  for (auto i = random() % 3; i > 0 && !polys.empty(); --i) {
    c.polys.push_back(take(polys, random));
    for (const auto q : adj_p2p(m, c.polys.back()))
      if (random() % 2 == 0 && std::find(c.polys.begin(), c.polys.end(), q) == c.polys.end()) {
        c.polys.push_back(q);
        polys.erase(std::find(polys.begin(), polys.end(), q));
      }
  }
  std::set<unsigned> used;
  for (const auto p : c.polys)
    for (const auto v : adj_p2v(m, p)) used.insert(v.raw());
  for (const auto v : verts(m))
    if (random() % 5 == 0) used.insert(v.raw());
  std::vector<vert_id> last;  // verts without other polys or faces can be removed
  for (const unsigned i : used) {
    const vert_id v{i};
    bool is_free = true;
    for (const auto f : adj_v2f(m, v)) {
      is_free = is_free && !adj_f2p(m, f).empty();
      for (const auto p : adj_f2p(m, f)) is_free = is_free && std::find(c.polys.begin(), c.polys.end(), p) != c.polys.end();
    }
    (is_free && random() % 2 == 0 ? last : c.verts).push_back(v);
  }
  const auto usable = static_cast<unsigned>(c.verts.size());
  c.verts.insert(c.verts.end(), last.begin(), last.end());
  c.removed = last.size();
  c.points.resize(random() % 3);
  std::vector<cycle> pool;
  for (const auto p : c.polys)
    for (const cycle& v : local_faces(c, m, p))
      if (*std::max_element(v.begin(), v.end()) < usable) pool.push_back(v);
  const auto num_usable = usable + static_cast<unsigned>(c.points.size());
  for (auto i = random() % 4; i > 0 && num_usable > 4; --i) {
    cycle v = some_of(random, num_usable, 3 + static_cast<unsigned>(random() % 2));
    for (unsigned& x : v) x = x < usable ? x : x - usable + static_cast<unsigned>(c.verts.size());
    pool.push_back(v);
  }
  for (auto k = random() % 4; k > 0 && !pool.empty(); --k) {
    std::vector<cycle> faces;
    std::set<cycle> met;
    for (auto j = 1 + random() % 6; j > 0; --j) {
      cycle v = pool[random() % pool.size()];
      if (random() % 2) v = reversed(v);
      std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(random() % v.size()), v.end());
      if (met.insert(std::min(rotated(v), rotated(reversed(v)))).second) faces.push_back(v);
    }
    add_polyhedron(c, faces);
  }
  c.kept = random() % (1 + std::min(c.polys.size(), c.poly_ends.size()));
  return c;
}

}  // namespace concino::testing
