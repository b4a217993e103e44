// The log of defects: names of elements, the limit of records, and progress.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/validate/defect.hpp>

#include <utility>

namespace concino {

/// The options of validate.
struct validate_options {
  defect_kinds kinds = {};           // the kinds to look for; default: all. The facts are always computed.
  std::size_t max_per_kind = 100;   // maximum number of records of each kind, 0 or more; further defects are only
                                    // counted
  double length_tolerance = 0;       // >= 0, times the diagonal of the bounding box of the mesh: edges up to this
                                     // length count as zero
  double size_tolerance = 0;         // >= 0, times the diagonal of an element's box, squared (areas) or cubed
                                     // (volumes): sizes up to this count as zero
  double planarity_tolerance = 0.05; // >= 0, times the diagonal of a polygon's box: allowed distance of verts from its
                                     // plane
  concino::progress progress = {};   // called with "validate"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

template<class M>
class defect_log {
  const M* m_;
  validation_report<M>* report_;
  const validate_options* options_;
  double from_ = 0, to_ = 0;
  std::size_t done_ = 0, work_ = 1;

 public:
  defect_log(const M& m, validation_report<M>& report, const validate_options& options)
      : m_(&m), report_(&report), options_(&options) {}

  bool wants(defect_kind kind) const { return options_->kinds.holds(kind); }
  bool wants_any(std::initializer_list<defect_kind> kinds) const { return options_->kinds.holds_any(kinds); }
  const validate_options& options() const { return *options_; }

  /// Adds a record, whose `others` and `what` the caller fills in; null if the kind is not wanted or its limit is
  /// reached.
  defect<M>* add(defect_kind kind, const mesh_element<M>& x) {
    return wants(kind) ? report_->add(kind, x, options_->max_per_kind) : nullptr;
  }

  /// A name such as "vert 7".
  template<class X>
  std::string name(const X& x) const {
    const char* kind = "face ";
    if constexpr (std::same_as<X, vert_t<M>>) kind = "vert ";
    else if constexpr (std::same_as<X, edge_t<M>>) kind = "edge ";
    else if constexpr (std::same_as<X, poly_t<M>>) kind = "poly ";
    return core::joined({kind, index_of(*m_, x)});
  }
  /// A name such as "edge 7 from vert 1 to vert 2".
  std::string edge_name(const edge_t<M>& e) const {
    std::string text = name(e);
    const char* join = " from ";
    for (const vert_t<M> v : adj_e2v(*m_, e)) text += core::joined({std::exchange(join, " to "), name(v)});
    return text;
  }
  /// Adds some elements of a range to `others` of a record.   Result: "poly 3, poly 4 and poly 5", "poly 3, ... and 9
  /// more"
  template<class R>
  std::string list(defect<M>& d, const R& range) const {
    constexpr std::size_t most = 6;
    std::vector<std::string> names;
    std::size_t n = 0;
    for (const auto x : range)
      if (n++ < most) {
        names.push_back(name(x));
        d.others.push_back(x);
      }
    if (n > most) names.push_back(core::joined({core::number_text(n - most), " more"}));
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
      text += core::joined({i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]});
    return text;
  }

  /// The next `work` calls of step() advance the progress to `to`.
  void begin_stage(double to, std::size_t work) {
    from_ = to_;
    to_ = to;
    done_ = 0;
    work_ = work > 0 ? work : 1;
    report_progress(options_->progress, from_, "validate");
  }
  void step() {
    if (++done_ % 8192 == 0)
      report_progress(
          options_->progress,
          from_ + (to_ - from_) * static_cast<double>(done_ < work_ ? done_ : work_) / static_cast<double>(work_),
          "validate");
  }
};

}  // namespace detail

}  // namespace concino
