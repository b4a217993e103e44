// Reads the nodes of Gmsh files of versions 2 and 4.1.
#pragma once

#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/detail/gmsh/gmsh_groups_reader.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

class gmsh_nodes_reader : protected gmsh_groups_reader {
  std::uint64_t num_parametric_ = 0;

 protected:
  bool has_nodes_ = false;

  using gmsh_groups_reader::gmsh_groups_reader;

  void nodes() {
    const char* const from = at;
    if (is_version_4_) nodes_of_version_4();
    else nodes_of_version_2();
    end_section("Nodes");
    has_nodes_ = true;
    grid_.node_tags.finish();
    std::uint64_t tag = 0;
    if (grid_.node_tags.has_repeated(tag)) reject(from, {"nodes of different tags"}, {"tag ", tag, " twice"});
  }

  /// Reads the tag of a node.
  vert_id take_node() {
    const char* const from = place();
    const std::uint64_t tag = take_size("the tag of a node");
    const std::uint32_t v = grid_.node_tags.find(tag);
    if (v == gmsh_tags::none || v >= grid_.points.size()) reject(from, {"the tag of a node in $Nodes"}, {tag});
    return vert_id{v};
  }

  void report_nodes() {
    if (num_parametric_)
      report_.skipped.push_back(core::joined({"the parameters of ", num_parametric_, " nodes on entities"}));
  }

 private:
  void add_node(std::uint64_t tag) {
    grid_.node_tags.add(tag, static_cast<std::uint32_t>(grid_.points.size()));
    grid_.points.emplace_back();
  }
  void point(vec3& p) {
    for (double* const x : {&p.x, &p.y, &p.z}) {
      const char* const from = place();
      *x = take_real("a coordinate of a node");
      if (!std::isfinite(*x)) reject(from, {"a coordinate of a node, a finite number"});
    }
    report_progress();
  }

  void nodes_of_version_2() {
    const std::uint64_t n = text_count("the number of nodes");
    begin_numbers();
    reserve_nodes(n, 4, 28);
    for (std::uint64_t i = 0; i < n; ++i) {
      add_node(take_size("the tag of a node"));
      point(grid_.points.back());
    }
  }
  void reserve_nodes(std::uint64_t n, std::uint64_t numbers, std::uint64_t bytes) {
    check_count(at, n, numbers, bytes);
    if (grid_.points.size() + n > max_ids) fail_to_count("nodes");
    grid_.points.reserve(grid_.points.size() + n);
  }

  void nodes_of_version_4() {
    begin_numbers();
    const std::uint64_t blocks = take_size("the number of blocks of nodes");
    const char* const from = place();
    const std::uint64_t total = take_size("the number of nodes");
    take_size("the smallest tag of a node");
    take_size("the largest tag of a node");
    reserve_nodes(total, 4, bytes_of_size() + 24);
    std::uint64_t left_nodes = total;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const int dimension = take_int("the dimension of an entity");
      take_int("the tag of an entity");
      const bool is_parametric = take_int("whether nodes have parameters, 0 or 1") != 0;
      const char* const count = place();
      const std::uint64_t n = take_size("the number of nodes of a block");
      if (n > left_nodes) reject(count, {"at most ", left_nodes, " nodes, as the section has ", total}, {n});
      left_nodes -= n;
      const std::size_t first = grid_.points.size();
      for (std::uint64_t i = 0; i < n; ++i) add_node(take_size("the tag of a node"));
      for (std::uint64_t i = 0; i < n; ++i) {
        point(grid_.points[first + i]);
        for (int k = 0; is_parametric && k < std::min(dimension, 3); ++k) take_real("a parameter of a node");
      }
      if (is_parametric && dimension > 0) num_parametric_ += n;
    }
    if (left_nodes) reject(from, {"the number of nodes, ", total - left_nodes}, {total});
  }
};

}  // namespace concino::detail
