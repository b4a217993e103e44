// The record of the transaction that is open on a mesh.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino::detail {

/// Models that can save values of properties while a transaction is open.
template<class M> concept saves_values = requires(M& m) { traits<M>::edits(m).recorder->log; };

/// The record of the open transaction, or null. Other libraries' meshes have no edits before their first transaction.
template<saves_values M>
auto* open_recorder(M& m) {
  if constexpr (requires { traits<M>::edits_if_any(m); }) {
    const auto* const edits = traits<M>::edits_if_any(m);
    return edits ? edits->recorder : nullptr;
  } else {
    return traits<M>::edits(m).recorder;
  }
}

}  // namespace concino::detail
