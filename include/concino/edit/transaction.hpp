// transaction: edits of a mesh that are all kept or all undone.
//
//   { transaction t(m); edge_split(m, e); }                                        // not committed: m is as it was
//   transaction t(m); edge_split(m, e); auto edits = t.commit();  edits.undo();  edits.redo();
//
// What is undone are edits by the functions of this library: elements, adjacencies and their order, points set by
// set_point, and the properties that these edits change. Values that are written through maps and property handles, and
// points written in m.points(), are not.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <memory>
#include <utility>

namespace concino {

namespace requirement {

template<class M> concept has_edits = requires(std::remove_cvref_t<M>& m) {
  traits<M>::edits(m).recorder;
  traits<M>::edits(m).version;
};

}  // namespace requirement

namespace detail {

template<class M> using edits_of = std::remove_reference_t<decltype(traits<M>::edits(std::declval<M&>()))>;
template<class M> using recorder_of = std::remove_pointer_t<decltype(edits_of<M>::recorder)>;

}  // namespace detail

/// The edits of a committed transaction, which can be undone and done again as long as nothing else has changed the
/// mesh in between. Refers to the mesh.
template<class M>
  requires requirement::has_edits<M>
class committed_edits {
  M* m_ = nullptr;
  std::unique_ptr<detail::recorder_of<M>> before_;
  std::unique_ptr<decltype(detail::recorder_of<M>::log)> after_;
  std::uint64_t version_before_ = 0, version_after_ = 0;

  /// The edits of the mesh. Finding them may need memory in meshes of other libraries, so this comes first.
  detail::edits_of<M>* check(std::uint64_t version, const char* caller) const {
    detail::edits_of<M>* const edits = m_ ? &traits<M>::edits(*m_) : nullptr;
    if (edits && edits->recorder)
      core::throw_joined<invalid_argument>({caller, ": a transaction is open; commit it or let it end first"});
    if (!edits || edits->version != version)
      core::throw_joined<invalid_argument>({caller, ": the mesh is not in the state that these edits ",
                                            version == version_after_ ? "made" : "began with",
                                            "; undo later edits first"});
    return edits;
  }

 public:
  committed_edits() = default;
  committed_edits(M& m, std::unique_ptr<detail::recorder_of<M>> log, std::uint64_t version_before,
                  std::uint64_t version_after)
      : m_(&m), before_(std::move(log)), version_before_(version_before), version_after_(version_after) {}

  /// Whether these are the edits of a whole transaction; those of an inner one belong to the outer one.
  explicit operator bool() const { return m_ != nullptr; }

  /// Undoes the edits.
  /// Needs:  the mesh exists, at the same address.      Result: none; the mesh is as before the edits.      Cost:
  ///         linear in what the edits changed.
  /// Errors: invalid_argument if the mesh has been edited since, these edits are undone already, or a transaction is
  ///         open. std::bad_alloc; nothing changes then.
  void undo() {
    detail::edits_of<M>* const edits = check(version_after_, "undo");
    if (!after_) after_ = std::make_unique<decltype(detail::recorder_of<M>::log)>(before_->changes());
    before_->undo();
    edits->version = version_before_;
  }

  /// Does the edits again after undo().
  /// Needs:  the mesh exists, at the same address.      Result: none; the mesh is as after the edits.      Cost: linear
  ///         in what the edits changed.
  /// Errors: invalid_argument if the mesh has been edited since undo(), or a transaction is open.
  void redo() {
    detail::edits_of<M>* const edits = check(version_before_, "redo");
    if (!after_) core::throw_joined<invalid_argument>({"redo: the edits were not undone"});
    before_->redo(*after_);
    edits->version = version_after_;
  }
};

/// Undoes all edits of m since its construction, unless commit() was called: also if an exception leaves its scope.
/// Transactions can be nested; an inner one that is committed is undone with the outer one. The mesh must not be moved
/// or assigned to while one is open.
template<class M>
  requires requirement::has_edits<M>
class transaction {
  M& m_;
  detail::edits_of<M>& edits_;
  std::unique_ptr<detail::recorder_of<M>> own_;  // empty in an inner transaction
  std::size_t first_step_ = 0;
  std::uint64_t version_before_;
  bool is_open_ = true;

 public:
  /// Needs:  a mesh that records its edits: those of this library, OpenMesh and CGAL::Surface_mesh.
  /// Cost:   O(properties), in OpenMesh and CGAL the first time O(edges); edits inside take longer, by what they save.
  /// Errors: unsupported if a property of m has values that cannot be copied byte by byte, such as std::string.
  explicit transaction(M& m) : m_(m), edits_(traits<M>::edits(m)), version_before_(edits_.version) {
    if (!edits_.recorder) own_ = std::make_unique<detail::recorder_of<M>>(m);
    if (own_) edits_.recorder = own_.get();
    first_step_ = edits_.recorder->log.num_steps();
  }
  transaction(const transaction&) = delete;
  transaction& operator=(const transaction&) = delete;
  ~transaction() {
    if (is_open_) roll_back();
  }

  /// Keeps the edits.
  /// Needs:  the transaction is open.      Result: the edits, to undo them; empty in an inner transaction.      Cost:
  ///         O(1).
  /// Errors: invalid_argument if the transaction has ended.
  committed_edits<M> commit() {
    end("commit");
    if (!own_) return {};
    edits_.recorder = nullptr;
    return committed_edits<M>(m_, std::move(own_), version_before_, edits_.version);
  }

  /// Undoes the edits of this transaction now, and ends it. Allocates no memory.
  /// Needs:  the transaction is open.      Result: none.      Cost: linear in what the edits changed.
  /// Errors: invalid_argument if the transaction has ended.
  void roll_back() {
    end("roll_back");
    edits_.recorder->roll_back(first_step_);
    edits_.version = version_before_;
    if (own_) edits_.recorder = nullptr;
  }

 private:
  void end(const char* caller) {
    if (!is_open_) core::throw_joined<invalid_argument>({caller, ": the transaction has ended already"});
    is_open_ = false;
  }
};

namespace detail {

/// Calls edit(), which consists of several edits. While a transaction is open, they are undone if it fails.
template<class M, class Edit>
void edit_in_steps(M& m, const Edit& edit) {
  if constexpr (requirement::has_edits<M>)
    if (traits<M>::edits(m).recorder) {
      transaction<M> t(m);
      edit();
      t.commit();
      return;
    }
  edit();
}

}  // namespace detail

}  // namespace concino
