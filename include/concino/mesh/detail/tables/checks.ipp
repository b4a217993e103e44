// Checks of the lists of verts from which meshes are built; see checks.hpp.
#pragma once

#include <concino/mesh/detail/tables/checks.hpp>

#include <algorithm>
#include <string>

namespace concino::detail {

CONCINO_INLINE void check_verts(id_span<vert_id> verts, std::size_t vert_count, const char* what, std::size_t which,
                                std::vector<std::uint32_t>& visited) {
  const auto name = [&] { return core::joined({what, " ", which}); };
  if (verts.size() < 3)
    core::throw_joined<invalid_mesh>({name(), " has ", verts.size(), " verts; it needs at least 3"});
  for (const vert_id v : verts)
    if (v.raw() >= vert_count)
      core::throw_joined<invalid_mesh>({name(), " names vert ",
                                        v.is_none() ? std::string("-1 or above 2^32") : core::joined({v.raw()}),
                                        ", but the mesh has ", vert_count, " verts, numbered from 0"});
  std::size_t twice = verts.size();
  if (verts.size() <= 16) {
    for (std::size_t i = 1; i < verts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (verts[i] == verts[j]) twice = i;
  } else {
    if (visited.size() < vert_count) visited.assign(vert_count, ~0u);
    for (std::size_t i = 0; i < verts.size(); ++i) {
      if (visited[verts[i].raw()] == which) twice = i;
      visited[verts[i].raw()] = static_cast<std::uint32_t>(which);
    }
  }
  if (twice != verts.size())
    core::throw_joined<invalid_mesh>({name(), " has vert ", verts[twice].raw(), " twice; its verts must differ"});
}

CONCINO_INLINE void check_new_verts(id_span<vert_id> list, const alive_elements<vert_id>& all, const char* what,
                                    std::size_t which) {
  std::vector<std::uint32_t> visited;
  check_verts(list, all.bound(), what, which, visited);
  for (const vert_id v : list)
    if (!all.contains(v))
      core::throw_joined<invalid_mesh>({what, " ", which, " names vert ", v.raw(), ", which was deleted"});
}

CONCINO_INLINE void check_counts(const char* function, std::size_t vert_count, std::size_t poly_count,
                                 std::size_t corner_count) {
  if (poly_count >= encoded_neighbour::mask)
    core::throw_joined<unsupported>({function, ": the mesh has ", poly_count, " polys; at most 2^30 - 2 fit"});
  if (vert_count >= ~0u || corner_count >= ~0u)
    core::throw_joined<unsupported>({function, ": the mesh has ", std::max(vert_count, corner_count),
                                     vert_count >= ~0u ? " verts" : " corners", "; at most 2^32 - 2 fit"});
}

}  // namespace concino::detail
