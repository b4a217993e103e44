// Rows of the tables beside: a row calls one public function once on every kind of mesh that it takes. tests/headers/every_function.cmake compares the rows
// with the functions that the headers declare.
#pragma once

#include <concino/generate/grid.hpp>
#include <concino/mesh.hpp>

#include <cstdio>
#include <exception>

namespace cn = concino;

template<class... M> struct kinds {};
inline constexpr kinds<cn::trimesh, cn::quadmesh, cn::polygonmesh> surfaces;
inline constexpr kinds<cn::tetmesh, cn::hexmesh, cn::polyhedralmesh> volumes;
inline constexpr kinds<cn::trimesh, cn::quadmesh, cn::polygonmesh, cn::tetmesh, cn::hexmesh, cn::polyhedralmesh> all;
inline constexpr kinds<cn::trimesh> triangles;
inline constexpr kinds<cn::tetmesh> tets;

inline int num_calls = 0, num_failures = 0;

/// A row of a function that takes no mesh.
template<class F>
void call(const char* name, const F& f) {
  ++num_calls;
  try {
    f();
  } catch (const std::exception& e) {
    ++num_failures;
    std::printf("%s: %s\n", name, e.what());
  }
}

/// A row of a function that takes meshes: f(m) for a new mesh of each kind.
template<class F, class... M>
void call(const char* name, const F& f, kinds<M...>) {
  const auto on = [&](auto m) { call(name, [&] { f(m); }); };
  (on(cn::make_grid<M>({.cells = {2, 2, 2}})), ...);
}

template<class R>
auto first(const R& range) { return *range.begin(); }

/// A number for each vert, no two alike.
template<class M>
auto heights(const M& m) {
  auto u = cn::make_vert_map<double>(m);
  for (const auto v : cn::verts(m)) u[v] = cn::point(m, v).x + 0.31 * cn::point(m, v).y + 0.17 * cn::point(m, v).z;
  return u;
}

