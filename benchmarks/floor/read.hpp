// The floors of reading OBJ, .mesh and .hedra files: parse into flat arrays, then compute all adjacencies.
#pragma once

#include "cells.hpp"
#include "polyhedra.hpp"
#include "surface.hpp"
#include "text.hpp"

namespace bench::floors {

template<u32 K>
surface<K> parse_obj(const std::string& path) {
  const mapped_file file(path);
  surface<K> m;
  if constexpr (K == 0) m.p_off.push(0);
  for (cursor c{file.begin(), file.end()}; c.at != c.end; c.line()) {
    if (c.word("v ")) {
      for (int i = 0; i < 3; ++i) m.points.push(c.real());
    } else if (c.word("f ")) {
      u32 n = 0;
      for (c.blanks(); c.digit(); c.blanks(), ++n) m.p2v.push(c.natural() - 1);
      if constexpr (K == 0) m.p_off.push(static_cast<u32>(m.p2v.size()));
      else if (n != K) cursor::wrong();
    }
  }
  const u32 nv = m.num_verts();
  for (u32 v : m.p2v)
    if (v >= nv) cursor::wrong();
  return m;
}

template<class S>
cells<S> parse_mesh(const std::string& path) {
  const mapped_file file(path);
  cells<S> m;
  cursor c{file.begin(), file.end()};
  for (c.spaces(); c.at != c.end && !c.word("End"); c.spaces()) {
    if (c.word("MeshVersionFormatted") || c.word("Dimension")) {
      c.natural();
    } else if (c.word("Vertices")) {
      c.spaces();
      const u32 n = c.natural();
      m.points.resize(std::size_t{3} * n);
      for (u32 i = 0; i < n; ++i) {
        c.spaces();
        for (u32 k = 0; k < 3; ++k) m.points[3 * i + k] = c.real();
        c.natural();
      }
    } else if (c.word(S::verts == 4 ? "Tetrahedra" : "Hexahedra")) {
      c.spaces();
      const u32 n = c.natural(), nv = m.num_verts();
      m.p2v.resize(std::size_t{S::verts} * n);
      for (u32 i = 0; i < n; ++i) {
        c.spaces();
        for (u32 k = 0; k < S::verts; ++k)
          if ((m.p2v[S::verts * i + k] = c.natural() - 1) >= nv) cursor::wrong();
        c.natural();
      }
    } else {
      cursor::wrong();
    }
  }
  return m;
}

inline polyhedra parse_hedra(const std::string& path) {
  const mapped_file file(path);
  polyhedra m;
  cursor c{file.begin(), file.end()};
  const u32 nv = c.natural(), nf = c.natural(), np = c.natural();
  m.points.resize(std::size_t{3} * nv);
  for (u32 i = 0; i < nv; ++i) {
    c.spaces();
    for (u32 k = 0; k < 3; ++k) m.points[3 * i + k] = c.real();
  }
  m.f_off.resize(nf + 1);
  m.f_off[0] = 0;
  for (u32 f = 0; f < nf; ++f) {
    c.spaces();
    for (u32 n = c.natural(); n; --n) {
      m.f2v.push(c.natural() - 1);
      if (m.f2v[m.f2v.size() - 1] >= nv) cursor::wrong();
    }
    m.f_off[f + 1] = static_cast<u32>(m.f2v.size());
  }
  m.p_off.resize(np + 1);
  m.p_off[0] = 0;
  for (u32 p = 0; p < np; ++p) {
    c.spaces();
    for (u32 n = c.natural(); n; --n) {
      c.blanks();
      const bool reversed = c.word("-");
      const u32 f = c.natural() - 1;
      if (f >= nf) cursor::wrong();
      m.p2f.push(f | (reversed ? 0 : polyhedra::outward));
    }
    m.p_off[p + 1] = static_cast<u32>(m.p2f.size());
  }
  m.f2v.shrink();
  m.p2f.shrink();
  return m;
}

template<u32 K>
surface<K> read_obj(const std::string& path) {
  auto m = parse_obj<K>(path);
  m.points.shrink();
  m.p_off.shrink();
  m.p2v.shrink();
  build(m);
  return m;
}

template<class S>
cells<S> read_mesh(const std::string& path) {
  auto m = parse_mesh<S>(path);
  build(m);
  return m;
}

inline polyhedra read_hedra(const std::string& path) {
  auto m = parse_hedra(path);
  build(m);
  return m;
}

}  // namespace bench::floors
