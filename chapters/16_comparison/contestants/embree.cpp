// Embree as a peer: with its default flags, with its robust ones, and held to AVX2, its fastest choice on some
// machines.
#include "chapters/16_comparison/contest.hpp"
#include "common/errors.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstring>

namespace course {
namespace {

class Embree final : public Contestant {
  public:
    Embree(std::span<const Triangle<>> triangles, const std::string &config, RTCSceneFlags flags)
        : device_(rtcNewDevice(config.c_str())), scene_(rtcNewScene(device_)) {
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void *sum, ssize_t change, bool) {
                *static_cast<std::size_t *>(sum) += static_cast<std::size_t>(change);
                return true;
            },
            &bytes_);
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto *points = static_cast<float *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
        auto *indices = static_cast<unsigned *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
        static_assert(sizeof(Triangle<>) == 9 * sizeof(float));
        std::memcpy(points, triangles.data(), triangles.size_bytes());
        for (unsigned i = 0; i < 3 * triangles.size(); ++i)
            indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Embree() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree &) = delete;
    Embree &operator=(const Embree &) = delete;

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
#if RTC_VERSION_MAJOR < 4
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
#endif
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit query;
            query.ray = as_ray(rays[i]);
            query.hit.geomID = query.hit.primID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR < 4
            rtcIntersect1(scene_, &context, &query);
#else
            rtcIntersect1(scene_, &query);
#endif
            found[i] = query.hit.geomID == RTC_INVALID_GEOMETRY_ID
                           ? Hit<double>{}
                           : Hit<double>{static_cast<double>(query.ray.tfar), query.hit.primID};
        }
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
#if RTC_VERSION_MAJOR < 4
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
#endif
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRay query = as_ray(rays[i]);
#if RTC_VERSION_MAJOR < 4
            rtcOccluded1(scene_, &context, &query);
#else
            rtcOccluded1(scene_, &query);
#endif
            blocked[i] = query.tfar < 0;
        }
    }
    std::size_t bytes() const override { return bytes_; }

  private:
    static RTCRay as_ray(const TestRay &ray) {
        RTCRay result{};
        result.org_x = ray.origin.x, result.org_y = ray.origin.y, result.org_z = ray.origin.z;
        result.dir_x = ray.direction.x, result.dir_y = ray.direction.y, result.dir_z = ray.direction.z;
        result.tfar = ray.t_max;
        result.mask = ~0u;
        return result;
    }

    std::size_t bytes_ = 0; // as Embree's own memory monitor counts it
    RTCDevice device_;
    RTCScene scene_;
};

Entrant embree(const std::string &name, const std::string &config, RTCSceneFlags flags) {
    return {name, "own", [=](std::span<const Triangle<>> triangles) -> std::unique_ptr<Contestant> {
                return std::make_unique<Embree>(triangles, config, flags);
            }};
}

} // namespace

std::vector<Entrant> embree_contestants() {
    const std::string one_core = "threads=1,user_threads=0";
    std::vector<Entrant> list{embree("embree", one_core, RTC_SCENE_FLAG_NONE),
                              embree("embree-robust", one_core, RTC_SCENE_FLAG_ROBUST)};
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2"))
        list.push_back(embree("embree-avx2", one_core + ",isa=avx2", RTC_SCENE_FLAG_NONE));
#endif
    return list;
}

} // namespace course
