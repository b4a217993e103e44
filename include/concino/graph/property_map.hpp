// as_map(pm): a Boost property map, from a library built on Boost.Graph, as a concino map. as_map(pm)[x] calls get and
// put. Not part of <concino/graph.hpp>, which includes nothing of Boost.
#pragma once

#include <concino/concepts/maps.hpp>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace concino {

namespace requirement {

template<class P> concept is_property_map = requires { typename boost::property_traits<P>::category; };

}  // namespace requirement

/// A proxy for pm[x], for property maps that return no reference.
template<class P>
class property_map_value {
  using traits = boost::property_traits<P>;
  P map_;
  typename traits::key_type x_;

 public:
  property_map_value(const P& map, const typename traits::key_type& x) : map_(map), x_(x) {}
  operator typename traits::value_type()
      const requires std::derived_from<typename traits::category, boost::readable_property_map_tag> {
    using boost::get;
    return get(map_, x_);
  }
  property_map_value& operator=(const typename traits::value_type& value) {
    using boost::put;
    put(map_, x_, value);
    return *this;
  }
};

/// A property map of Boost with operator[].
template<requirement::is_property_map P>
class property_map_as_map {
  using category = typename boost::property_traits<P>::category;
  P map_;

 public:
  using key_type = typename boost::property_traits<P>::key_type;
  using value_type = typename boost::property_traits<P>::value_type;

  explicit property_map_as_map(P map) : map_(std::move(map)) {}
  decltype(auto) operator[](const key_type& x) const {
    using boost::get;
    constexpr bool gives_references = std::derived_from<category, boost::lvalue_property_map_tag>;
    if constexpr (gives_references && requires { map_[x]; }) return map_[x];
    else if constexpr (gives_references || !std::derived_from<category, boost::writable_property_map_tag>)
      return get(map_, x);
    else return property_map_value<P>(map_, x);
  }
};

/// Needs:  a property map of Boost, which is cheap to copy. Maps that have pm[x], such as those of CGAL::Surface_mesh,
///         are maps already.
/// Result: a ReadableMap if pm is readable, a WritableMap if pm is writable or an lvalue map.      Cost: none; nothing
///         is copied but pm.
/// Errors: none of its own.
template<requirement::is_property_map P>
auto as_map(const P& pm) { return property_map_as_map<P>(pm); }

}  // namespace concino
