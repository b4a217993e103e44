// The concepts of maps: models and non-models.
#include <concino/concepts/maps.hpp>

#include <concino/concepts/descriptors.hpp>

#include <doctest/doctest.h>

#include <map>
#include <vector>

namespace cn = concino;

namespace {

struct heights {  // read only
  double operator[](cn::vert_id v) const { return v.raw() * 0.5; }
};
struct proxy_map {  // written through a proxy
  std::vector<bool> bits = std::vector<bool>(4);
  auto operator[](cn::vert_id v) { return bits[v.raw()]; }
  bool operator[](cn::vert_id v) const { return bits[v.raw()]; }
};

static_assert(cn::ReadableMap<heights, cn::vert_id> && cn::ReadableMap<const heights&, cn::vert_id> &&
              !cn::ReadableMap<heights, cn::poly_id>);
static_assert(!cn::WritableMap<heights, cn::vert_id, double>);
static_assert(cn::WritableMap<proxy_map&, cn::vert_id, bool> && cn::WritableMap<proxy_map, cn::vert_id, bool> &&
              !cn::WritableMap<const proxy_map, cn::vert_id, bool>);
static_assert(cn::WritableMap<std::map<cn::vert_id, double>, cn::vert_id, double>);
static_assert(!cn::ReadableMap<int, cn::vert_id> && !cn::ReadableMap<std::vector<double>, cn::vert_id>);

}  // namespace

TEST_CASE("maps are read and written by operator[]") {
  CHECK(heights()[cn::vert_id{3}] == 1.5);
  proxy_map m;
  m[cn::vert_id{2}] = true;
  CHECK(static_cast<const proxy_map&>(m)[cn::vert_id{2}]);
}
