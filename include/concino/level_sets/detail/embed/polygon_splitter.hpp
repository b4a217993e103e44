// Splits a polygon along diagonals.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Splits one polygon after another and reuses its memory. Corners are numbers, each once in a polygon.
class polygon_splitter {
  std::vector<std::vector<std::uint32_t>> pieces_;
  std::size_t n_ = 0;  // the pieces of the current polygon; those behind are memory

  std::vector<std::uint32_t>& add() {
    if (n_ == pieces_.size()) pieces_.emplace_back();
    pieces_[n_].clear();
    return pieces_[n_++];
  }

 public:
  /// Starts with a whole polygon.
  void start(std::span<const std::uint32_t> corners) {
    n_ = 0;
    add().assign(corners.begin(), corners.end());
  }
  /// Splits the piece that has both corners. Returns false if there is none: the diagonal crosses an earlier one.
  bool split(std::uint32_t a, std::uint32_t b) {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto at_a = std::find(pieces_[i].begin(), pieces_[i].end(), a),
                 at_b = std::find(pieces_[i].begin(), pieces_[i].end(), b);
      if (at_a == pieces_[i].end() || at_b == pieces_[i].end()) continue;
      const auto first = std::min(at_a, at_b) - pieces_[i].begin(), last = std::max(at_a, at_b) - pieces_[i].begin();
      if (last - first == 1 || last - first + 1 == std::ssize(pieces_[i])) return true;  // an edge of the piece
      std::vector<std::uint32_t>& other = add();
      std::vector<std::uint32_t>& piece = pieces_[i];
      other.assign(piece.begin() + first, piece.begin() + last + 1);
      piece.erase(piece.begin() + first + 1, piece.begin() + last);
      return true;
    }
    return false;
  }
  std::size_t num_pieces() const { return n_; }
  std::span<const std::uint32_t> piece(std::size_t i) const { return pieces_[i]; }
};

}  // namespace concino::detail
