#pragma once

// Embree 3 (Debian 12) and 4 (Debian 13) under one set of names. Include it here only.
#if BRUME_EMBREE_MAJOR == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace brume {

enum class RayOrder { coherent, incoherent };

// The query that rays are traced with. A filter is called for every hit found, with this query as
// its context: a static_cast gives back the class derived from it.
#if BRUME_EMBREE_MAJOR == 3

constexpr RTCSceneFlags scene_flag_filter = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

struct RayQuery : RTCIntersectContext {
  explicit RayQuery(RayOrder order, RTCFilterFunctionN hit_filter = nullptr) {
    rtcInitIntersectContext(this);
    flags = order == RayOrder::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                        : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    filter = hit_filter;
  }

  void intersect(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, this, &ray); }
  void intersect(RTCScene scene, const int* valid, RTCRayHit16& rays) {
    rtcIntersect16(valid, scene, this, &rays);
  }
  void occluded(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, this, &ray); }
  void occluded(RTCScene scene, const int* valid, RTCRay16& rays) {
    rtcOccluded16(valid, scene, this, &rays);
  }
};

#else

constexpr RTCSceneFlags scene_flag_filter = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

struct RayQuery : RTCRayQueryContext {
  explicit RayQuery(RayOrder order, RTCFilterFunctionN hit_filter = nullptr) : filter(hit_filter) {
    rtcInitRayQueryContext(this);
    unsigned bits =
        order == RayOrder::coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    if (filter) bits |= RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    flags = static_cast<RTCRayQueryFlags>(bits);
  }

  void intersect(RTCScene scene, RTCRayHit& ray) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    rtcIntersect1(scene, &ray, complete(arguments));
  }
  void intersect(RTCScene scene, const int* valid, RTCRayHit16& rays) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    rtcIntersect16(valid, scene, &rays, complete(arguments));
  }
  void occluded(RTCScene scene, RTCRay& ray) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    rtcOccluded1(scene, &ray, complete(arguments));
  }
  void occluded(RTCScene scene, const int* valid, RTCRay16& rays) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    rtcOccluded16(valid, scene, &rays, complete(arguments));
  }

 private:
  template <class Arguments>
  Arguments* complete(Arguments& arguments) {
    arguments.flags = flags;
    arguments.context = this;
    arguments.filter = filter;
    return &arguments;
  }

  RTCRayQueryFlags flags;
  RTCFilterFunctionN filter;
};

#endif

}  // namespace brume
