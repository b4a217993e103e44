// The set of properties of a mesh; see property_set.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/property_set.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#if __has_include(<cxxabi.h>)
#include <cxxabi.h>
#endif

namespace concino {

namespace detail {

/// The type as it is written in C++, where the compiler can say it; for messages.
CONCINO_INLINE std::string written_type(const std::type_info& type) {
  if (type == typeid(std::string)) return "std::string";
#if __has_include(<cxxabi.h>)
  const std::unique_ptr<char, void (*)(void*)> text(abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr),
                                                    std::free);
  if (text) return text.get();
#endif
  return type.name();
}

/// Whether the values of n elements stay where they are.
CONCINO_INLINE bool is_identity(const element_origins& origins, std::size_t n) {
  if (origins.size() != n) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (origins.only(i) != i) return false;
  return true;
}

}  // namespace detail

CONCINO_INLINE property_set::property_set() = default;
CONCINO_INLINE property_set::property_set(property_set&&) noexcept = default;
CONCINO_INLINE property_set::~property_set() = default;

CONCINO_INLINE property_set::property_set(const property_set& o) : entries_(o.entries_) {
  for (entry& e : entries_) e.values.reset(new detail::column(*e.values));
}

CONCINO_INLINE property_set& property_set::operator=(property_set o) noexcept {
  entries_.swap(o.entries_);
  return *this;
}

CONCINO_INLINE std::shared_ptr<detail::column> property_set::get(element_kind kind, std::string_view name,
                                                                 const detail::value_type& type, std::size_t n) {
  if (auto found = find(kind, name, type)) return found;
  std::shared_ptr<detail::column> fresh(new detail::column(type, n));
  entries_.push_back({kind, std::string(name), fresh});
  return fresh;
}

CONCINO_INLINE std::shared_ptr<detail::column> property_set::find(element_kind kind, std::string_view name,
                                                                  const detail::value_type& type) const {
  for (const entry& e : entries_) {
    if (e.kind != kind || e.name != name) continue;
    if (e.values->type() != *type.type)
      core::throw_joined<invalid_argument>({to_string(kind), "_property: the property \"", e.name,
                                            "\" holds values of type ", detail::written_type(e.values->type()),
                                            ", not ", detail::written_type(*type.type),
                                            "; use another name or remove it first"});
    return e.values;
  }
  return nullptr;
}

CONCINO_INLINE const void* property_set::values_if_any(element_kind kind, std::string_view name,
                                                       const std::type_info& type) const {
  for (const entry& e : entries_)
    if (e.kind == kind && e.name == name && e.values->type() == type) return e.values->data();
  return nullptr;
}

CONCINO_INLINE bool property_set::remove(element_kind kind, std::string_view name) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].kind != kind || entries_[i].name != name) continue;
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  }
  return false;
}

CONCINO_INLINE bool property_set::has(element_kind kind) const {
  for (const entry& e : entries_)
    if (e.kind == kind) return true;
  return false;
}

CONCINO_INLINE void property_set::set_rule(element_kind kind, std::string_view name, property_rule rule) {
  for (const entry& e : entries_) {
    if (e.kind != kind || e.name != name) continue;
    if (!e.values->set_rule(rule))
      core::throw_joined<invalid_argument>({"set_property_rule: ", to_string(kind), " property \"", e.name,
                                            "\" cannot be transferred by the rule \"", to_string(rule),
                                            "\": its values, of type ", detail::written_type(e.values->type()),
                                            rule == property_rule::sum ? ", cannot be added" : ", have no mean"});
    return;
  }
  core::throw_joined<invalid_argument>(
      {"set_property_rule: the mesh has no ", to_string(kind), " property \"", name, "\""});
}

CONCINO_INLINE void property_set::transfer(const property_set& source, const correspondence& c) {
  transfer_kinds(source, c, {true, true, true, true, true, true});
}
CONCINO_INLINE void property_set::transfer_verts_and_polys(const property_set& source, const correspondence& c) {
  transfer_kinds(source, c, {true, false, false, true, true, false});
}

CONCINO_INLINE void property_set::transfer_kinds(const property_set& source, const correspondence& c,
                                                 const bool (&wanted)[6]) {
  const element_origins the_mesh(std::vector<std::uint32_t>{0u});
  const element_origins* const origins[] = {&c.verts, &c.edges, &c.faces, &c.polys, &the_mesh, &c.corners};
  std::vector<entry> all = entries_;
  for (const entry& e : source.entries_) {
    if (!wanted[static_cast<unsigned>(e.kind)]) continue;
    auto values = std::make_shared<detail::column>(*e.values, *origins[static_cast<unsigned>(e.kind)]);
    std::size_t same = 0;
    while (same < all.size() && !(all[same].kind == e.kind && all[same].name == e.name)) ++same;
    if (same < all.size()) all[same].values = std::move(values);
    else all.push_back({e.kind, e.name, std::move(values)});
  }
  entries_.swap(all);
}

/// The number of values of a property in a mesh with these index bounds.
CONCINO_INLINE std::size_t num_values_of(element_kind kind, const detail::index_bounds& bounds) {
  const std::size_t sizes[] = {bounds.verts, bounds.edges, bounds.faces, bounds.polys, 1, bounds.corners};
  return sizes[static_cast<unsigned>(kind)];
}

CONCINO_INLINE void property_set::renumber(const correspondence& c) {
  const element_origins* const origins[] = {&c.verts, &c.edges, &c.faces, &c.polys, nullptr, &c.corners};
  std::vector<std::unique_ptr<detail::column>> renumbered(entries_.size());  // null: the values stay
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const element_origins* const of = origins[static_cast<unsigned>(entries_[i].kind)];
    if (!of || detail::is_identity(*of, entries_[i].values->size())) continue;
    renumbered[i].reset(new detail::column(*entries_[i].values, *of));
  }
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (renumbered[i]) entries_[i].values->swap_values(*renumbered[i]);
}

CONCINO_INLINE void property_set::grow(const detail::index_bounds& before, const detail::index_bounds& after) {
  try {
    for (entry& e : entries_) e.values->resize(num_values_of(e.kind, after));
  } catch (...) {
    shrink(before);
    throw;
  }
}

CONCINO_INLINE void property_set::shrink(const detail::index_bounds& to) noexcept {
  for (entry& e : entries_)
    if (const std::size_t n = num_values_of(e.kind, to); n < e.values->size()) e.values->resize(n);
}

CONCINO_INLINE property_info property_set::info(std::size_t i) const {
  return {entries_[i].kind, entries_[i].name, &entries_[i].values->type(), entries_[i].values->rule()};
}

}  // namespace concino
