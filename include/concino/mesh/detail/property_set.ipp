// Columns of values, and the set of them; see property_set.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/property_set.hpp>

#include <algorithm>
#include <cstring>

namespace concino {

namespace detail {

[[gnu::noinline]] CONCINO_INLINE void column::make_room(std::size_t n) {
  column fresh(*type_);
  fresh.data_ = static_cast<unsigned char*>(::operator new(n * type_->size, std::align_val_t(type_->alignment)));
  fresh.room_ = n;
  if (type_->move) {
    for (; fresh.size_ < size_; ++fresh.size_) type_->move(fresh.at(fresh.size_), at(fresh.size_));
  } else if (size_ > 0) {
    std::memcpy(fresh.data_, data_, size_ * type_->size);
    fresh.size_ = size_;
  }
  std::swap(data_, fresh.data_), std::swap(size_, fresh.size_), std::swap(room_, fresh.room_);
}

CONCINO_INLINE column::column(const value_type& type, std::size_t n) : column(type) {
  make_room(n);
  resize(n);
}

[[gnu::noinline]] CONCINO_INLINE column::column(const column& o) : column(*o.type_) {
  make_room(o.size_);
  if (type_->copy) {
    for (; size_ < o.size_; ++size_) type_->copy(at(size_), o.at(size_));
  } else if (o.size_ > 0) {
    std::memcpy(data_, o.data_, o.size_ * type_->size);
    size_ = o.size_;
  }
}

CONCINO_INLINE column::column(const column& o, const std::vector<std::uint32_t>& source) : column(*o.type_) {
  make_room(source.size());
  for (; size_ < source.size(); ++size_) {
    const std::uint32_t from = source[size_];
    if (from == ~0u) type_->make(at(size_));
    else if (type_->copy) type_->copy(at(size_), o.at(from));
    else std::memcpy(at(size_), o.at(from), type_->size);
  }
}

[[gnu::noinline]] CONCINO_INLINE column::~column() {
  resize(0);
  ::operator delete(data_, std::align_val_t(type_->alignment));
}

[[gnu::noinline]] CONCINO_INLINE void column::resize(std::size_t n) {
  if (n > room_) make_room(std::max(n, 2 * size_));
  if (type_->destroy) {
    while (size_ > n) type_->destroy(at(--size_));
    for (; size_ < n; ++size_) type_->make(at(size_));
    return;
  }
  if (size_ < n) {
    // the first one made, then copied in ever larger blocks, but no larger than a cache
    type_->make(at(size_));
    for (std::size_t made = 1, more = 1; size_ + made < n; made += more) {
      more = std::min({made, n - size_ - made, std::size_t{1024}});
      std::memcpy(at(size_ + made), at(size_), more * type_->size);
    }
  }
  size_ = n;
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

[[gnu::noinline, gnu::cold]] CONCINO_INLINE std::shared_ptr<detail::column> property_set::get(element_kind kind, std::string_view name, const detail::value_type& type, std::size_t n) {
  if (auto found = find(kind, name, type)) return found;
  std::shared_ptr<detail::column> fresh(new detail::column(type, n));
  entries_.push_back({kind, std::string(name), fresh});
  return fresh;
}

[[gnu::noinline, gnu::cold]] CONCINO_INLINE std::shared_ptr<detail::column> property_set::find(element_kind kind, std::string_view name, const detail::value_type& type) const {
  for (const entry& e : entries_) {
    if (e.kind != kind || e.name != name) continue;
    if (e.values->type() != *type.type)
      core::throw_joined<invalid_argument>({to_string(kind), " property \"", e.name, "\" holds values of type ", e.values->type().name(),
                                              ", not of the type asked for (", type.type->name(), "); use another name or remove it first"});
    return e.values;
  }
  return nullptr;
}

CONCINO_INLINE const void* property_set::values_if_any(element_kind kind, std::string_view name, const std::type_info& type) const {
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
  return std::any_of(entries_.begin(), entries_.end(), [&](const entry& e) { return e.kind == kind; });
}

CONCINO_INLINE void property_set::gather(const property_set& given, element_kind kind, const std::vector<std::uint32_t>& source) {
  for (const entry& e : given.entries_)
    if (e.kind == kind) entries_.push_back({kind, e.name, std::make_shared<detail::column>(*e.values, source)});
}

CONCINO_INLINE void property_set::grow(const detail::index_bounds& before, const detail::index_bounds& after) {
  if (entries_.empty()) return;
  const auto resize = [&](const detail::index_bounds& to) {
    const std::size_t sizes[] = {to.verts, to.edges, to.faces, to.polys, 1};
    for (entry& e : entries_) e.values->resize(sizes[static_cast<unsigned>(e.kind)]);
  };
  try {
    resize(after);
  } catch (...) {
    resize(before);  // only destroys
    throw;
  }
}

CONCINO_INLINE property_info property_set::info(std::size_t i) const { return {entries_[i].kind, entries_[i].name, &entries_[i].values->type()}; }

}  // namespace concino
