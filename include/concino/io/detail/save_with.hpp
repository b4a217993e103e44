// What all that save meshes share, whatever the formats.
#pragma once

#include <concino/io/detail/choose_format.hpp>
#include <concino/io/detail/flat_mesh_of.hpp>
#include <concino/io/replacing_file.hpp>

namespace concino::detail {

/// Says which properties a format drops: all but those in `kept`.
[[gnu::noinline, gnu::cold]] inline void tell_of_lost_properties(const property_set& all, const std::vector<write_context::kept_property>& kept,
                                                                 std::string_view format, std::vector<std::string>& lost) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const property_info p = all.info(i);
    bool is_kept = false;
    for (const write_context::kept_property& k : kept) is_kept = is_kept || (p.kind == k.kind && k.name == p.name && *p.type == *k.type);
    if (!is_kept) lost.push_back(core::joined({to_string(p.kind), " property \"", p.name, "\": ", format, " has no place for it"}));
  }
}

/// Errors: invalid_mesh if a coordinate is not finite, naming the vert by its index.
inline void check_points(std::string_view name, const flat_mesh& m) {
  for (std::size_t v = 0; v < m.points.size(); ++v)
    if (!is_finite(m.points[v]))
      core::throw_joined<invalid_mesh>({name, ": vert ", m.vert_index(v), " has a coordinate that is not a finite number; no file can hold it"});
}

/// What remains to be reported once all is written.
[[gnu::noinline, gnu::cold]] inline void tell_of_lost(const write_context& c, const flat_mesh& m, std::string_view format) {
  if (m.properties) tell_of_lost_properties(*m.properties, c.kept, format, c.report.lost);
  if (c.num_not_finite)
    c.report.lost.push_back(core::joined({c.num_not_finite, " numbers of colours and the like that are not finite: written as 0"}));
}

/// Writers of what M is not are not compiled. Returns the files beside this one, null where there are none.
template<class M, class... F>
std::unique_ptr<companion_files> write_with(text_sink& out, const M& m, std::string_view name, std::string_view path, format_list<F...> known, std::size_t chosen,
                                            const save_options& options) {
  save_report unheard, &report = options.report ? *options.report : unheard;
  report = {};
  const format_row& row = rows_of(known).rows[chosen];
  if (options.binary && !row.has_binary) core::throw_joined<unsupported>({name, ": ", row.extensions[0], " has no binary form here"});
  write_context context{out, name, path, options, report};
  with_format(known, chosen, [&]<Format G>(G) {
    if constexpr (dimension_v<M> == 2 ? G::holds_surfaces : G::holds_volumes) {  // a format may hold one of them only
      flat_mesh_of<M> flat(m);
      check_points(name, flat);
      context.num_elements = flat.points.size() + flat.num_polys;
      G::write(context, flat);
      tell_of_lost(context, flat, row.extensions[0]);
    } else if constexpr (dimension_v<M> == 2) {  // other formats can be named
      context.cannot_hold(row.extensions[0], {"surfaces"}, ".obj, or .mesh if it has triangles and quads only");
    } else {
      context.cannot_hold(row.extensions[0], {"volumes"}, ".mesh or .hedra");
    }
  });
  return std::move(context.companions);
}

template<class M, Formats F>
void save_with(const M& m, const std::string& path, F formats, const save_options& options) {
  const std::size_t chosen = chosen_for(path, formats, options.format);
  replacing_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  const std::unique_ptr<companion_files> companions = write_with(out, m, path, path, list_of(formats), chosen, options);
  out.flush();
  file.finish();
  if (options.progress) tell(options.progress, 1.0, "writing");
  if (companions) companions->commit_with(file);
  else file.commit();
}

template<class M, Formats F>
std::string save_text_with(const M& m, F formats, const save_options& options) {
  const std::size_t chosen = chosen_for({}, formats, options.format);
  text_sink out;
  write_with(out, m, "text", {}, list_of(formats), chosen, options);
  return std::move(out).take();
}

}  // namespace concino::detail
