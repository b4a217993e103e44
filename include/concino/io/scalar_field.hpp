// Reads and writes functions on verts as text: a first line `SCALAR_FIELD n`, then n numbers, one per line.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/detail/paths.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/text_cursor.hpp>
#include <concino/io/options.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino {

/// Writes the value of u at every vert, in the order of verts(m).
/// Needs:  a mesh or graph with verts; u[v] convertible to double.
/// Result: a file from which load_field reads exactly the same values, +inf and NaN included. It replaces a file of that name only when it is
///         complete.
/// Cost:   O(V).      Errors: io_error.
template<class M, class U>
  requires requirement::has_verts<M> && requirement::has_num_verts<M> && requirement::gives_numbers<U, vert_t<M>>
void save_field(const M& m, const U& u, const std::string& path, const file_options& options = {}) {
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  out << "SCALAR_FIELD " << static_cast<std::uint64_t>(num_verts(m)) << '\n';
  for (const vert_t<M> v : verts(m)) out << static_cast<double>(u[v]) << '\n';
  out.flush();
  file.commit();
}

/// Reads such a file as a map on the verts of m, in the order of verts(m).
/// Needs:  a mesh or graph with verts, not a temporary.
/// Result: a map of double.      Cost: O(V + size of the file).
/// Errors: io_error; parse_error with the line, also if the file does not hold one number per vert.
template<class M>
  requires requirement::is_lvalue_or_view<M> && requirement::has_verts<M> && requirement::has_num_verts<M>
vert_map<M, double> load_field(M&& m, const std::string& path) {
  detail::check_path(path);
  const file_text file(path);
  token_cursor in(file.text(), path, nullptr, 0);
  in.skip();
  const char* const head = in.at;
  if (in.word() != "SCALAR_FIELD") in.fail(head, "SCALAR_FIELD");
  in.skip();
  const char* const announced = in.at;
  const auto n = in.next_count("the number of values", 2);
  const auto wanted = static_cast<std::uint64_t>(num_verts(m));
  if (n != wanted) in.fail(announced, {"a value for each of the ", wanted, " verts of the mesh"});
  auto u = make_vert_map<double>(m);
  for (const vert_t<M> v : verts(m)) {
    in.skip();
    double x = 0;
    const char* const end = parse_real(in.at, in.end(), x);
    if (!end || !in.ends_token(end, 0)) in.fail(in.at, "a number");
    in.at = end;
    u[v] = x;
  }
  in.skip();
  if (!in.at_end()) in.fail(in.at, {"the end of the file after ", wanted, " values"});
  return u;
}

// What to write instead of calls that cannot compile.
template<class... T> void save_field(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void load_field(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void load_field(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(PrimalGraph<M> && !requirement::gives_numbers<U, vert_t<M>>)
void save_field(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
