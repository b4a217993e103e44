// One call of TetGen: its output or error.
#pragma once

#include <concino/adapters/detail/tetgen_child.hpp>
#include <concino/adapters/detail/tetgen_input.hpp>
#include <concino/core/error.hpp>

#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <vector>

namespace concino::detail {

class tetgen_call {
  const tetrahedralize_input& input_;
  const tetrahedralize_options& options_;

  /// Returns 0, or the number of TetGen's error.
  int run(tetgenio& out) const {
    try {
      tetgenio in;
      const tetgen_input given{input_, options_};
      given.fill(in);
      std::string s = given.switches();
      ::tetrahedralize(s.data(), &in, &out);
      return 0;
    } catch (int code) {
      return code == 0 ? 2 : code;
    } catch (const std::bad_alloc&) {
      return 1;
    }
  }

  [[noreturn]] static void throw_error(int code) {
    const char* reasons[] = {"",
                             "ran out of memory, or of max_bytes",
                             "had an internal error",
                             "found an intersection",
                             "found a feature that is too small for its precision",
                             "found two facets that nearly coincide",
                             "",
                             "",
                             "",
                             "",
                             "refused its input",
                             "was ended by an exception of options.edge_length"};
    const bool known = code > 0 && code <= callback_failed && reasons[code][0] != '\0';
    core::throw_joined<unsupported>({"tetrahedralize: TetGen ", known ? reasons[code] : "ended without a result",
                                     "; keep_boundary = false or another back end may help"});
  }

 public:
  tetgen_call(const tetrahedralize_input& input, const tetrahedralize_options& options)
      : input_(input), options_(options) {}

  tetrahedralize_output here() const {
    tetgenio out;
    if (const int code = run(out); code != 0) throw_error(code);
    const sizes n(out);
    const void* const arrays[] = {out.pointlist, out.tetrahedronlist, out.trifacelist, out.trifacemarkerlist};
    return output_of(n, [&, k = 0](void* to, std::size_t bytes) mutable {
      if (bytes > 0) std::memcpy(to, arrays[k], bytes);
      ++k;
    });
  }

  tetrahedralize_output in_child() const {
    const memory_file file("tetrahedralize");
    run_in_child("tetrahedralize", "TetGen", {options_.max_seconds, options_.max_bytes, options_.progress}, [&] {
      tetgenio out;
      sizes n;
      try {
        n.error = run(out);
      } catch (...) {
        n.error = callback_failed;
      }
      if (n.error == 0) n = sizes(out);
      const auto write = [&](const void* from, std::size_t bytes) { return file.write(from, bytes); };
      if (write(&n, sizeof n) && n.error == 0 && write(out.pointlist, n.points * sizeof(vec3)) &&
          write(out.tetrahedronlist, n.tets * 4 * sizeof(int)) && write(out.trifacelist, n.facets * 3 * sizeof(int)))
        write(out.trifacemarkerlist, n.facets * sizeof(int));
      end_child();  // TetGen's destructors, which may crash, are not needed
    });
    sizes n;
    std::size_t offset = 0;
    const auto read = [&](void* to, std::size_t bytes) {
      if (!file.read(offset, to, bytes)) throw_error(no_result);
      offset += bytes;
    };
    read(&n, sizeof n);
    if (n.error != 0) throw_error(n.error);
    return output_of(n, read);
  }

 private:
  static constexpr int no_result = -1, callback_failed = 11;

  struct sizes {
    int error = 0;
    std::size_t points = 0, tets = 0, facets = 0;
    sizes() = default;
    explicit sizes(const tetgenio& out)
        : points(static_cast<std::size_t>(out.numberofpoints)), tets(static_cast<std::size_t>(out.numberoftetrahedra)),
          facets(static_cast<std::size_t>(out.numberoftrifaces)) {}
  };

  /// copy(to, bytes) gives the next array: points, tets, facets, markers.
  template<class Copy>
  tetrahedralize_output output_of(const sizes& n, Copy copy) const {
    static_assert(sizeof(vec3) == 3 * sizeof(double) && sizeof(int) == sizeof(std::uint32_t));
    tetrahedralize_output r;
    r.points.resize(n.points);
    copy(r.points.data(), n.points * sizeof(vec3));
    r.tets.resize(n.tets);
    copy(r.tets.data(), n.tets * 4 * sizeof(int));
    r.facets.resize(n.facets);
    copy(r.facets.data(), n.facets * 3 * sizeof(int));
    std::vector<int> markers(n.facets);
    copy(markers.data(), n.facets * sizeof(int));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n.facets; ++i) {
      // TetGen gives other faces of the hull -1 or 0
      if (markers[i] < 1 || static_cast<std::size_t>(markers[i]) > input_.triangles.size()) continue;
      r.facets[kept++] = r.facets[i];
      r.triangle_of_facet.push_back(static_cast<std::uint32_t>(markers[i] - 1));
    }
    r.facets.resize(kept);
    return r;
  }
};

}  // namespace concino::detail
