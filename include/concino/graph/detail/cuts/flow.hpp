// Minimum cuts of networks with integer capacities, which min_cut and segment_polys fill.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Two opposite arcs between two nodes.
struct flow_edge {
  std::uint32_t a, b;
  std::int64_t forth, back;  // the capacities of a -> b and of b -> a, 0 or more
};

/// Nodes between a source and a sink. Capacities are so small that sums of all of them are below 2^62.
struct flow_network {
  std::vector<std::int64_t> terminals;  // by node: the capacity from the source, or minus that to the sink
  std::vector<flow_edge> edges;
};

/// A minimum cut by maximum flow.
/// Needs:  some cut without unlimited arcs.
/// Result: by node, whether it is on the source's side. Of all minimum cuts it is the one with the fewest nodes there:
///         those that the source reaches in the residual network.
/// Errors: unsupported if there are 2^32 arcs or more. `caller` begins the message.
/// Source: Boykov, Kolmogorov 2004, "An experimental comparison of min-cut/max-flow algorithms", by Boost.Graph.
std::vector<unsigned char> source_side(const flow_network& network, const char* caller);

/// A node joined to the sink that the source reaches by arcs of at least this capacity, or the number of nodes if there
/// is none.
std::size_t end_of_unlimited_path(const flow_network& network, std::int64_t capacity);

/// Capacities as 64-bit integers: capacity times 2^exponent, rounded.
struct integer_scale {
  int exponent = 0;

  /// The largest scale for which the sum of integers stays below 2^60.
  /// Needs:  finite values of 0 or more, which are given twice, in the same order.
  class sum {
    double largest_ = 0, total_ = 0;

   public:
    void raise_largest(double value) { largest_ = value > largest_ ? value : largest_; }
    void add(double value) { total_ += largest_ > 0 ? value / largest_ : 0; }
    integer_scale scale() const;
  };

  std::int64_t operator()(double value) const;
  double back(std::int64_t integer) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/graph/detail/cuts/flow.ipp>
#endif
