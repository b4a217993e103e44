// What readers of MEDIT files collect besides cells and verts: polygons, references of faces and edges, and marks.
#pragma once

#include <concino/io/detail/formats/contents.hpp>

#include <algorithm>
#include <cstring>
#include <vector>

namespace concino::detail {

/// Numbers of elements by the rows of the sections that list them, which may be several of the same name.
class row_numbers {
  struct run {
    std::uint64_t first_row;
    std::uint32_t first_element;
  };
  std::vector<run> runs_;
  std::uint64_t rows_ = 0;

 public:
  std::uint64_t size() const { return rows_; }
  void add(std::uint64_t rows, std::size_t first_element) {
    if (rows == 0) return;
    runs_.push_back({rows_, static_cast<std::uint32_t>(first_element)});
    rows_ += rows;
  }
  std::uint32_t operator[](std::uint64_t row) const {
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), row,
                                        [](std::uint64_t r, const run& x) { return r < x.first_row; });
    const run& r = *(after - 1);
    return r.first_element + static_cast<std::uint32_t>(row - r.first_row);
  }
};

/// Integers of elements, which become properties.
class medit_marks {
  struct column {
    element_kind kind;
    const char* name;
    std::vector<int> values;  // those at the end that are 0 may be missing
  };
  std::vector<column> columns_;

 public:
  /// Sets a value of an element. Values are stored only if one of them is not zero.
  void set(element_kind kind, const char* name, std::size_t element, int value) {
    if (value == 0) return;
    auto c = std::find_if(columns_.begin(), columns_.end(),
                          [&](const column& x) { return x.kind == kind && std::string_view(x.name) == name; });
    if (c == columns_.end()) c = columns_.insert(columns_.end(), column{kind, name, {}});
    if (c->values.size() <= element) c->values.resize(element + 1);
    c->values[element] = value;
  }

  /// Adds the properties of n elements of a kind to the contents. Elements that are there only because the file lists
  /// them have nothing but zeros: to be written again they need "entity", a 1 at each.
  void store(element_kind kind, std::size_t n, bool are_listed, file_contents& out) {
    if (are_listed) {
      std::vector<bool> has_value(n);
      for (const column& c : columns_)
        for (std::size_t i = 0; c.kind == kind && i < c.values.size(); ++i)
          if (c.values[i] != 0) has_value[i] = true;
      if (std::find(has_value.begin(), has_value.end(), false) != has_value.end())
        std::fill_n(out.add_property<int>(kind, "entity", n), n, 1);
    }
    for (const column& c : columns_)
      if (c.kind == kind) std::copy(c.values.begin(), c.values.end(), out.add_property<int>(kind, c.name, n));
  }
};

/// Collects the polygons of a surface.
class medit_polygons {
  surface_arrays surface_;
  std::uint32_t arity_ = 0;  // of the polygons, as long as they have the same

 public:
  std::size_t size_of_lists() const { return surface_.verts.size(); }
  void reserve(std::size_t more) { surface_.verts.reserve(surface_.verts.size() + more); }
  void add(const vert_id* corners, std::uint32_t n) {
    const std::size_t first = surface_.verts.size();
    surface_.verts.insert(surface_.verts.end(), corners, corners + n);
    end_poly(surface_, arity_, first);
  }
  /// `wanted` is the arity of a surface without polygons.
  surface_arrays finish(std::vector<vec3>&& points, std::uint32_t wanted) && {
    surface_.points = std::move(points);
    if (surface_.offsets.empty()) surface_.arity = surface_.verts.empty() ? wanted : arity_;
    if (surface_.offsets.empty() && surface_.arity == 0) surface_.offsets.push_back(0);
    return std::move(surface_);
  }
};

}  // namespace concino::detail
