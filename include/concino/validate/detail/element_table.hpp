// The elements of one kind in the order of iteration, read so that no fault of a broken mesh does harm.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/message.hpp>
#include <concino/validate/broken_law.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace concino::detail {

/// The position of an element in the order of iteration.
using order_index = std::uint32_t;
inline constexpr order_index no_order_index = ~order_index{0};

/// The elements of one kind in the order of iteration. Elements that break the laws of indices are left out.
template<class D>
struct element_table {
  char letter;
  std::vector<D> items;
  std::vector<std::size_t> index;    // by position
  std::vector<order_index> slot;     // by index
  bool is_complete = true;            // no element was left out

  order_index size() const { return static_cast<order_index>(items.size()); }
  std::string name(order_index i) const { return core::joined({letter, index[i]}); }
  std::string kind() const { return letter == 'v' ? "vert" : letter == 'e' ? "edge" : letter == 'f' ? "face" : "poly"; }
  std::string index_bound() const { return core::joined({kind(), "_index_bound"}); }

  template<class M>
  order_index find(const M& m, const D& x) const {
    const std::size_t i = index_of(m, x);
    if (i >= slot.size() || slot[i] == no_order_index || !(items[slot[i]] == x)) return no_order_index;
    return slot[i];
  }
};

/// Fills the table of one kind of elements, and logs faults: of index_of under the law `indices`, of the range under
/// the law `counting`.
template<class D, class M>
class element_reader {
  const M& m_;
  element_table<D>& table_;
  const std::string kind_ = table_.kind();
  const std::size_t num_, bound_;
  const char* const indices_;
  const char* const counting_;
  law_log& log_;
  std::size_t walked_ = 0, faults_ = 0;

  void fault(const char* law, std::string what, std::size_t i) {
    log_.add(law, std::move(what), core::joined({table_.letter, i}));
    table_.is_complete = false;
    ++faults_;
  }

  void read(const D& x) {
    auto& t = table_;
    const std::size_t i = index_of(m_, x);
    if (i >= bound_) {
      fault(indices_, core::joined({"index_of gives ", i, ", which is not below ", t.index_bound(), ", ", bound_}), i);
    } else if (i / 1024 > walked_ + 65536) {
      fault(indices_,
            core::joined(
                {"index_of gives ", i, " for one of the first ", walked_ + 1, " ", kind_, "s: too sparse for arrays"}),
            i);
    } else if (i < t.slot.size() && t.slot[i] != no_order_index) {
      const bool again = t.items[t.slot[i]] == x;
      fault(again ? counting_ : indices_,
            again ? core::joined({"the range of ", kind_, "s contains this one twice"})
                  : core::joined({"index_of gives ", i, " for two different ", kind_, "s"}),
            i);
    } else {
      if (i >= t.slot.size()) t.slot.resize(std::max(i + 1, std::min(bound_, 2 * t.slot.size())), no_order_index);
      t.items.push_back(x);
      t.index.push_back(i);
      t.slot[i] = t.size() - 1;  // last: a slot always names an existing item, even if copying x throws
      if constexpr (requires { traits<M>::contains(m_, x); })
        if (!traits<M>::contains(m_, x))
          fault(counting_, core::joined({"contains returns false for a ", kind_, " of the range"}), i);
    }
  }

 public:
  element_reader(const M& m, element_table<D>& table, std::size_t num, std::size_t bound, const char* indices,
                 const char* counting, law_log& log)
      : m_(m), table_(table), num_(num), bound_(bound), indices_(indices), counting_(counting), log_(log) {}

  /// Iterates over a range. If it does not end, an index occurs a second time, or the count is far exceeded.
  template<class R>
  void walk(R&& range) {
    auto it = range.begin();
    for (; faults_ < 16 && (walked_ <= 1024 || walked_ / 2 <= num_) && it != range.end(); ++it, ++walked_) {
      const D x = *it;
      read(x);
    }
    const bool ended = !(it != range.end());
    if (walked_ != num_ && faults_ == 0)
      log_.add(counting_,
               core::joined({"the range of ", kind_, "s has ", walked_, ended ? "" : " or more", ", but num_", kind_,
                             "s is ", num_}),
               "");
    if (!ended) table_.is_complete = false;
  }

  /// Checks that the range is multi-pass and keeps its order while the mesh does not change.
  template<class R>
  void walk_again(R&& range) {
    if (!table_.is_complete) return;
    order_index i = 0;
    bool same = true;
    for (auto again = range.begin(); same && again != range.end(); ++again, ++i)
      same = i < table_.size() && table_.items[i] == static_cast<D>(*again);
    if (!same || i != table_.size())
      log_.add(counting_, core::joined({"the range of ", kind_, "s has other elements when iterated again"}), "");
  }
};

/// Reads all elements of a kind; faults of index_of break the law `indices`, faults of the range the law `counting`.
template<class D, class M, class Walk, class Num, class Bound>
element_table<D> read_elements(const M& m, char letter, const Walk& walk, const Num& num_of, const Bound& bound_of,
                               const char* indices, const char* counting, law_log& log) {
  element_table<D> t{letter, {}, {}, {}, true};
  const std::string kind = t.kind();
  std::size_t num = 0, bound = 0;
  try {
    num = num_of(m);
    bound = bound_of(m);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    log.add(indices, core::joined({"num_", kind, "s or ", t.index_bound(), " throws: ", e.what()}), "");
    t.is_complete = false;
    return t;
  }
  try {
    auto&& range = walk(m);
    element_reader<D, M> reader(m, t, num, bound, indices, counting, log);
    reader.walk(range);
    reader.walk_again(range);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    log.add(counting, core::joined({"iterating over the ", kind, "s throws: ", e.what()}), "");
    t.is_complete = false;
  }
  return t;
}

}  // namespace concino::detail
