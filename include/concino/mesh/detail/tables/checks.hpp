// Checks of the lists of verts from which meshes are built.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/detail/facets/facet_adjacency.hpp>
#include <concino/mesh/support/limits.hpp>

namespace concino::detail {

/// Lists of N values each, or with offsets; throws if the arrays are not such lists.
template<unsigned N, class T>
jagged_array<T, N> checked_lists(std::vector<T> values, const char* what) {
  if (values.size() % N)
    core::throw_joined<invalid_mesh>(
        {what, " ", values.size() / N, " has ", values.size() % N, " verts; it needs ", N});
  shrink_if_wasteful(values);
  return jagged_array<T, N>(std::move(values));
}
template<class T>
jagged_array<T, 0> checked_lists(offsets first, std::vector<T> values, const char* what) {
  if (first.empty()) first.push_back(0);
  if (first.front() != 0)
    core::throw_joined<invalid_mesh>({what, " offsets begin with ", first.front(), "; they must begin with 0"});
  for (std::size_t i = 1; i < first.size(); ++i)
    if (first[i] < first[i - 1])
      core::throw_joined<invalid_mesh>({what, " ", i - 1, " ends before it begins; offsets must not decrease"});
  if (first.back() != values.size())
    core::throw_joined<invalid_mesh>(
        {what, " offsets end with ", first.back(), ", but the lists have ", values.size(), " entries"});
  shrink_if_wasteful(first);
  shrink_if_wasteful(values);
  return {std::make_shared<const offsets>(std::move(first)), std::move(values)};
}

/// Whether N verts are different, and below vert_count.
template<unsigned N>
bool are_distinct_verts(const vert_id* v, std::size_t vert_count) {
  bool good = v[0].raw() < vert_count;
  for (unsigned i = 1; i < N; ++i) {
    good &= v[i].raw() < vert_count;
    for (unsigned j = 0; j < i; ++j) good &= v[i] != v[j];
  }
  return good;
}

/// Throws if a list of verts cannot be a polygon.
void check_verts(id_span<vert_id> verts, std::size_t vert_count, const char* what, std::size_t which,
                 std::vector<std::uint32_t>& visited);

/// The same for a new poly or face of a mesh in which verts may be deleted.
void check_new_verts(id_span<vert_id> list, const alive_elements<vert_id>& all, const char* what, std::size_t which);

/// Throws if ids cannot count so many elements. Errors name `function`.
void check_counts(const char* function, std::size_t vert_count, std::size_t poly_count, std::size_t corner_count);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/tables/checks.ipp>
#endif
