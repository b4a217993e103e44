// Quality and facts do not depend on the order in which a mesh is stored.
#include <concino/quality/poly_quality.hpp>
#include <concino/validate/validate.hpp>

#include <support/permuted.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("quality and facts do not depend on storage", M, CONCINO_KINDS) {
  for_each_stored_mesh<M>([](const storage_check<M>& check) {
    using s = stored_mesh<M>;
    for (std::size_t k = 0; k < num_metrics; ++k) {
      const auto what = static_cast<metric>(k);
      const M& m = check.original().mesh;
      if (!is_defined(what, shape_of_poly(m, poly_id{0}))) continue;
      bool all = true;
      for (const poly_id p : polys(m)) all = all && is_defined(what, shape_of_poly(m, p));
      if (all) check.at_polys(std::string(name_of(what)), [&](const s& x) { return quality(x.mesh, what); });
    }
    check.number("facts", [](const s& x) {
      const mesh_facts f = validate(x.mesh).facts;
      return std::vector<double>{double(f.manifold), double(f.orientable), double(f.closed), double(f.components), double(f.boundary_loops),
                                 double(f.euler_characteristic), f.genus ? double(*f.genus) : -1};
    });
  });
}
