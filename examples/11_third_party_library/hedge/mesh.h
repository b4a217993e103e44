// "hedge", a small half-edge library as many programs have one. It does not know concino.
#ifndef HEDGE_MESH_H
#define HEDGE_MESH_H

#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace hedge {

constexpr unsigned INVALID = ~0u;

struct Vertex { unsigned idx = INVALID; bool operator==(const Vertex& o) const { return idx == o.idx; } };
struct Halfedge { unsigned idx = INVALID; bool operator==(const Halfedge& o) const { return idx == o.idx; } };
struct Edge { unsigned idx = INVALID; bool operator==(const Edge& o) const { return idx == o.idx; } };
struct Face { unsigned idx = INVALID; bool operator==(const Face& o) const { return idx == o.idx; } };

struct Position { float x, y, z; };

/// An oriented manifold surface of polygons, maybe with boundary. Half-edges 2e and 2e + 1 belong to edge e.
class Mesh {
 public:
  Mesh(std::vector<Position> positions, const std::vector<std::vector<unsigned>>& polygons)
      : position_(std::move(positions)), out_(position_.size()) {
    std::map<std::pair<unsigned, unsigned>, unsigned> known;
    for (const auto& polygon : polygons) {
      std::vector<unsigned> ring;
      for (std::size_t i = 0; i < polygon.size(); ++i) ring.push_back(half_edge(known, polygon[i], polygon[(i + 1) % polygon.size()]));
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (face_[ring[i]] != INVALID) throw std::runtime_error("hedge: not a manifold");
        face_[ring[i]] = static_cast<unsigned>(start_.size());
        next_[ring[i]] = ring[(i + 1) % ring.size()];
      }
      start_.push_back(ring[0]);
    }
    // The next half-edge after a boundary half-edge h: turn around the end of h until a half-edge leaves it that has no face.
    for (unsigned h = 0; h < next_.size(); ++h) {
      if (face_[h] != INVALID) continue;
      unsigned g = h ^ 1u;
      while (face_[g] != INVALID) {
        while (to_[g] != to_[h]) g = next_[g];
        g ^= 1u;
      }
      next_[h] = g;
    }
  }

  std::size_t vertex_count() const { return position_.size(); }
  std::size_t edge_count() const { return next_.size() / 2; }
  std::size_t face_count() const { return start_.size(); }

  Halfedge next(Halfedge h) const { return {next_[h.idx]}; }
  Halfedge twin(Halfedge h) const { return {h.idx ^ 1u}; }
  Vertex tip(Halfedge h) const { return {to_[h.idx]}; }
  Face face(Halfedge h) const { return {face_[h.idx]}; }  // invalid on the boundary
  Edge edge(Halfedge h) const { return {h.idx / 2}; }
  Halfedge out(Vertex v) const { return out_[v.idx]; }  // invalid if there is none
  Halfedge start(Face f) const { return {start_[f.idx]}; }

  const Position& position(Vertex v) const { return position_[v.idx]; }
  Position& position(Vertex v) { return position_[v.idx]; }

 private:
  unsigned half_edge(std::map<std::pair<unsigned, unsigned>, unsigned>& known, unsigned a, unsigned b) {
    const auto there = known.find({a, b});
    if (there != known.end()) return there->second;
    const unsigned h = static_cast<unsigned>(to_.size());
    known[{a, b}] = h;
    known[{b, a}] = h + 1;
    to_.insert(to_.end(), {b, a});
    face_.resize(h + 2, INVALID);
    next_.resize(h + 2, INVALID);
    if (out_[a].idx == INVALID) out_[a] = {h};
    if (out_[b].idx == INVALID) out_[b] = {h + 1};
    return h;
  }

  std::vector<Position> position_;
  std::vector<Halfedge> out_;
  std::vector<unsigned> to_, next_, face_, start_;
};

}  // namespace hedge

#endif
