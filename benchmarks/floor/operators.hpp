// The floors of the operators, for triangles and tets in flat arrays only: one weight per edge, summed in a pass over the polys. The columns of the matrix are
// then filled directly from the rows of neighbours.
#pragma once

#include "cells.hpp"
#include "surface.hpp"

#include <cmath>

namespace bench::floors {

struct vector3 { double x, y, z; };
inline vector3 operator-(vector3 a, vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vector3 cross(vector3 a, vector3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double dot(vector3 a, vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double norm(vector3 a) { return std::sqrt(dot(a, a)); }

inline vector3 at(const buffer<double>& points, u32 v) {
  const double* p = points.data() + 3 * std::size_t{v};
  return {p[0], p[1], p[2]};
}

/// For each edge of a triangle mesh, half the sum of the cotangents of the angles opposite to it.
inline buffer<double> cotangents(const surface<3>& m) {
  buffer<double> w(m.num_edges(), 0);
  for (u32 c = 0; c != m.p2v.size(); c += 3) {
    const vector3 a = at(m.points, m.p2v[c]), b = at(m.points, m.p2v[c + 1]), d = at(m.points, m.p2v[c + 2]);
    const vector3 ab = b - a, bd = d - b, da = a - d;
    const double f = -0.5 / norm(cross(ab, bd));
    w[m.p2e[c]] += f * dot(bd, da);
    w[m.p2e[c + 1]] += f * dot(da, ab);
    w[m.p2e[c + 2]] += f * dot(ab, bd);
  }
  return w;
}

/// For each edge of a tet mesh, a sum over its tets: a sixth of the length of the opposite edge times the cotangent of the dihedral angle there. This is
/// minus the scalar product of the vector areas of the two faces that lack one end each, divided by nine times the volume.
inline buffer<double> cotangents(const cells<tet_shape>& m) {
  buffer<double> w(m.num_edges(), 0);
  const u32 np = m.num_polys();
  for (u32 p = 0; p < np; ++p) {
    const u32 *v = &m.p2v[4 * p], *e = &m.p2e[6 * p];
    const vector3 o = at(m.points, v[0]), a = at(m.points, v[1]) - o, b = at(m.points, v[2]) - o, c = at(m.points, v[3]) - o;
    const vector3 s1 = cross(b, c), s2 = cross(c, a), s3 = cross(a, b), s0 = {-s1.x - s2.x - s3.x, -s1.y - s2.y - s3.y, -s1.z - s2.z - s3.z};
    const double f = -1 / (6 * std::abs(dot(a, s1)));
    w[e[0]] += f * dot(s0, s1);
    w[e[1]] += f * dot(s1, s2);
    w[e[2]] += f * dot(s2, s0);
    w[e[3]] += f * dot(s0, s3);
    w[e[4]] += f * dot(s1, s3);
    w[e[5]] += f * dot(s2, s3);
  }
  return w;
}

/// A sparse matrix in compressed columns, each with ascending rows.
struct matrix {
  buffer<int> begin, rows;
  buffer<double> values;
};

/// weight(k) belongs to entry k of v2v. Each column is sorted as it is written. Short columns are sorted by counting for each row how many rows are less,
/// which has no branches to mispredict, longer columns by insertion.
template<class Mesh, class Weight>
matrix fill(const Mesh& m, Weight weight) {
  const u32 nv = m.num_verts(), entries = static_cast<u32>(m.v2v.size()) + nv;
  matrix a{buffer<int>(nv + 1), buffer<int>(entries), buffer<double>(entries)};
  int* rows = a.rows.data();
  double* values = a.values.data();
  a.begin[0] = 0;
  for (u32 v = 0; v < nv; ++v) {
    const u32 first = m.v_off[v], n = m.v_off[v + 1] - first;
    const u32* w = m.v2v.data() + first;
    double sum = 0;
    u32 diagonal = 0;
    if (n <= 8) {
      for (u32 i = 0; i < n; ++i) {
        u32 place = w[i] > v;
        diagonal += w[i] < v;
        for (u32 j = 0; j < n; ++j) place += w[j] < w[i];
        const double x = weight(first + i);
        sum += x;
        rows[place] = static_cast<int>(w[i]);
        values[place] = x;
      }
    } else {
      rows[0] = static_cast<int>(v);
      for (u32 i = 0; i < n; ++i) {
        const int row = static_cast<int>(w[i]);
        const double x = weight(first + i);
        sum += x;
        u32 j = i + 1;
        for (; j > 0 && rows[j - 1] > row; --j) {
          rows[j] = rows[j - 1];
          values[j] = values[j - 1];
        }
        rows[j] = row;
        values[j] = x;
      }
      while (rows[diagonal] != static_cast<int>(v)) ++diagonal;
    }
    rows[diagonal] = static_cast<int>(v);
    values[diagonal] = -sum;
    rows += n + 1;
    values += n + 1;
    a.begin[v + 1] = a.begin[v] + static_cast<int>(n + 1);
  }
  return a;
}

template<class Mesh>
matrix uniform_laplacian(const Mesh& m) { return fill(m, [](u32) { return 1.0; }); }

template<class Mesh>
matrix cotangent_laplacian(const Mesh& m) {
  const buffer<double> w = cotangents(m);
  return fill(m, [&](u32 k) { return w[m.v2e[k]]; });
}

/// The gradients of the hat functions on one triangle or tet p: the entries of rows 3p, 3p + 1, 3p + 2 in the columns of its verts.
inline void hat_gradients(const surface<3>& m, u32 p, vector3* g) {
  const vector3 a = at(m.points, m.p2v[3 * p]), b = at(m.points, m.p2v[3 * p + 1]), c = at(m.points, m.p2v[3 * p + 2]);
  const vector3 n = cross(b - a, c - a);
  const double f = 1 / dot(n, n);
  const vector3 d = {f * n.x, f * n.y, f * n.z};
  g[0] = cross(d, c - b);
  g[1] = cross(d, a - c);
  g[2] = cross(d, b - a);
}
inline void hat_gradients(const cells<tet_shape>& m, u32 p, vector3* g) {
  const u32* v = &m.p2v[4 * p];
  const vector3 o = at(m.points, v[0]), a = at(m.points, v[1]) - o, b = at(m.points, v[2]) - o, c = at(m.points, v[3]) - o;
  const vector3 s1 = cross(b, c), s2 = cross(c, a), s3 = cross(a, b);
  const double f = 1 / dot(a, s1);
  g[1] = {f * s1.x, f * s1.y, f * s1.z};
  g[2] = {f * s2.x, f * s2.y, f * s2.z};
  g[3] = {f * s3.x, f * s3.y, f * s3.z};
  g[0] = {-g[1].x - g[2].x - g[3].x, -g[1].y - g[2].y - g[3].y, -g[1].z - g[2].z - g[3].z};
}

/// Three rows per poly, a column per vert. The numbers of polys around the verts determine where each column begins. Polys are visited in ascending order,
/// so each column is filled from its top.
template<u32 K, class Mesh>
matrix gradient(const Mesh& m) {
  const u32 nv = m.num_verts(), np = m.num_polys(), entries = 3 * static_cast<u32>(m.p2v.size());
  matrix a{buffer<int>(nv + 1), buffer<int>(entries), buffer<double>(entries)};
  for (u32 v = 0; v <= nv; ++v) a.begin[v] = 3 * static_cast<int>(m.vp_off[v]);
  buffer<int> end(nv);
  std::memcpy(end.data(), a.begin.data(), nv * sizeof(int));
  for (u32 p = 0; p < np; ++p) {
    vector3 g[K];
    hat_gradients(m, p, g);
    const int row = 3 * static_cast<int>(p);
    for (u32 i = 0; i < K; ++i) {
      int& k = end[m.p2v[K * p + i]];
      int* r = a.rows.data() + k;
      double* x = a.values.data() + k;
      k += 3;
      r[0] = row;
      r[1] = row + 1;
      r[2] = row + 2;
      x[0] = g[i].x;
      x[1] = g[i].y;
      x[2] = g[i].z;
    }
  }
  return a;
}
inline matrix gradient(const surface<3>& m) { return gradient<3>(m); }
inline matrix gradient(const cells<tet_shape>& m) { return gradient<4>(m); }

inline double size_of(const surface<3>& m, u32 p) {
  const vector3 a = at(m.points, m.p2v[3 * p]);
  return norm(cross(at(m.points, m.p2v[3 * p + 1]) - a, at(m.points, m.p2v[3 * p + 2]) - a)) / 2;
}
inline double size_of(const cells<tet_shape>& m, u32 p) {
  const u32* v = &m.p2v[4 * p];
  const vector3 a = at(m.points, v[0]);
  return std::abs(dot(cross(at(m.points, v[1]) - a, at(m.points, v[2]) - a), at(m.points, v[3]) - a)) / 6;
}

/// Minus the transposed gradient times area or volume: three columns per poly, with a row for each of its verts, sorted by counting how many rows are less.
template<u32 K, class Mesh>
matrix divergence(const Mesh& m) {
  const u32 np = m.num_polys();
  matrix a{buffer<int>(3 * np + 1), buffer<int>(3 * K * np), buffer<double>(3 * K * np)};
  for (u32 c = 0; c <= 3 * np; ++c) a.begin[c] = static_cast<int>(K * c);
  for (u32 p = 0; p < np; ++p) {
    vector3 g[K];
    hat_gradients(m, p, g);
    const double size = -size_of(m, p);
    const u32* v = &m.p2v[K * p];
    int* r = a.rows.data() + 3 * K * p;
    double* x = a.values.data() + 3 * K * p;
    for (u32 i = 0; i < K; ++i) {
      u32 place = 0;
      for (u32 j = 0; j < K; ++j) place += v[j] < v[i];
      r[place] = r[place + K] = r[place + 2 * K] = static_cast<int>(v[i]);
      x[place] = size * g[i].x;
      x[place + K] = size * g[i].y;
      x[place + 2 * K] = size * g[i].z;
    }
  }
  return a;
}
inline matrix divergence(const surface<3>& m) { return divergence<3>(m); }
inline matrix divergence(const cells<tet_shape>& m) { return divergence<4>(m); }

/// The lumped masses: each poly's area or volume in equal parts to its verts.
inline buffer<double> masses(const surface<3>& m) {
  buffer<double> mass(m.num_verts(), 0);
  for (u32 c = 0; c != m.p2v.size(); c += 3) {
    const vector3 a = at(m.points, m.p2v[c]), b = at(m.points, m.p2v[c + 1]), d = at(m.points, m.p2v[c + 2]);
    const double part = norm(cross(b - a, d - a)) / 6;
    for (u32 i = 0; i < 3; ++i) mass[m.p2v[c + i]] += part;
  }
  return mass;
}

inline buffer<double> masses(const cells<tet_shape>& m) {
  buffer<double> mass(m.num_verts(), 0);
  for (u32 c = 0; c != m.p2v.size(); c += 4) {
    const vector3 o = at(m.points, m.p2v[c]), a = at(m.points, m.p2v[c + 1]) - o, b = at(m.points, m.p2v[c + 2]) - o,
                  d = at(m.points, m.p2v[c + 3]) - o;
    const double part = std::abs(dot(cross(a, b), d)) / 24;
    for (u32 i = 0; i < 4; ++i) mass[m.p2v[c + i]] += part;
  }
  return mass;
}

inline matrix diagonal(buffer<double> x) {
  matrix a{buffer<int>(x.size() + 1), buffer<int>(x.size()), std::move(x)};
  for (std::size_t i = 0; i <= a.rows.size(); ++i) a.begin[i] = static_cast<int>(i);
  for (std::size_t i = 0; i < a.rows.size(); ++i) a.rows[i] = static_cast<int>(i);
  return a;
}

inline vector3 unit_normal(vector3 a, vector3 b, vector3 c) {
  const vector3 n = cross(b - a, c - a);
  const double f = 1 / norm(n);
  return {f * n.x, f * n.y, f * n.z};
}

/// The unit normals of all triangles: the mass matrix is compared with the time for these.
inline buffer<vector3> face_normals(const surface<3>& m) {
  const u32 np = m.num_polys();
  buffer<vector3> n(np);
  for (u32 p = 0; p < np; ++p)
    n[p] = unit_normal(at(m.points, m.p2v[3 * p]), at(m.points, m.p2v[3 * p + 1]), at(m.points, m.p2v[3 * p + 2]));
  return n;
}

inline buffer<vector3> face_normals(const cells<tet_shape>& m) {
  const u32 nf = m.num_faces();
  buffer<vector3> n(nf);
  for (u32 f = 0; f < nf; ++f) {
    const u32 h = m.f2h[f], *v = &m.p2v[h / 4 * 4];
    const u32* i = tet_shape::face[h % 4];
    n[f] = unit_normal(at(m.points, v[i[0]]), at(m.points, v[i[1]]), at(m.points, v[i[2]]));
  }
  return n;
}

}  // namespace bench::floors
