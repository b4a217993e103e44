// The reader of .cg, the format of curve skeletons by Tagliasacchi et al. 2012: lines of verts and edges.
#pragma once

#include <concino/io/detail/skeleton/skeleton_reader.hpp>
#include <concino/io/detail/text/characters.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace concino::detail {

class cg_reader : skeleton_reader {
  bool has_counts_ = false;
  std::uint64_t num_verts_ = 0, num_edges_ = 0, num_radii_ = 0, num_unknown_ = 0;
  std::uint64_t low_ = ~std::uint64_t{0}, high_ = 0;  // of the indices of edges

 public:
  using skeleton_reader::skeleton_reader;

  void read() {
    for (skip(); !at_end(); skip()) {
      const char* const from = at;
      if (*at == '#') {
        read_comment();
      } else if (const std::string_view keyword = word(); keyword == "v") {
        read_vert();
      } else if (keyword == "e") {
        read_edge();
      } else if (is_letter(*from)) {
        ++num_unknown_;
        skip_line();
      } else {
        fail(from, "v x y z or e i j");
      }
      report_progress();
    }
    if (out_.points.empty() && !has_counts_) fail(end(), "v x y z");
    check_counts();
    if (num_radii_ == 0) out_.radii.clear();
    else if (num_radii_ != out_.points.size())
      report_.notes.push_back(
          core::joined({out_.points.size() - num_radii_, " verts have no radius in the file; it was set to 0"}));
    number_from_0();
    drop_superfluous_edges(out_.edges, false, report_);
    if (num_unknown_)
      report_.skipped.push_back(core::joined({num_unknown_, " lines that are neither verts nor edges"}));
  }

 private:
  /// # D:3 NV:<verts> NE:<edges>, or any comment.
  void read_comment() {
    const char* const from = at;
    skip_line();
    const std::string_view line(from, static_cast<std::size_t>(at - from));
    has_counts_ = has_counts_ || (read_count(line, "NV:", num_verts_) && read_count(line, "NE:", num_edges_));
  }
  static bool read_count(std::string_view line, std::string_view key, std::uint64_t& n) {
    const std::size_t i = line.find(key);
    std::int64_t x = 0;
    if (i == line.npos || !parse_integer(line.data() + i + key.size(), line.data() + line.size(), x) || x < 0)
      return false;
    n = static_cast<std::uint64_t>(x);
    return true;
  }

  bool line_continues() {
    while (!at_end() && is_blank(*at)) ++at;
    return !at_end() && !is_line_end(*at) && *at != '#';
  }
  void end_line(const char* expected) {
    if (line_continues()) fail(at, expected);
  }

  void read_vert() {
    if (out_.points.size() == max_count) fail_to_count("verts");
    double x[3];
    for (double& c : x) {
      if (!line_continues()) fail(at, "x y z of a vert in one line");
      c = real("a coordinate of a vert");
    }
    out_.points.push_back({x[0], x[1], x[2]});
    double radius = 0;
    if (line_continues()) {
      radius = real("the radius of a vert");
      ++num_radii_;
    }
    out_.radii.push_back(radius);
    end_line("the end of the line after x y z and the radius");
  }

  void read_edge() {
    std::uint64_t ends[2];
    for (std::uint64_t& i : ends) {
      if (!line_continues()) fail(at, "the two verts of an edge in one line");
      const char* const from = at;
      const std::int64_t x = integer("the index of a vert");
      if (x < 0 || x > static_cast<std::int64_t>(max_count)) fail(from, "the index of a vert, at least 0");
      i = static_cast<std::uint64_t>(x);
      low_ = std::min(low_, i);
      high_ = std::max(high_, i);
    }
    add_edge(ends[0], ends[1]);
    end_line("the end of the line after the two verts of an edge");
  }

  void check_counts() {
    if (!has_counts_) return;
    const std::uint64_t v = out_.points.size(), e = out_.edges.size();
    if (v < num_verts_ || e < num_edges_)
      fail(end(), {num_verts_, " verts and ", num_edges_, " edges, as the file states"},
           {v, " verts and ", e, " edges, and then the end of the file"});
    if (v != num_verts_ || e != num_edges_)
      report_.notes.push_back(core::joined(
          {"the file states ", num_verts_, " verts and ", num_edges_, " edges, but has ", v, " and ", e}));
  }

  void number_from_0() {
    if (out_.edges.empty()) return;
    const std::uint64_t n = out_.points.size(), base = low_ == 0 ? 0 : 1;
    if (high_ >= n + base) fail_at_edge(n, base);
    if (base == 0) return;
    if (high_ < n) report_.notes.push_back("no edge has the index 0: indices were read as beginning at 1");
    for (auto& edge : out_.edges)
      for (vert_id& v : edge) v = vert_id{v.raw() - 1};
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_at_edge(std::uint64_t n, std::uint64_t base) {
    const auto is_wrong = [&](const std::array<vert_id, 2>& edge) {
      return edge[0].raw() >= n + base || edge[1].raw() >= n + base;
    };
    auto k = std::find_if(out_.edges.begin(), out_.edges.end(), is_wrong) - out_.edges.begin();
    at = begin();
    for (skip();; skip()) {
      const char* const from = at;
      if (*at != '#' && word() == "e" && k-- == 0) {
        if (n == 0) fail(from, "no edges, as there are no verts");
        fail(from, {"an edge between verts from ", base, " to ", n - 1 + base});
      }
      skip_line();
    }
  }
};

}  // namespace concino::detail
