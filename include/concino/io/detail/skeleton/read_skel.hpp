// The reader of .skel, the format of curve skeletons by Livesu et al. 2012: for each node its id, point, radius and
// neighbours.
#pragma once

#include <concino/io/detail/skeleton/skeleton_reader.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

class skel_reader : skeleton_reader {
  std::vector<std::pair<std::int64_t, std::uint32_t>> ids_;  // ids and indices of nodes, sorted; empty if they are
                                                             // equal
  std::vector<std::int64_t> neighbours_;
  std::vector<std::uint64_t> ends_;  // of the neighbours of each node

 public:
  using skeleton_reader::skeleton_reader;

  void read() {
    skip();
    for (const char* const expected : {"ID", "Cx", "Cy", "Cz", "RADIUS", "#NEIGHBORS", "NEIGHBORS_LIST"}) {
      skip();
      const char* const from = at;
      if (word() != expected) fail(from, {expected, " of the header ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST"});
    }
    const std::uint64_t n = next_count("the number of nodes", 12);
    const char* const nodes = at;
    const bool in_order = read_nodes(n);
    if (!in_order) {
      report_.notes.push_back("the ids of the nodes are not 0, 1, 2 ...; verts are numbered in the order of the file");
      sort_ids(nodes);
    }
    std::uint64_t k = 0;
    for (std::uint32_t v = 0; v < ends_.size(); ++v)
      for (; k < ends_[v]; ++k) add_edge(v, index_of_neighbour(neighbours_[k], k, nodes));
    drop_superfluous_edges(out_.edges, true, report_);
    end_file("node");
  }

 private:
  /// Reads all nodes. Result: whether their ids are 0, 1, 2 ...
  bool read_nodes(std::uint64_t n) {
    const std::size_t room = reservable(n, 12);
    out_.points.reserve(room);
    out_.radii.reserve(room);
    ends_.reserve(room);
    bool in_order = true;
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::int64_t id = next_integer("the id of a node");
      if (in_order && id != static_cast<std::int64_t>(i)) {
        in_order = false;
        ids_.reserve(room);
        for (std::uint32_t j = 0; j < i; ++j) ids_.push_back({j, j});
      }
      if (!in_order) ids_.push_back({id, static_cast<std::uint32_t>(i)});
      out_.points.push_back(next_point());
      out_.radii.push_back(next_real("the radius of a node"));
      const std::uint64_t num_neighbours = next_count("the number of neighbours", 2);
      for (std::uint64_t k = 0; k < num_neighbours; ++k) neighbours_.push_back(next_integer("the id of a neighbour"));
      ends_.push_back(neighbours_.size());
      report_progress();
    }
    return in_order;
  }

  /// Sorts the ids. Errors: parse_error if two nodes have the same one.
  void sort_ids(const char* nodes) {
    std::sort(ids_.begin(), ids_.end());
    std::uint32_t again = 0xFFFFFFFF;
    for (std::size_t i = 1; i < ids_.size(); ++i)
      if (ids_[i].first == ids_[i - 1].first) again = std::min(again, ids_[i].second);
    if (again == 0xFFFFFFFF) return;
    go_to(nodes, again, 0);
    fail(at, "an id that no other node has");
  }

  std::uint32_t index_of_neighbour(std::int64_t id, std::uint64_t k, const char* nodes) {
    if (ids_.empty()) {
      if (id >= 0 && static_cast<std::uint64_t>(id) < out_.points.size()) return static_cast<std::uint32_t>(id);
    } else {
      const auto found = std::lower_bound(ids_.begin(), ids_.end(), std::pair<std::int64_t, std::uint32_t>(id, 0));
      if (found != ids_.end() && found->first == id) return found->second;
    }
    const auto node = static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), k) - ends_.begin());
    go_to(nodes, node, 6 + k - (node == 0 ? 0 : ends_[node - 1]));
    fail(at, "a neighbour that is the id of a node");
  }

  /// Moves to a number of a node, for errors.
  void go_to(const char* nodes, std::size_t node, std::uint64_t number) {
    at = nodes;
    std::uint64_t words = number;
    for (std::size_t i = 0; i < node; ++i) words += 6 + ends_[i] - (i == 0 ? 0 : ends_[i - 1]);
    for (; words > 0; --words) {
      skip();
      word();
    }
    skip();
  }
};

}  // namespace concino::detail
