// Reads the names of groups and the entities of Gmsh files.
#pragma once

#include <concino/io/detail/gmsh/gmsh_cursor.hpp>
#include <concino/io/detail/gmsh/gmsh_grid.hpp>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace concino::detail {

/// An entity of the geometry, to which elements of version 4.1 belong.
struct gmsh_entity {
  int dimension, tag;
  int original;   // its tag, or of an entity of a partition that of the entity that was divided
  int label = 0;  // its first group; 0: none
  std::uint64_t num_groups = 0;
  bool is_reversed = false;  // in the group
  bool is_partition = false;
};

class gmsh_groups_reader : protected gmsh_cursor {
  std::vector<gmsh_entity> entities_;
  std::uint64_t num_bounds_ = 0;
  bool is_sorted_ = true;

 protected:
  gmsh_grid grid_;
  std::uint64_t num_several_ = 0, num_reversed_ = 0, num_partitioned_ = 0;  // elements

  explicit gmsh_groups_reader(const read_context& c) : gmsh_cursor(c) {}

  void physical_names() {
    const std::uint64_t n = text_count("the number of names");
    check_count(at, n, 3, 6);
    for (std::uint64_t i = 0; i < n; ++i) {
      gmsh_group g{};
      skip();
      const char* const from = at;
      const std::int64_t dimension = text_number("the dimension of a group, 0 to 3");
      if (dimension < 0 || dimension > 3) reject(from, {"the dimension of a group, 0 to 3"});
      g.dimension = static_cast<int>(dimension);
      skip();
      const char* const tag = at;
      const std::int64_t label = text_number("the tag of a group");
      if (label != static_cast<int>(label)) reject(tag, {"the tag of a group, of 32 bits"});
      g.label = static_cast<int>(label);
      skip();
      if (at_end() || *at == '$') reject(at, {"the name of a group"});
      g.name = quoted_text();
      grid_.groups.push_back(std::move(g));
      report_progress();
    }
    end_section("PhysicalNames");
  }

  /// Reads $Entities, or $PartitionedEntities, whose entities are parts of others.
  void entities(bool are_partitions) {
    begin_numbers();
    if (are_partitions) {
      take_size("the number of partitions");
      const char* const from = place();
      const std::uint64_t ghosts = take_size("the number of ghost entities");
      check_count(from, ghosts, 2, 8);
      for (std::uint64_t i = 0; i < 2 * ghosts; ++i) take_int("the tag of a ghost entity or its partition");
    }
    std::uint64_t count[4];
    const char* const from = place();
    for (std::uint64_t& n : count) n = take_size("the number of entities of a dimension");
    for (int d = 0; d < 4; ++d) {
      check_count(from, count[d], 5, 4 + 3 * 8 + bytes_of_size());
      for (; count[d] > 0; --count[d]) entity(d, are_partitions);
    }
    end_section(are_partitions ? "PartitionedEntities" : "Entities");
    is_sorted_ = false;
  }

  /// The entity of a block of elements; one without groups if the file lists none.
  gmsh_entity find_entity(int dimension, int tag) {
    const auto is_before = [](const gmsh_entity& a, const gmsh_entity& b) {
      return std::pair{a.dimension, a.tag} < std::pair{b.dimension, b.tag};
    };
    if (!std::exchange(is_sorted_, true)) std::stable_sort(entities_.begin(), entities_.end(), is_before);
    const gmsh_entity wanted{dimension, tag, tag};
    const auto found = std::lower_bound(entities_.begin(), entities_.end(), wanted, is_before);
    return found != entities_.end() && !is_before(wanted, *found) ? *found : wanted;
  }

  void report_entities() {
    if (num_bounds_)
      report_.skipped.push_back(core::joined({"section Entities: which ones bound others, ", num_bounds_, " tags"}));
    if (num_several_)
      report_.skipped.push_back(
          core::joined({"more than one physical group of ", num_several_, " elements: \"label\" is the first one"}));
    if (num_reversed_)
      report_.notes.push_back(core::joined({"the physical groups of ", num_reversed_,
                                            " elements contain them in the other direction, with a negative tag: "
                                            "\"label\" is positive, and they keep the direction that they have"}));
    if (num_partitioned_) report_.skipped.push_back(core::joined({"partitions of ", num_partitioned_, " elements"}));
  }

 private:
  /// Reads a number of integers.
  std::uint64_t count_of_ints(const char* what) {
    const char* const from = place();
    const std::uint64_t n = take_size(what);
    check_count(from, n, 1, 4);
    return n;
  }

  void entity(int dimension, bool is_partition) {
    gmsh_entity e{dimension, take_int("the tag of an entity"), 0};
    e.original = e.tag;
    e.is_partition = is_partition;
    if (is_partition) {
      const int parent_dimension = take_int("the dimension of an entity");
      const int parent = take_int("the tag of an entity");
      if (parent_dimension == dimension) e.original = parent;
      for (std::uint64_t n = count_of_ints("the number of partitions"); n > 0; --n) take_int("the tag of a partition");
    }
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) take_real("a coordinate of an entity");
    e.num_groups = count_of_ints("the number of physical groups");
    for (std::uint64_t i = 0; i < e.num_groups; ++i) {
      const int group = take_int("the tag of a physical group");
      if (i > 0) continue;
      e.is_reversed = group < 0;
      e.label = e.is_reversed ? static_cast<int>(0u - static_cast<unsigned>(group)) : group;
    }
    if (dimension > 0) {
      const std::uint64_t n = count_of_ints("the number of entities that bound another");
      for (std::uint64_t i = 0; i < n; ++i) take_int("the tag of an entity");
      num_bounds_ += n;
    }
    entities_.push_back(e);
    report_progress();
  }
};

}  // namespace concino::detail
