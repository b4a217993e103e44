// Reads and writes functions on verts or polys as text: a first line `SCALAR_FIELD n` or `VECTOR_FIELD n`, then n lines
// of one or three numbers.
#pragma once

#include <concino/concepts/dual_graph.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/values/read_field.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/mesh/element_map.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace concino {

namespace requirement {

/// Whether u gives a number or a vector, and no text, at every vert, or at every poly, of M.
template<class U, class E> concept gives_vectors = gives_points<U, E> && requires(const U& u, const E& e) {
  requires !std::same_as<std::remove_cvref_t<decltype(u[e][0])>, char>;
};
template<class U, class M>
concept is_field_at_verts = has_verts<M> && has_num_verts<M> &&
    (gives_numbers<U, vert_t<M>> || gives_vectors<U, vert_t<M>>);
template<class U, class M>
concept is_field_at_polys = has_polys<M> && has_num_polys<M> &&
    (gives_numbers<U, poly_t<M>> || gives_vectors<U, poly_t<M>>);

/// A value that files of fields hold: a double, a float, an integer of at most 64 bits with a sign or 32 without, or a
/// vector v with v[0], v[1], v[2].
template<class T>
concept is_field_number = std::same_as<T, double> || std::same_as<T, float> ||
    (std::integral<T> && !std::same_as<T, bool> && (sizeof(T) < 8 || (sizeof(T) == 8 && std::is_signed_v<T>)));
template<class T> concept is_field_vector = std::is_class_v<T> && std::default_initializable<T> && requires(T& v) {
  v[0] = v[2];
  requires std::floating_point<std::remove_cvref_t<decltype(v[0])>> && sizeof(v[0]) <= 8;
};
template<class T> concept is_field_value = is_field_number<T> || is_field_vector<T>;

}  // namespace requirement

namespace detail {

template<class Elements, class U>
void write_field(const Elements& elements, std::uint64_t n, const U& u, const std::string& path,
                 const file_options& options) {
  using value = std::remove_cvref_t<decltype(u[*elements.begin()])>;
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  out << (std::convertible_to<value, double> ? "SCALAR_FIELD " : "VECTOR_FIELD ") << n << '\n';
  for (const auto x : elements) {
    if constexpr (std::integral<value> && sizeof(value) == 8) out << value{u[x]} << '\n';
    else if constexpr (std::integral<value>) out << std::int64_t{u[x]} << '\n';  // characters as numbers too
    else if constexpr (std::convertible_to<value, double>) out << static_cast<double>(u[x]) << '\n';
    else
      out << static_cast<double>(u[x][0]) << ' ' << static_cast<double>(u[x][1]) << ' ' << static_cast<double>(u[x][2])
          << '\n';
  }
  out.flush();
  file.commit();
}

/// Reads the value of each element into u, which has values of type T.
template<class T, class Elements, class U>
void read_field_into(const Elements& elements, std::uint64_t n, const char* name_of_elements, const std::string& path,
                     U& u) {
  file_field wanted{.count = n, .elements = name_of_elements};
  if constexpr (requirement::is_field_vector<T>) {
    wanted.size = 3;
    wanted.max_number = static_cast<double>(std::numeric_limits<std::remove_cvref_t<decltype(T()[0])>>::max());
  } else if constexpr (std::integral<T>) {
    wanted.are_integers = true;
    wanted.low = std::numeric_limits<T>::min();
    wanted.high = std::numeric_limits<T>::max();
  } else {
    wanted.max_number = static_cast<double>(std::numeric_limits<T>::max());
  }
  auto at = elements.begin();
  read_field_file(path, wanted, [&](const file_field_value& x) {
    if constexpr (requirement::is_field_vector<T>) {
      using number = std::remove_cvref_t<decltype(T()[0])>;
      u[*at][0] = static_cast<number>(x.numbers[0]);
      u[*at][1] = static_cast<number>(x.numbers[1]);
      u[*at][2] = static_cast<number>(x.numbers[2]);
    } else if constexpr (std::integral<T>) {
      u[*at] = static_cast<T>(x.integer);
    } else {
      u[*at] = static_cast<T>(x.numbers[0]);
    }
    ++at;
  });
}

}  // namespace detail

/// Writes the value of u at every vert, in the order of verts(m), or at every poly, in the order of polys(m).
/// Needs:  a mesh or graph; u[v] a number or a vector with [0], [1], [2], at verts or at polys, not at both.
/// Result: a file from which load_vert_field or load_poly_field reads exactly the same values: integers, floats and
///         doubles bit by bit, inf and -inf too; NaN stays NaN. It replaces a file of that name only when it is
///         complete.
/// Cost:   O(V) or O(P).      Errors: io_error.
template<class U, class M>
  requires(requirement::is_field_at_verts<U, M> && !requirement::is_field_at_polys<U, M>)
void save_field(const U& u, const M& m, const std::string& path, const file_options& options = {}) {
  detail::write_field(verts(m), static_cast<std::uint64_t>(num_verts(m)), u, path, options);
}
template<class U, class M>
  requires(requirement::is_field_at_polys<U, M> && !requirement::is_field_at_verts<U, M>)
void save_field(const U& u, const M& m, const std::string& path, const file_options& options = {}) {
  detail::write_field(polys(m), static_cast<std::uint64_t>(num_polys(m)), u, path, options);
}

/// Reads such a file as a map on the verts of m, in the order of verts(m).
/// Needs:  a mesh or graph with verts, not a temporary; T is double, float, an integer or a vector, such as vec3 or
///         std::array<float, 3>.
/// Result: a map of T. The first line may be absent: then the file is just the values.      Cost: O(V + size of the
///         file).
/// Errors: io_error; parse_error with the line, also if the file has not one value of this kind per vert, naming both
///         numbers, or if T cannot hold a value. inf, -inf and nan are values like others, unless T is an integer.
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requirement::has_verts<M> && requirement::has_num_verts<M> &&
      requirement::is_field_value<T>
          vert_map<M, T> load_vert_field(M&& m, const std::string& path) {
    auto u = make_vert_map<T>(m);
    detail::read_field_into<T>(verts(m), static_cast<std::uint64_t>(num_verts(m)), "verts", path, u);
    return u;
  }

/// Reads such a file as a map on the polys of m, in the order of polys(m).
/// Needs:  a mesh or graph with polys, not a temporary; T as for load_vert_field.
/// Result: a map of T. The first line may be absent: then the file is just the values.      Cost: O(P + size of the
///         file).
/// Errors: as load_vert_field.
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requirement::has_polys<M> && requirement::has_num_polys<M> &&
      requirement::is_field_value<T>
          poly_map<M, T> load_poly_field(M&& m, const std::string& path) {
    auto u = make_poly_map<T>(m);
    detail::read_field_into<T>(polys(m), static_cast<std::uint64_t>(num_polys(m)), "polys", path, u);
    return u;
  }

// What to write instead of calls that cannot compile.
template<class U, class... T> void save_field(const U&, mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void load_vert_field(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void load_vert_field(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void load_poly_field(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void load_poly_field(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<
    class U, class M,
    class R = mistake::remedy<
        "the map has to give a number or a vector at each vert, or at each poly, but not at both: make_vert_map<double>(m)">>
  requires(requirement::is_adapted<M> && requirement::is_field_at_verts<U, M> == requirement::is_field_at_polys<U, M>)
void save_field(const U&, const M&, ...) = delete;  // values at verts or polys: make_vert_map<double>(m), make_poly_map<vec3>(m)

}  // namespace concino
