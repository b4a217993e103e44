// Named properties as rows of bytes, a row for each element: what processes send each other of them.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/detail/mpi/mpi_bytes.hpp>
#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/property_set.hpp>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <typeinfo>
#include <vector>

namespace concino::detail {

/// The types of values that are sent: numbers, arrays of them as files have them, points and colours.
template<class... T>
inline constexpr const value_type* sent_types_of[] = {&values_of<T>...,
                                                      &values_of<std::array<T, 2>>...,
                                                      &values_of<std::array<T, 3>>...,
                                                      &values_of<std::array<T, 4>>...,
                                                      &values_of<std::array<T, 6>>...,
                                                      &values_of<std::array<T, 9>>...,
                                                      &values_of<bool>,
                                                      &values_of<vec3>,
                                                      &values_of<rgba>};
inline constexpr const auto& sent_types =
    sent_types_of<char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long,
                  long long, unsigned long long, float, double>;

/// The properties that are sent: those of verts, polys and the mesh with values of these types. The row of an element
/// has its values in the order of the list.
class sent_properties {
  struct entry {
    element_kind kind;
    std::uint32_t type;  // in sent_types
    property_rule rule;
    bool has_values;     // other than default ones
    std::string name;
  };
  std::vector<entry> all_;

  static bool has_values_in(const column& c) {
    const column defaults(c.operations(), 1);
    const auto* const values = static_cast<const char*>(c.data());
    const std::size_t size = c.operations().size;
    for (std::size_t i = 0; i < c.size(); ++i)
      if (std::memcmp(values + i * size, defaults.data(), size) != 0) return true;
    return false;
  }
  void add(const entry& e) {
    const auto same = std::find_if(all_.begin(), all_.end(),
                                   [&](const entry& o) { return o.kind == e.kind && o.name == e.name; });
    if (same == all_.end()) all_.push_back(e);
    else same->has_values = same->has_values || e.has_values;
  }

 public:
  /// Adds those of a mesh. Those of faces have no rows; remove_faces() removes them.
  void add(const property_set& properties, bool with_faces) {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      const property_info p = properties.info(i);
      const auto* const type = std::find_if(std::begin(sent_types), std::end(sent_types),
                                            [&](const value_type* t) { return *t->type == *p.type; });
      if (type == std::end(sent_types) || p.kind == element_kind::edge || p.kind == element_kind::corner) continue;
      if (p.kind == element_kind::face && !with_faces) continue;
      add({p.kind, static_cast<std::uint32_t>(type - std::begin(sent_types)), p.rule,
           with_faces && has_values_in(*properties.values(i)), p.name});
    }
  }

  std::vector<char> bytes() const {
    std::vector<std::uint32_t> numbers;
    std::vector<char> names;
    for (const entry& e : all_) {
      numbers.insert(numbers.end(), {static_cast<std::uint32_t>(e.kind), e.type, static_cast<std::uint32_t>(e.rule),
                                     e.has_values, static_cast<std::uint32_t>(e.name.size())});
      names.insert(names.end(), e.name.begin(), e.name.end());
    }
    byte_writer writer;
    writer.put(numbers);
    writer.put(names);
    return writer.bytes();
  }
  /// Adds those of another process, except those of the same kind and name.
  void add(const std::vector<char>& bytes) {
    byte_reader reader(bytes);
    std::vector<std::uint32_t> numbers;
    std::vector<char> names;
    reader.get(numbers);
    reader.get(names);
    const char* name = names.data();
    for (std::size_t k = 0; k < numbers.size(); name += numbers[k + 4], k += 5)
      add({static_cast<element_kind>(numbers[k]), numbers[k + 1], static_cast<property_rule>(numbers[k + 2]),
           numbers[k + 3] != 0, std::string(name, numbers[k + 4])});
  }
  /// Removes those of faces, and those of polys that have default values only and the name of one of faces: in slices
  /// without values of faces, VTK's values of all cells seem to be values of polys.
  void remove_faces() {
    const auto is_of_face = [&](const std::string& name) {
      return std::any_of(all_.begin(), all_.end(),
                         [&](const entry& e) { return e.kind == element_kind::face && e.name == name; });
    };
    std::vector<entry> kept;
    for (const entry& e : all_)
      if (e.kind != element_kind::face && (e.kind != element_kind::poly || e.has_values || !is_of_face(e.name)))
        kept.push_back(e);
    all_.swap(kept);
  }

  std::size_t row_size(element_kind kind) const {
    std::size_t size = 0;
    for (const entry& e : all_)
      if (e.kind == kind) size += sent_types[e.type]->size;
    return size;
  }
  /// Appends the rows of elements with these indices. Properties that are missing have default values.
  void append_rows(const property_set& from, element_kind kind, const std::vector<std::uint32_t>& indices,
                   std::vector<char>& rows) const {
    const std::size_t size = row_size(kind), before = rows.size();
    rows.resize(before + size * indices.size());
    char* to = rows.data() + before;
    for (const entry& e : all_) {
      if (e.kind != kind) continue;
      const value_type& type = *sent_types[e.type];
      const auto found = from.find(kind, e.name, type);
      const column defaults(type, 1);
      const auto* const values = static_cast<const char*>(found ? found->data() : defaults.data());
      for (std::size_t k = 0; k < indices.size(); ++k)
        std::memcpy(to + k * size, values + (found ? indices[k] : 0) * type.size, type.size);
      to += type.size;
    }
  }
  /// Adds the properties of a kind to those of a mesh; row i belongs to the element with index i.
  void store(const std::vector<char>& rows, element_kind kind, property_set& to) const {
    const std::size_t size = row_size(kind);
    const char* from = rows.data();
    for (const entry& e : all_) {
      if (e.kind != kind) continue;
      const value_type& type = *sent_types[e.type];
      const std::size_t n = rows.size() / size;
      auto* const values = static_cast<char*>(to.get(kind, e.name, type, n)->data());
      for (std::size_t k = 0; k < n; ++k) std::memcpy(values + k * type.size, from + k * size, type.size);
      to.set_rule(kind, e.name, e.rule);
      from += type.size;
    }
  }
};

/// The properties of the slices of all processes. Collective.
inline sent_properties joined_properties(MPI_Comm communicator, const sent_properties& own) {
  int size = 1;
  (MPI_Comm_size)(communicator, &size);
  std::vector<std::vector<char>> sent;
  on_all(communicator, [&] {
    sent.assign(static_cast<std::size_t>(size), own.bytes());
  });
  const auto received = all_to_all(communicator, sent);
  sent_properties all;
  on_all(communicator, [&] {
    for (const std::vector<char>& bytes : received) all.add(bytes);
    all.remove_faces();
  });
  return all;
}

/// The indices from 0 to n - 1.
inline std::vector<std::uint32_t> indices_below(std::size_t n) {
  std::vector<std::uint32_t> r(n);
  std::iota(r.begin(), r.end(), 0u);
  return r;
}

}  // namespace concino::detail
