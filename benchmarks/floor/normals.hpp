// The floors of normals: unit normals of polys, verts and faces from flat arrays. Each vector area is computed once.
#pragma once

#include "operators.hpp"

namespace bench::floors {

inline vector3 operator+(vector3 a, vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vector3 unit(vector3 a) {
  const double f = 1 / norm(a);
  return {f * a.x, f * a.y, f * a.z};
}

/// Twice the vector area of a polygon of n verts.
template<class Vert>
vector3 doubled_area(const buffer<double>& points, u32 n, Vert vert) {
  const vector3 o = at(points, vert(0));
  vector3 a = at(points, vert(1)) - o, b = at(points, vert(2)) - o, sum = cross(a, b);
  for (u32 i = 3; i < n; ++i) {
    a = b;
    b = at(points, vert(i)) - o;
    sum = sum + cross(a, b);
  }
  return sum;
}

struct surface_normals {
  buffer<vector3> polys, verts;
};

/// The normals of all polys, and of all verts: the direction of the sum of the vector areas around a vert.
template<u32 K>
surface_normals normals(const surface<K>& m) {
  const u32 np = m.num_polys(), nv = m.num_verts();
  surface_normals n{buffer<vector3>(np), buffer<vector3>(nv, 0)};
  for (u32 p = 0; p < np; ++p) {
    const u32* const v = m.p2v.data() + m.first(p);
    const u32 size = K ? K : m.last(p) - m.first(p);
    const vector3 area = doubled_area(m.points, size, [&](u32 i) { return v[i]; });
    n.polys[p] = unit(area);
    for (u32 i = 0; i < size; ++i) n.verts[v[i]] = n.verts[v[i]] + area;
  }
  for (u32 v = 0; v < nv; ++v) n.verts[v] = unit(n.verts[v]);
  return n;
}

/// The normals of all faces. A face is oriented as in the poly that has it first.
template<class S>
buffer<vector3> normals(const cells<S>& m) {
  const u32 nf = m.num_faces();
  buffer<vector3> n(nf);
  for (u32 f = 0; f < nf; ++f) {
    const u32 h = m.f2h[f], *const v = m.p2v.data() + h / S::faces * S::verts, *const i = S::face[h % S::faces];
    n[f] = unit(doubled_area(m.points, S::face_size, [&](u32 k) { return v[i[k]]; }));
  }
  return n;
}

}  // namespace bench::floors
