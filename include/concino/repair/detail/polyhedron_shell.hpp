// The faces of one polyhedron: whether they close it, and which way they are turned.
#pragma once

#include <concino/mesh/support/standard_cells.hpp>
#include <concino/mesh/support/volume_sign.hpp>
#include <concino/repair/detail/edge_lists.hpp>
#include <concino/repair/detail/surface_lists.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace concino::detail {

class polyhedron_shell {
  const surface_lists& all_faces_;
  std::span<const std::uint32_t> faces_;
  std::span<std::uint8_t> outward_;
  std::unordered_map<std::uint32_t, std::uint32_t> number_;  // of the verts in this cell
  std::vector<std::uint32_t> verts_, offsets_, corners_;     // the verts by number; the faces by these numbers
  edge_lists edges_;
  std::vector<std::uint8_t> is_known_;

  /// Whether the edge of a corner runs from its smaller to its larger vert when its face is outward.
  bool runs_up(std::uint32_t corner) const {
    return (corners_[corner] < corners_[edges_.next(corner)]) == (outward_[edges_.poly_of(corner)] != 0);
  }

 public:
  explicit polyhedron_shell(const surface_lists& faces) : all_faces_(faces) {}

  /// The faces of a cell, and whether each is outward, which orient() changes.
  void read(std::span<const std::uint32_t> faces, std::span<std::uint8_t> outward) {
    faces_ = faces, outward_ = outward;
    number_.clear();
    verts_.clear(), corners_.clear();
    offsets_.assign(1, 0);
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t v : all_faces_.poly(f)) {
        const auto [at, is_new] = number_.emplace(v, static_cast<std::uint32_t>(verts_.size()));
        if (is_new) verts_.push_back(v);
        corners_.push_back(at->second);
      }
      offsets_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
    edges_ = edge_lists(offsets_, corners_, verts_.size());
  }

  /// Turns faces so that those which share an edge have one outside: as few as possible in each connected part.
  void orient() {
    std::vector<std::uint32_t> part, turned;
    is_known_.assign(faces_.size(), 0);
    for (std::uint32_t start = 0; start < faces_.size(); ++start) {
      if (is_known_[start]) continue;
      is_known_[start] = 1;
      part.assign(1, start), turned.clear();
      for (std::size_t k = 0; k < part.size(); ++k)
        for (std::uint32_t c = offsets_[part[k]]; c < offsets_[part[k] + 1]; ++c) {
          const auto at = edges_.corners(edges_.edge_of(c));
          if (at.size() != 2) continue;
          const std::uint32_t other = at[0] == c ? at[1] : at[0], f = edges_.poly_of(other);
          if (is_known_[f]) continue;
          is_known_[f] = 1;
          if (runs_up(other) == runs_up(c)) outward_[f] ^= 1, turned.push_back(f);
          part.push_back(f);
        }
      if (2 * turned.size() > part.size())
        for (const std::uint32_t f : part) outward_[f] ^= 1;
    }
  }

  bool is_closed() const {
    for (std::size_t e = 0; e < edges_.num_edges(); ++e)
      if (edges_.corners(e).size() < 2) return false;
    return true;
  }

  /// Of the volume; 0 if that is zero, or there is none.
  std::int8_t sign() const {
    for (std::size_t e = 0; e < edges_.num_edges(); ++e) {
      const auto at = edges_.corners(e);
      if (at.size() != 2 || runs_up(at[0]) == runs_up(at[1])) return 0;
    }
    volume_box box;
    for (const std::uint32_t v : verts_) {
      if (!is_finite(all_faces_.points[v])) return 0;
      box.add(all_faces_.points[v]);
    }
    const bool is_moderate = box.is_moderate();
    const vec3 apex = is_moderate ? all_faces_.points[verts_[0]] : box.scaled(all_faces_.points[verts_[0]]);
    double volume = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const auto list = all_faces_.poly(faces_[f]);
      const double part = six_times_volume_under(
          list.size(),
          [&](std::size_t i) {
            const vec3& x = all_faces_.points[list[i]];
            return is_moderate ? x : box.scaled(x);
          },
          apex);
      volume += outward_[f] ? part : -part;
    }
    const double error = box.error(corners_.size());
    return static_cast<std::int8_t>(volume > error ? 1 : volume < -error ? -1 : 0);
  }

  /// The loops of edges that only one face has, in the direction that a missing face would have seen from outside.
  std::vector<std::vector<std::uint32_t>> missing_loops() const {
    std::vector<std::vector<std::uint32_t>> next(verts_.size()), loops;
    for (std::size_t e = 0; e < edges_.num_edges(); ++e) {
      if (edges_.corners(e).size() != 1) continue;
      const std::uint32_t c = edges_.corners(e)[0];
      std::uint32_t from = corners_[edges_.next(c)], to = corners_[c];
      if (!outward_[edges_.poly_of(c)]) std::swap(from, to);
      next[from].push_back(to);
    }
    for (std::uint32_t start = 0; start < next.size(); ++start)
      while (!next[start].empty()) {
        loops.emplace_back();
        for (std::uint32_t v = start; !next[v].empty();) {
          loops.back().push_back(verts_[v]);
          const std::uint32_t w = next[v].back();
          next[v].pop_back();
          v = w;
        }
      }
    return loops;
  }
};

}  // namespace concino::detail
