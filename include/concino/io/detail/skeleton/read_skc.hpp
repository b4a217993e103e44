// The reader of .skc, the format of curve skeletons by Dey and Sun 2006: points, and edges with numbers whose meaning
// is not documented.
#pragma once

#include <concino/io/detail/skeleton/skeleton_reader.hpp>

#include <cstdint>

namespace concino::detail {

class skc_reader : skeleton_reader {
 public:
  using skeleton_reader::skeleton_reader;

  void read() {
    const std::uint64_t verts = next_count("the number of verts", 6), edges = next_count("the number of edges", 12);
    out_.points.reserve(reservable(verts, 6));
    for (std::uint64_t i = 0; i < verts; ++i) {
      out_.points.push_back(next_point());
      report_progress();
    }
    out_.edges.reserve(reservable(edges, 12));
    for (std::uint64_t i = 0; i < edges; ++i) {
      const std::uint64_t a = next_vert(), b = next_vert();
      add_edge(a, b);
      for (int k = 0; k < 3; ++k) next_real("one of three numbers of an edge");
      const std::uint64_t n = next_count("the number of integers of an edge", 2);
      for (std::uint64_t k = 0; k < n; ++k) next_integer("an integer of an edge");
      report_progress();
    }
    if (edges != 0)
      report_.skipped.push_back(core::joined({"three numbers and a list of integers of each of ", edges, " edges"}));
    drop_superfluous_edges(out_.edges, false, report_);
    end_file("edge");
  }

 private:
  std::uint64_t next_vert() {
    skip();
    const char* const from = at;
    const std::int64_t i = integer("the index of a vert", 0);
    if (i < 0 || static_cast<std::uint64_t>(i) >= out_.points.size()) {
      if (out_.points.empty()) fail(from, "no edges, as there are no verts");
      fail(from, {"the index of a vert from 0 to ", out_.points.size() - 1});
    }
    return static_cast<std::uint64_t>(i);
  }
};

}  // namespace concino::detail
