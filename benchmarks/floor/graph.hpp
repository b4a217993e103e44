// The floors of the graph searches: breadth-first search with an array as the queue, and Dijkstra with the binary heap of the standard library. Both read rows
// of neighbours in flat arrays. The time includes the array of results.
#pragma once

#include "buffer.hpp"

#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace bench::floors {

/// The neighbours of i are adj[off[i]] .. adj[off[i + 1]]; entries `none` are skipped. With Stride > 0, all rows have that length, and there are no offsets.
template<u32 Stride>
struct rows {
  static constexpr u32 stride = Stride;
  const u32* off;
  const u32* adj;
  u32 size;
  u32 first(u32 i) const { return Stride ? Stride * i : off[i]; }
  u32 last(u32 i) const { return Stride ? Stride * i + Stride : off[i + 1]; }
};

template<u32 Stride, bool Filled>
buffer<std::int32_t> bfs(const rows<Stride>& g, u32 source) {
  buffer<std::int32_t> hops(g.size, 0xff);
  buffer<u32> queue(g.size);
  u32 tail = 1;
  queue[0] = source;
  hops[source] = 0;
  for (u32 head = 0; head != tail; ++head) {
    const u32 v = queue[head];
    const std::int32_t h = hops[v] + 1;
    for (u32 k = g.first(v); k != g.last(v); ++k) {
      const u32 w = g.adj[k];
      if constexpr (Filled)
        if (w == none) continue;
      if (hops[w] < 0) {
        hops[w] = h;
        queue[tail++] = w;
      }
    }
  }
  return hops;
}

/// `points` has the positions of the nodes, x y z. The length of an arc is the distance of its ends.
template<u32 Stride, bool Filled>
buffer<double> dijkstra(const rows<Stride>& g, const double* points, u32 source) {
  using entry = std::pair<double, u32>;
  buffer<double> d(g.size);
  for (u32 i = 0; i < g.size; ++i) d[i] = std::numeric_limits<double>::infinity();
  std::priority_queue<entry, std::vector<entry>, std::greater<>> heap;
  d[source] = 0;
  heap.push({0.0, source});
  while (!heap.empty()) {
    const auto [dv, v] = heap.top();
    heap.pop();
    if (dv > d[v]) continue;
    const double* a = points + 3 * std::size_t{v};
    for (u32 k = g.first(v); k != g.last(v); ++k) {
      const u32 w = g.adj[k];
      if constexpr (Filled)
        if (w == none) continue;
      const double* b = points + 3 * std::size_t{w};
      const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
      const double dw = dv + std::sqrt(x * x + y * y + z * z);
      if (dw < d[w]) {
        d[w] = dw;
        heap.push({dw, w});
      }
    }
  }
  return d;
}

/// The component of each node, by a breadth-first search from every node not visited yet. Components are numbered in the order of their first nodes.
template<u32 Stride, bool Filled>
buffer<std::int32_t> components(const rows<Stride>& g) {
  buffer<std::int32_t> label(g.size, 0xff);
  buffer<u32> queue(g.size);
  std::int32_t count = 0;
  for (u32 i = 0; i < g.size; ++i) {
    if (label[i] >= 0) continue;
    u32 tail = 1;
    queue[0] = i;
    label[i] = count;
    for (u32 head = 0; head != tail; ++head) {
      const u32 v = queue[head];
      for (u32 k = g.first(v); k != g.last(v); ++k) {
        const u32 w = g.adj[k];
        if constexpr (Filled)
          if (w == none) continue;
        if (label[w] < 0) {
          label[w] = count;
          queue[tail++] = w;
        }
      }
    }
    ++count;
  }
  return label;
}

/// The mean of the verts of each poly, for searches on the dual graph.
template<u32 K>
buffer<double> centroids(const double* points, const u32* p2v, u32 num_polys) {
  buffer<double> c(3 * std::size_t{num_polys});
  for (u32 p = 0; p < num_polys; ++p)
    for (u32 i = 0; i < 3; ++i) {
      double sum = 0;
      for (u32 k = 0; k < K; ++k) sum += points[3 * std::size_t{p2v[K * p + k]} + i];
      c[3 * std::size_t{p} + i] = sum / K;
    }
  return c;
}

}  // namespace bench::floors
