// Polys with their verts and points, without a mesh: what processes send each other.
#pragma once

#include <concino/adapters/detail/distributed/distributed_scatter.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/support/face_soup.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Appends row i of rows of this size.
inline void append_row(const std::vector<char>& from, std::size_t size, std::size_t i, std::vector<char>& to) {
  to.insert(to.end(), from.data() + i * size, from.data() + (i + 1) * size);
}

/// Polys and all their verts.
struct poly_records {
  std::vector<std::uint64_t> poly_numbers, vert_numbers;  // in the whole mesh; those of verts increase
  std::vector<int> poly_owners, vert_owners;              // empty as long as they are unknown
  std::vector<vec3> points;                               // of the verts
  std::vector<std::size_t> ends;                          // of the words of each poly
  // Verts, as places in vert_numbers, in the order of adj_p2v. Of a polyhedron its faces: for each the number of its
  // verts, and these, counter-clockwise seen from outside.
  std::vector<std::uint32_t> words;
  std::vector<char> poly_values, vert_values;             // rows of properties

  std::size_t num_polys() const { return poly_numbers.size(); }
  std::size_t begin(std::size_t p) const { return p == 0 ? 0 : ends[p - 1]; }

  std::size_t poly_row() const { return poly_numbers.empty() ? 0 : poly_values.size() / poly_numbers.size(); }
  std::size_t vert_row() const { return vert_numbers.empty() ? 0 : vert_values.size() / vert_numbers.size(); }

  /// Makes room, so that no array takes twice the memory that it needs.
  void reserve(std::size_t poly_count, std::size_t vert_count, std::size_t word_count) {
    poly_numbers.reserve(poly_count), poly_owners.reserve(poly_count), ends.reserve(poly_count);
    vert_numbers.reserve(vert_count), vert_owners.reserve(vert_count), points.reserve(vert_count);
    words.reserve(word_count);
  }
  void free_verts() {
    std::vector<std::uint64_t>().swap(vert_numbers);
    std::vector<int>().swap(vert_owners);
    std::vector<vec3>().swap(points);
    std::vector<char>().swap(vert_values);
  }
  /// Calls f(word) for the verts of a poly, repeatedly for those of several faces.
  template<class F>
  void for_each_vert(std::size_t p, bool has_faces, F f) const {
    for (std::size_t at = begin(p); at < ends[p];) {
      std::size_t n = has_faces ? words[at++] : ends[p] - at;
      for (; n > 0; --n) f(words[at++]);
    }
  }
  /// Appends poly p of others; new_vert(place in others) are the places of its verts here.
  template<class NewVert>
  void append(const poly_records& others, std::size_t p, bool has_faces, NewVert new_vert) {
    poly_numbers.push_back(others.poly_numbers[p]);
    if (!others.poly_owners.empty()) poly_owners.push_back(others.poly_owners[p]);
    for (std::size_t at = others.begin(p); at < others.ends[p];) {
      std::size_t n = others.ends[p] - at;
      if (has_faces) words.push_back(static_cast<std::uint32_t>(n = others.words[at++]));
      for (; n > 0; --n) words.push_back(new_vert(others.words[at++]));
    }
    ends.push_back(words.size());
    append_row(others.poly_values, others.poly_row(), p, poly_values);
  }
  void append_vert(const poly_records& others, std::size_t v) {
    vert_numbers.push_back(others.vert_numbers[v]);
    points.push_back(others.points[v]);
    if (!others.vert_owners.empty()) vert_owners.push_back(others.vert_owners[v]);
    append_row(others.vert_values, others.vert_row(), v, vert_values);
  }
  /// Calls f(array) for every array.
  template<class F>
  void for_each_array(F f) {
    f(poly_numbers), f(vert_numbers), f(poly_owners), f(vert_owners), f(points), f(ends), f(words);
    f(poly_values), f(vert_values);
  }
};

/// The polys of a mesh without deleted elements, which has these numbers.
template<class M>
poly_records records_of(const M& m, std::vector<std::uint64_t> vert_numbers, std::vector<std::uint64_t> poly_numbers) {
  poly_records r;
  r.vert_numbers = std::move(vert_numbers);
  r.poly_numbers = std::move(poly_numbers);
  r.reserve(num_polys(m), num_verts(m), arity_v<M> * num_polys(m));
  for (const vert_t<M> v : verts(m)) r.points.push_back(point(m, v));
  for (const poly_t<M> p : polys(m)) {
    const auto push = [&](const vert_t<M>& v) { r.words.push_back(static_cast<std::uint32_t>(index_of(m, v))); };
    if constexpr (from_polyhedra<M>) {
      for (const face_t<M> f : adj_p2f(m, p)) {
        r.words.push_back(static_cast<std::uint32_t>(num_elements(adj_f2v(m, f))));
        const std::size_t first = r.words.size();
        for (const vert_t<M> v : adj_f2v(m, f)) push(v);
        if (!face_is_outward(m, p, f))
          std::reverse(r.words.begin() + static_cast<std::ptrdiff_t>(first), r.words.end());
      }
    } else {
      for (const vert_t<M> v : adj_p2v(m, p)) push(v);
    }
    r.ends.push_back(r.words.size());
  }
  return r;
}
template<class M>
poly_records records_of(mesh_slice<M>& s) {
  std::vector<std::uint64_t> poly_numbers(num_polys(s.mesh));
  for (std::size_t p = 0; p < poly_numbers.size(); ++p) poly_numbers[p] = s.first_poly + p;
  return records_of(s.mesh, std::move(s.global_vert), std::move(poly_numbers));
}

/// Some of the polys, in this order, and their verts.
inline poly_records selected_records(const poly_records& all, const std::vector<std::size_t>& polys, bool has_faces) {
  constexpr std::uint32_t none = ~0u;
  poly_records r;
  std::vector<std::uint32_t> new_vert(all.vert_numbers.size(), none);
  std::size_t num_words = 0, vert_count = 0;
  for (const std::size_t p : polys) {
    num_words += all.ends[p] - all.begin(p);
    all.for_each_vert(p, has_faces, [&](std::uint32_t v) { vert_count += std::exchange(new_vert[v], 0u) == none; });
  }
  r.reserve(polys.size(), vert_count, num_words);
  r.poly_values.reserve(polys.size() * all.poly_row()), r.vert_values.reserve(vert_count * all.vert_row());
  for (std::size_t v = 0; v < new_vert.size(); ++v) {
    if (new_vert[v] == none) continue;
    new_vert[v] = static_cast<std::uint32_t>(r.vert_numbers.size());
    r.append_vert(all, v);
  }
  for (const std::size_t p : polys) r.append(all, p, has_faces, [&](std::uint32_t v) { return new_vert[v]; });
  return r;
}

/// An element of one of several records.
struct record_place {
  std::uint64_t number;
  std::uint32_t part, index;
  bool operator<(const record_place& o) const { return number < o.number; }
};
/// The elements of all parts by their numbers, which are in one of the arrays.
inline std::vector<record_place> sorted_places(const std::vector<poly_records>& parts,
                                               std::vector<std::uint64_t> poly_records::*numbers) {
  std::vector<record_place> r;
  std::size_t count = 0;
  for (const poly_records& part : parts) count += (part.*numbers).size();
  r.reserve(count);
  for (std::uint32_t k = 0; k < parts.size(); ++k)
    for (std::uint32_t i = 0; const std::uint64_t number : parts[k].*numbers) r.push_back({number, k, i++});
  std::sort(r.begin(), r.end());
  return r;
}

/// All polys of several records, which have different ones, by their numbers. Arrays of the parts are freed as soon as
/// they are copied.
inline poly_records merged_records(std::vector<poly_records> parts, bool has_faces) {
  poly_records r;
  std::vector<std::vector<std::uint32_t>> new_vert(parts.size());
  std::vector<record_place> places = sorted_places(parts, &poly_records::vert_numbers);
  std::size_t vert_count = 0, word_count = 0, poly_row = 0, vert_row = 0;
  for (std::size_t k = 0; k < places.size(); ++k) vert_count += k == 0 || places[k - 1] < places[k];
  for (std::size_t k = 0; k < parts.size(); ++k) {
    new_vert[k].resize(parts[k].vert_numbers.size());
    word_count += parts[k].words.size();
    poly_row = std::max(poly_row, parts[k].poly_row()), vert_row = std::max(vert_row, parts[k].vert_row());
  }
  r.reserve(0, vert_count, 0);
  r.vert_values.reserve(vert_count * vert_row);
  for (const record_place& x : places) {
    if (r.vert_numbers.empty() || r.vert_numbers.back() != x.number) r.append_vert(parts[x.part], x.index);
    new_vert[x.part][x.index] = static_cast<std::uint32_t>(r.vert_numbers.size() - 1);
  }
  for (poly_records& part : parts) part.free_verts();
  places = sorted_places(parts, &poly_records::poly_numbers);
  r.reserve(places.size(), 0, word_count);
  r.poly_values.reserve(places.size() * poly_row);
  for (const record_place& x : places)
    r.append(parts[x.part], x.index, has_faces, [&](std::uint32_t v) { return new_vert[x.part][v]; });
  return r;
}

/// The arrays of a mesh of type M.
template<class M>
mesh_part<part_arrays<M>> part_of_records(poly_records&& r) {
  mesh_part<part_arrays<M>> part;
  part.vert_values = std::move(r.vert_values), part.poly_values = std::move(r.poly_values);
  part.vert_numbers = std::move(r.vert_numbers), part.vert_owners = std::move(r.vert_owners);
  part.poly_numbers = std::move(r.poly_numbers), part.poly_owners = std::move(r.poly_owners);
  if constexpr (from_polyhedra<M>) {
    face_soup soup;
    soup.reserve(r.ends.size(), r.words.size() / 4, r.words.size());
    for (std::size_t p = 0, at = 0; p < r.ends.size(); ++p) {
      while (at < r.ends[p]) {
        for (std::uint32_t n = r.words[at++]; n > 0; --n) soup.face_verts.push_back(vert_id{r.words[at++]});
        soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
      }
      soup.poly_offsets.push_back(static_cast<std::uint32_t>(soup.face_offsets.size() - 1));
    }
    std::vector<std::uint32_t>().swap(r.words);
    part.arrays = std::move(soup).unite(std::move(r.points));
  } else {
    part.arrays.points = std::move(r.points);
    part.arrays.arity = static_cast<std::uint32_t>(arity_v<M>);
    part.arrays.verts.reserve(r.words.size());
    for (const std::uint32_t v : r.words) part.arrays.verts.push_back(vert_id{v});
    std::vector<std::uint32_t>().swap(r.words);
    if constexpr (from_surface<M>)
      if (arity_v<M> == 0) {
        part.arrays.offsets.reserve(r.ends.size() + 1);
        part.arrays.offsets.push_back(0);
        for (const std::size_t end : r.ends) part.arrays.offsets.push_back(static_cast<std::uint32_t>(end));
      }
  }
  return part;
}

}  // namespace concino::detail
