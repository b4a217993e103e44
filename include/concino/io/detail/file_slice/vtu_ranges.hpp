// Reads parts of the arrays of a .vtu file with one piece.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_xml_tags.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

class vtu_ranges : protected vtk_xml_data {
 protected:
  struct run {
    std::uint64_t first, count;
  };
  using runs = std::vector<run>;

  vtk_xml_index index_;
  const vtk_xml_piece* piece_ = nullptr;

  explicit vtu_ranges(const read_context& in) : vtk_xml_data(in) {}
  ~vtu_ranges() = default;

  static std::size_t size_of(const vtk_xml_array& a) { return vtk_names_of(a.type).size; }

  const vtk_xml_array* find(std::string_view name) const {
    for (const vtk_xml_entry& e : index_.entries)
      if (e.part == vtk_xml_part::cells && e.array.name == name) return &e.array;
    return nullptr;
  }
  const vtk_xml_array& need(std::string_view name) const {
    const vtk_xml_array* const a = find(name);
    if (!a) fail(piece_->at, {"the array \"", name, "\""}, {"a piece without it"});
    return *a;
  }

  /// Appends some numbers of an array, as integers.
  void append_integers(const vtk_xml_array& a, std::uint64_t first, std::uint64_t count,
                       std::vector<std::int64_t>& to) {
    if (a.type == vtk_number::float32 || a.type == vtk_number::float64)
      fail(a.at, {"integers"}, {"reals in the array \"", a.name, "\""});
    std::string bytes;
    append_numbers(a, size_of(a), first, count, bytes);
    to.resize(to.size() + count);
    convert(a.type, reinterpret_cast<const unsigned char*>(bytes.data()), count, to.data() + (to.size() - count));
  }

  /// Adds an element to runs, which takes all up to `gap` elements before it along. Runs are short, so that what is
  /// read of one takes little memory.
  static void add(runs& all, std::uint64_t element, std::uint64_t gap) {
    if (!all.empty() && all.back().count < 4096 && element - (all.back().first + all.back().count) <= gap)
      all.back().count = element + 1 - all.back().first;
    else all.push_back({element, 1});
  }

  /// Where the lists of the cells of a run begin and end, in an array of such ends.
  std::vector<std::int64_t> ends_of(const vtk_xml_array& a, const run& r) {
    std::vector<std::int64_t> all(r.first == 0 ? 1 : 0);
    append_integers(a, r.first == 0 ? 0 : r.first - 1, r.count + (r.first == 0 ? 0 : 1), all);
    return all;
  }
  /// Checks that ends do not decrease, beginning with the last end before them, which becomes the last one of these.
  void check_ends(const vtk_xml_array& a, const std::vector<std::int64_t>& all, std::uint64_t bound,
                  std::int64_t& last) const {
    for (const std::int64_t end : all) {
      if (end < last || static_cast<std::uint64_t>(end) > bound)
        fail_array(a, {"ends that do not decrease, up to ", bound}, {end, " after ", last});
      last = end;
    }
  }
};

}  // namespace concino::detail
