// Labels, materials and colours of the polys of an OBJ file, from the names of groups, objects and materials.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/obj/assign_materials.hpp>
#include <concino/io/detail/obj/read_mtl.hpp>
#include <concino/io/detail/values/name_runs.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

inline constexpr std::size_t max_obj_name = 1000;  // the length of the names of polys, in bytes

/// Sets labels from the names of groups or objects, and materials and colours from the libraries. Needs: all polys are
/// read.
inline void end_obj_names(const read_context& context, const std::vector<std::string>& libraries, file_contents& out) {
  const std::size_t n = out.surface.num_polys();
  for (name_runs* const names : {&out.objects, &out.groups, &out.materials}) names->end(n);
  const name_runs& named = out.groups.empty() ? out.objects : out.groups;
  if (!named.empty()) {
    int label = 0;
    const bool numbers =
        &named == &out.groups && named.all([&](std::string_view name) { return is_number(name, "label_", label); });
    name_numbers number;
    out.poly_labels.reserve(n);
    named.for_each(n, [&](std::size_t, std::size_t end, std::string_view name) {
      label = 0;
      if (numbers) is_number(name, "label_", label);
      else label = number(name);
      while (out.poly_labels.size() < end) out.poly_labels.push_back(label);
    });
    if (numbers) out.groups.clear();
  }
  if (!libraries.empty()) assign_materials(context, libraries, n, out);
  for (name_runs* const names : {&out.objects, &out.groups, &out.materials}) {
    if (names->longest() <= max_obj_name) continue;
    names->rename([](std::string_view name) { return std::string(name.substr(0, max_obj_name)); });
    context.report->notes.push_back(core::joined(
        {"names longer than ", max_obj_name, " bytes were truncated, as every poly has a copy of its name"}));
  }
}

}  // namespace concino::detail
