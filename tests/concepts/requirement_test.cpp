// Lists of requirements, also nested ones, are checked in order up to the first that does not hold.
#include <concino/concepts/requirement.hpp>

#include <doctest/doctest.h>

namespace {

using namespace concino::requirement;

struct number_requirement {
  template<class T> static constexpr bool holds = requires(T x) { x + 1; };
};
struct small_requirement {
  template<class T> static constexpr bool holds = sizeof(T) < 8;  // an error for incomplete types
};
struct whole_requirement {
  template<class T> static constexpr bool holds = requires(T x) { x % 2; };
};
using whole_number_requirements = list<list<number_requirement, small_requirement>, list<>, whole_requirement>;

static_assert(check<whole_number_requirements, int>::value && !check<whole_number_requirements, float>::value);
static_assert(std::is_same_v<first_missing<whole_number_requirements, int>, nothing_missing>);
static_assert(std::is_same_v<first_missing<whole_number_requirements, float>, whole_requirement>);
static_assert(std::is_same_v<first_missing<whole_number_requirements, double>, small_requirement>);
struct unknown;
static_assert(std::is_same_v<first_missing<whole_number_requirements, unknown&>, number_requirement>);
static_assert(check<list<>, int>::value && std::is_same_v<first_missing<list<>, int>, nothing_missing>);


// A base class of traits knows the types, whatever the mesh is.
static_assert(bound<whole_number_requirements, int>::holds<void> && !bound<whole_number_requirements, float>::holds<void>);

}  // namespace

TEST_CASE("lists of requirements are checked at compile time") { CHECK(check<list<number_requirement>, double>::value); }
