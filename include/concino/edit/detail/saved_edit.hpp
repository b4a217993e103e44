// Edits that replace values of named properties, which a transaction can undo.
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>
#include <concino/edit/detail/open_recorder.hpp>

namespace concino::detail {

template<class M>
bool has_open_transaction(M& m) {
  if constexpr (saves_values<M>) return open_recorder(m) != nullptr;
  else return false;
}

/// Calls replace(). While a transaction is open, first saves the values that it may replace: for_each_replaced(save)
/// calls save(kind, index) for each of their elements. If something fails, what was done is undone.
template<class M, class Visit, class Replace>
void replace_saved(M& m, const Visit& for_each_replaced, const Replace& replace) {
  if constexpr (saves_values<M>)
    if (auto* const recorder = open_recorder(m)) {
      const std::size_t before = recorder->log.num_steps();
      try {
        recorder->save_values(for_each_replaced);
        replace();
      } catch (...) {
        recorder->roll_back(before);
        throw;
      }
      return;
    }
  replace();
}

}  // namespace concino::detail
