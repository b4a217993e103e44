// edit_recorder: the log of the edits of one native mesh while a transaction is open. The mesh refers to it; a copy of
// the mesh does not.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/detail/edits/edit_log.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace concino::detail {

/// The index bounds of the elements of tables.
template<class Tables>
index_bounds bounds_of(const Tables& t) {
  index_bounds b{t.verts().bound(), t.edges().bound(), 0, t.polys().bound(), t.corner_bound()};
  if constexpr (requires { t.faces(); }) b.faces = t.faces().bound();
  return b;
}

template<class Mesh>
class edit_recorder;

/// What a mesh knows of its edits: the recorder, if a transaction is open, and the number of its state, which each edit
/// changes.
template<class Mesh>
struct edit_state {
  edit_recorder<Mesh>* recorder = nullptr;
  std::uint64_t version = 0, last_version = 0;

  edit_state() = default;
  edit_state(const edit_state&) noexcept {}
  edit_state& operator=(const edit_state&) noexcept {
    version = ++last_version;  // other content
    return *this;
  }
};

/// Mesh: has tables(), points(), properties() and edits(), an edit_state.
template<class Mesh>
class edit_recorder {
  Mesh* m_;
  struct recorded_column {
    std::shared_ptr<column> values;
    element_kind kind;
  };
  std::vector<recorded_column> columns_;

 public:
  edit_log log;

  explicit edit_recorder(Mesh& m) : m_(&m) {
    const property_set& all = m.properties();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all.values(i)->is_bytes())
        core::throw_joined<unsupported>(
            {"transaction: property \"", all.info(i).name,
             "\" has values that cannot be copied byte by byte, so they could not be restored without memory; remove it first"});
      columns_.push_back({all.values(i), all.kind(i)});
    }
  }

  Mesh& mesh() const { return *m_; }
  template<class F>
  void for_each_array(const F& f) {
    m_->tables().for_each_array(f);
    f(m_->points());
    for (const recorded_column& c : columns_) f(*c.values);
  }
  static std::uint32_t number_of_points() { return Mesh::tables_type::num_arrays; }

  void begin_step() { log.begin_step(*this); }
  void save_point(std::size_t v) {
    begin_step();
    try {
      log.save(number_of_points(), m_->points(), v);
    } catch (...) {
      log.drop_step();
      throw;
    }
  }
  /// Begins a step and saves values of properties: visit(save) calls save(kind, index) for each element.
  template<class Visit>
  void save_values(const Visit& visit) {
    begin_step();
    try {
      visit([&](element_kind kind, std::size_t index) {
        for (std::size_t i = 0; i < columns_.size(); ++i)
          if (columns_[i].kind == kind)
            log.save(static_cast<std::uint32_t>(number_of_points() + 1 + i), *columns_[i].values, index);
      });
    } catch (...) {
      log.drop_step();
      throw;
    }
  }
  void roll_back(std::size_t to_step) noexcept {
    log.roll_back(*this, to_step);
    shrink_properties();
  }
  /// Sets the mesh to the state before all edits of the log, or to the one after them.
  void undo() { log.restore_before(*this), shrink_properties(); }
  edit_log changes() { return log.of_changes(*this); }
  void redo(const edit_log& after) { after.restore(*this); }

 private:
  void shrink_properties() noexcept { m_->properties().shrink(bounds_of(m_->tables())); }
};

/// One edit: a step of the log, if one is open. It is undone unless finish() is called: an edit that fails may have
/// moved rows to other places already.
template<class Mesh>
class edit_step {
  edit_state<Mesh>& state_;
  bool is_finished_ = false;

 public:
  explicit edit_step(Mesh& m) : state_(m.edits()) {
    if (state_.recorder) state_.recorder->begin_step();
  }
  edit_step(const edit_step&) = delete;
  edit_step& operator=(const edit_step&) = delete;
  ~edit_step() {
    if (!is_finished_ && state_.recorder) state_.recorder->roll_back(state_.recorder->log.num_steps() - 1);
  }
  edit_log* log() const { return state_.recorder ? &state_.recorder->log : nullptr; }
  void finish() {
    is_finished_ = true;
    state_.version = ++state_.last_version;
  }
};

}  // namespace concino::detail
