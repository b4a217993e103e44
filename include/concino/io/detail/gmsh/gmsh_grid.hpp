// The contents of a Gmsh file: nodes, elements of all dimensions, names of groups, values.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/detail/gmsh/gmsh_tags.hpp>
#include <concino/io/detail/gmsh/gmsh_types.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::detail {

/// Elements that follow each other in the file, of one type, entity and label.
struct gmsh_run {
  gmsh_type type;
  int entity = 0, label = 0;
  std::size_t first = 0, first_vert = 0;  // its first element, and the first of its corners
  const char* at = nullptr;               // where the first one is in the file
  std::uint64_t stride = 0;               // the number of numbers, or in binary files of bytes, of each

  bool is_like(const gmsh_run& r) const {
    return type.shape == r.type.shape && type.nodes == r.type.nodes && entity == r.entity;
  }
};

/// The name of a group of elements of one dimension.
struct gmsh_group {
  int dimension, label;
  std::string name;
};

/// Values of nodes or elements; 0 where the file has none, and after the last one.
struct gmsh_values {
  bool of_nodes;
  std::string name;
  std::int64_t step;  // of time
  std::size_t components;
  std::vector<double> values = {};
  std::vector<bool> is_set = {};  // of each node or element
  bool has_dimension[4] = {};     // whether an element of this dimension has a value in the file
};

struct gmsh_grid {
  std::vector<vec3> points;
  gmsh_tags node_tags, element_tags;
  std::vector<vert_id> verts;  // the corners of all elements
  std::vector<gmsh_run> runs;
  std::size_t num_elements = 0;
  std::uint64_t num_repeated = 0;  // elements that were listed again for another group
  std::vector<gmsh_group> groups;
  std::vector<gmsh_values> values;

  /// Adds an element. As files of version 2 list an element once for each of its groups, one that equals the last one
  /// but for its label is not added again.
  void add(gmsh_run r, std::uint64_t tag, const vert_id* corners, bool may_repeat) {
    const unsigned n = r.type.corners();
    const bool extends = !runs.empty() && runs.back().is_like(r);
    if (extends && may_repeat && runs.back().label != r.label && std::equal(corners, corners + n, verts.end() - n)) {
      ++num_repeated;
      element_tags.add(tag, static_cast<std::uint32_t>(num_elements - 1));
      return;
    }
    if (!extends || runs.back().label != r.label || runs.back().stride != r.stride) {
      r.first = num_elements;
      r.first_vert = verts.size();
      runs.push_back(r);
    }
    verts.insert(verts.end(), corners, corners + n);
    element_tags.add(tag, static_cast<std::uint32_t>(num_elements++));
  }

  /// The number of elements of a run.
  std::size_t size_of(std::size_t run) const {
    return (run + 1 < runs.size() ? runs[run + 1].first : num_elements) - runs[run].first;
  }
  /// Calls f(element, its run, its corners) for all elements of one dimension.
  template<class F>
  void for_each(int dimension, const F& f) const {
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (runs[r].type.dimension() != dimension) continue;
      const vert_id* v = verts.data() + runs[r].first_vert;
      for (std::size_t i = 0, n = size_of(r); i < n; ++i, v += runs[r].type.corners()) f(runs[r].first + i, runs[r], v);
    }
  }
  std::size_t num_of(int dimension) const {
    std::size_t n = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) n += runs[r].type.dimension() == dimension ? size_of(r) : 0;
    return n;
  }
};

}  // namespace concino::detail
