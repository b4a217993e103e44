// Reads the elements of Gmsh files of versions 2 and 4.1.
#pragma once

#include <concino/io/detail/cells/element_nodes.hpp>
#include <concino/io/detail/gmsh/gmsh_nodes_reader.hpp>

namespace concino::detail {

class gmsh_elements_reader : protected gmsh_nodes_reader {
  bool corners_only_;
  std::uint64_t num_high_order_lines_ = 0, num_high_order_ = 0;
  std::int64_t first_high_order_ = 0;  // its type
  std::vector<vert_id> of_element_;

 protected:
  element_nodes nodes_;  // of elements of second or higher order
  bool has_elements_ = false;

  explicit gmsh_elements_reader(const read_context& c) : gmsh_nodes_reader(c), corners_only_(c.corners_only) {}

  void elements() {
    if (!has_nodes_) reject(at, {"$Nodes before $Elements"});
    if (is_version_4_) elements_of_version_4();
    else elements_of_version_2();
    end_section("Elements");
    has_elements_ = true;
    grid_.element_tags.finish();
  }

  /// Errors: unsupported for elements of second or higher order, but for lines, which are skipped.
  void finish_elements() {
    report_entities();
    report_nodes();
    if (num_high_order_lines_)
      report_.skipped.push_back(core::joined({num_high_order_lines_, " lines of second or higher order"}));
    if (grid_.num_repeated)
      report_.skipped.push_back(core::joined({grid_.num_repeated,
                                              " elements that are listed again for another "
                                              "physical group: \"label\" is the first one"}));
    if (num_high_order_ == 0) return;
    const gmsh_type t = gmsh_type_of(first_high_order_);
    const bool is_second =
        (first_high_order_ >= 8 && first_high_order_ <= 14) || (first_high_order_ >= 16 && first_high_order_ <= 19);
    core::throw_joined<unsupported>({name(), ": $Elements has ", num_high_order_,
                                     is_second ? " second-order" : " higher-order",
                                     " elements, with nodes on edges, the first of type ", first_high_order_, ", a ",
                                     t.name(), " of ", t.nodes, " nodes; ", read_corners_instead});
  }

  /// Where element e is in the file.
  const char* place_of(std::size_t e) {
    const auto after = std::upper_bound(grid_.runs.begin(), grid_.runs.end(), e,
                                        [](std::size_t i, const gmsh_run& r) { return i < r.first; });
    const gmsh_run& r = *(after - 1);
    at = r.at;
    if (binary_) return at + (e - r.first) * r.stride;
    for (std::uint64_t n = (e - r.first) * r.stride; n > 0; --n) skip(), word();
    return place();
  }

 private:
  gmsh_type take_type(std::int64_t& number) {
    const char* const from = place();
    number = take_int("the type of an element");
    const gmsh_type t = gmsh_type_of(number);
    if (t.shape != gmsh_shape::none) return t;
    core::throw_joined<unsupported>(
        {name(), ": elements of type ", number,
         number == 34   ? " (polygons)"
         : number == 35 ? " (polyhedra)"
                        : "",
         ", the first ", describe_place(from),
         ", are not supported: points, lines, triangles, quads, tets, hexes, prisms and pyramids are"});
  }

  /// Reads the nodes of an element, and adds it.
  void element(const gmsh_run& r, std::int64_t number, std::uint64_t tag) {
    vert_id corners[8];
    const unsigned n = r.type.corners();
    for (unsigned k = 0; k < n; ++k) corners[k] = take_node();
    of_element_.clear();
    for (unsigned k = n; k < r.type.nodes; ++k) of_element_.push_back(take_node());
    report_progress();
    if (!of_element_.empty()) {
      if (corners_only_) {
        nodes_.add(of_element_.data(), of_element_.size());
      } else if (r.type.shape == gmsh_shape::line) {
        ++num_high_order_lines_;
        return;
      } else if (num_high_order_++ == 0) {
        first_high_order_ = number;
      }
    }
    if (grid_.num_elements >= max_ids) fail_to_count("elements");
    grid_.add(r, tag, corners, !is_version_4_);
  }
  void elements_of_version_4() {
    begin_numbers();
    const std::uint64_t blocks = take_size("the number of blocks of elements");
    const char* const from = place();
    const std::uint64_t total = take_size("the number of elements");
    take_size("the smallest tag of an element");
    take_size("the largest tag of an element");
    check_count(from, total, 2, 2 * bytes_of_size());
    std::uint64_t left_elements = total;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const char* const block = place();
      const int dimension = take_int("the dimension of an entity");
      const int tag = take_int("the tag of an entity");
      gmsh_run r;
      std::int64_t number = 0;
      r.type = take_type(number);
      if (r.type.dimension() != dimension)
        reject(block, {"dimension ", r.type.dimension(), ", that of elements of type ", number}, {dimension});
      const char* const count = place();
      const std::uint64_t n = take_size("the number of elements of a block");
      if (n > left_elements) reject(count, {"at most ", left_elements, " elements, as the section has ", total}, {n});
      left_elements -= n;
      const gmsh_entity e = find_entity(dimension, tag);
      if (e.num_groups > 1) num_several_ += n;
      if (e.is_reversed) num_reversed_ += n;
      if (e.is_partition) num_partitioned_ += n;
      r.entity = e.original;
      r.label = e.label;
      r.stride = (1 + std::uint64_t{r.type.nodes}) * (binary_ ? bytes_of_size() : 1);
      check_count(count, n, 1 + std::uint64_t{r.type.nodes}, (1 + std::uint64_t{r.type.nodes}) * bytes_of_size());
      for (std::uint64_t i = 0; i < n; ++i) {
        r.at = place();
        element(r, number, take_size("the tag of an element"));
      }
    }
    if (left_elements) reject(from, {"the number of elements, ", total - left_elements}, {total});
  }

  void elements_of_version_2() {
    const std::uint64_t total = text_count("the number of elements");
    begin_numbers();
    check_count(at, total, 4, 8);
    for (std::uint64_t i = 0; i < total;) {
      const char* from = place();
      // in text files each element has a header, with its tag first
      std::uint64_t tag = binary_ ? 0 : take_size("the tag of an element"), n = 1;
      gmsh_run r;
      std::int64_t number = 0;
      r.type = take_type(number);
      if (binary_) {
        const char* const count = at;
        n = take_size("the number of elements of a block");
        if (n > total - i) reject(count, {"at most ", total - i, " elements, as the section has ", total}, {n});
      }
      const char* const count = place();
      const std::uint64_t tags = take_size("the number of tags of an element");
      const std::uint64_t numbers = 1 + tags + r.type.nodes;
      if (tags > left()) reject(count, {"a number of tags that fits into the file"}, {tags});
      check_count(count, n, numbers - !binary_, 4 * numbers);
      r.stride = binary_ ? 4 * numbers : 2 + numbers;
      for (std::uint64_t k = 0; k < n; ++k, ++i) {
        if (binary_) {
          from = at;
          tag = take_size("the tag of an element");
        }
        r.at = from;
        read_tags(r, tags);
        element(r, number, tag);
      }
    }
  }
  /// The physical group, the entity, and then partitions.
  void read_tags(gmsh_run& r, std::uint64_t tags) {
    for (std::uint64_t k = 0; k < tags; ++k) {
      const int tag = take_int("a tag of an element");
      if (k == 0) r.label = tag;
      if (k == 1) r.entity = tag;
    }
    if (tags > 2) ++num_partitioned_;
  }
};

}  // namespace concino::detail
