// Adapter for ray casting by Intel Embree 3: pass `embree{}` as the ray tracer of an algorithm.
// Needs: Embree 3 (Debian: libembree-dev), and a processor with SSE2.
#pragma once

#include <concino/core/error.hpp>
#include <concino/render/ray_caster.hpp>

#include <embree3/rtcore.h>

#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

namespace concino {

/// Triangles in an Embree scene. Movable; several threads may use it at the same time.
class embree_caster {
  struct release {
    void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
    void operator()(RTCScene s) const { rtcReleaseScene(s); }
    void operator()(RTCGeometry g) const { rtcReleaseGeometry(g); }
  };
  template<class T>
  using handle = std::unique_ptr<std::remove_pointer_t<T>, release>;

  handle<RTCDevice> device_;  // before the scene, so that it is destroyed after it
  handle<RTCScene> scene_;

  static void check(RTCDevice device, const char* doing) {
    switch (rtcGetDeviceError(device)) {
      case RTC_ERROR_NONE:
        return;
      case RTC_ERROR_OUT_OF_MEMORY:
        throw std::bad_alloc();
      case RTC_ERROR_UNSUPPORTED_CPU:
        core::throw_joined<unsupported>({"embree: ", doing, ": this processor is not supported, it needs SSE2"});
      case RTC_ERROR_INVALID_ARGUMENT:
        core::throw_joined<invalid_argument>({"embree: ", doing, ": invalid argument"});
      default:
        core::throw_joined<unsupported>({"embree: ", doing, ": failed inside Embree"});
    }
  }

  template<class T>
  static void fill(RTCDevice device, RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                   const std::vector<T>& data) {
    if (data.empty()) return;
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), data.size());
    check(device, "creating a buffer");
    if (!buffer) throw std::bad_alloc();
    std::memcpy(buffer, data.data(), data.size() * sizeof(T));
  }

 public:
  /// Needs:  finite points; indices below the number of points.
  /// Result: the same hits on every run, unless the build is parallel: Embree then groups the triangles in another
  ///         order each time, and a ray through a shared edge may hit either triangle.
  /// Cost:   O(n log n), on one core, or with all cores if the build is parallel.
  /// Errors: unsupported if Embree cannot run here, std::bad_alloc.
  explicit embree_caster(const triangle_soup& soup, bool parallel_build = false)
      : device_(rtcNewDevice(parallel_build ? nullptr : "threads=1")) {
    check(device_.get(), "starting");
    if (!device_) throw unsupported("embree: Embree cannot be started: rtcNewDevice returns no device");
    scene_.reset(rtcNewScene(device_.get()));
    check(device_.get(), "creating a scene");
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);  // so that no ray passes between two adjacent triangles
    if (!soup.triangles.empty()) {
      const handle<RTCGeometry> geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
      check(device_.get(), "creating a geometry");
      fill(device_.get(), geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, soup.points);
      fill(device_.get(), geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, soup.triangles);
      rtcCommitGeometry(geometry.get());
      rtcAttachGeometry(scene_.get(), geometry.get());
    }
    rtcCommitScene(scene_.get());
    check(device_.get(), "building");
  }

  ray_hit intersect(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    query.ray = ray(origin, direction, t_near, t_far);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.primID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {query.hit.primID, static_cast<double>(query.hit.u), static_cast<double>(query.hit.v),
            static_cast<double>(query.ray.tfar)};
  }

  bool occluded(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = ray(origin, direction, t_near, t_far);
    rtcOccluded1(scene_.get(), &context, &query);
    return query.tfar < 0;  // Embree's result for a hit
  }

 private:
  static RTCRay ray(const vec3& origin, const vec3& direction, double t_near, double t_far) {
    RTCRay r{};
    r.org_x = static_cast<float>(origin.x);
    r.org_y = static_cast<float>(origin.y);
    r.org_z = static_cast<float>(origin.z);
    r.dir_x = static_cast<float>(direction.x);
    r.dir_y = static_cast<float>(direction.y);
    r.dir_z = static_cast<float>(direction.z);
    r.tnear = static_cast<float>(t_near);
    r.tfar = static_cast<float>(t_far);
    r.mask = ~0u;
    return r;
  }
};

/// The ray tracer to pass to render, best_view and ambient_occlusion.
struct embree {
  bool parallel_build = false;  // uses all cores to prepare for rays; pictures may then differ at single pixels from
                                // run to run

  embree_caster build(const triangle_soup& soup) const { return embree_caster(soup, parallel_build); }
};

static_assert(RayCaster<embree_caster> && RayTracer<embree>);

}  // namespace concino
