// Embree as a peer: with its default flags, with its robust ones, and held to AVX2, its fastest choice on some
// machines; one ray a call, and by its calls that take many.
#include "chapters/16_comparison/contest.hpp"
#include "common/errors.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <array>
#include <cstring>

namespace course {
namespace {

// What a call is told about its rays, in Embree 3 and in Embree 4.
class Advice {
  public:
    explicit Advice([[maybe_unused]] bool coherent) {
#if RTC_VERSION_MAJOR < 4
        rtcInitIntersectContext(&closest);
        closest.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        any = closest;
#else
        rtcInitIntersectArguments(&closest);
        rtcInitOccludedArguments(&any);
        closest.flags = any.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
#endif
    }
#if RTC_VERSION_MAJOR < 4
    RTCIntersectContext closest, any;
#else
    RTCIntersectArguments closest;
    RTCOccludedArguments any;
#endif
};

// A scene that Embree has built. What follows are its calls.
class Embree : public Contestant {
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

    std::size_t bytes() const override { return bytes_; }

  protected:
    RTCScene scene() const { return scene_; }

    static RTCRay as_ray(const TestRay &ray) {
        RTCRay result{};
        result.org_x = ray.origin.x, result.org_y = ray.origin.y, result.org_z = ray.origin.z;
        result.dir_x = ray.direction.x, result.dir_y = ray.direction.y, result.dir_z = ray.direction.z;
        result.tfar = ray.t_max;
        result.mask = ~0u;
        return result;
    }
    static RTCRayHit as_query(const TestRay &ray) {
        RTCRayHit query;
        query.ray = as_ray(ray);
        query.hit.geomID = query.hit.primID = RTC_INVALID_GEOMETRY_ID;
        return query;
    }
    static Hit<double> as_hit(unsigned geometry, float t, unsigned primitive) {
        return geometry == RTC_INVALID_GEOMETRY_ID ? Hit<double>{} : Hit<double>{static_cast<double>(t), primitive};
    }

  private:
    std::size_t bytes_ = 0; // as Embree's own memory monitor counts it
    RTCDevice device_;
    RTCScene scene_;
};

class OneByOne final : public Embree {
  public:
    using Embree::Embree;

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        Advice advice(false);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit query = as_query(rays[i]);
#if RTC_VERSION_MAJOR < 4
            rtcIntersect1(scene(), &advice.closest, &query);
#else
            rtcIntersect1(scene(), &query, &advice.closest);
#endif
            found[i] = as_hit(query.hit.geomID, query.ray.tfar, query.hit.primID);
        }
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        Advice advice(false);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRay query = as_ray(rays[i]);
#if RTC_VERSION_MAJOR < 4
            rtcOccluded1(scene(), &advice.any, &query);
#else
            rtcOccluded1(scene(), &query, &advice.any);
#endif
            blocked[i] = query.tfar < 0;
        }
    }
};

// Embree's packets by how many rays they hold.
template <unsigned N> struct Packet;
template <> struct Packet<8> {
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
    static constexpr auto closest = rtcIntersect8;
    static constexpr auto any = rtcOccluded8;
};
template <> struct Packet<16> {
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
    static constexpr auto closest = rtcIntersect16;
    static constexpr auto any = rtcOccluded16;
};

// N rays a call, as they come; the last call may have fewer.
template <unsigned N, bool Coherent> class Packets final : public Embree {
  public:
    using Embree::Embree;

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        Advice advice(Coherent);
        for (std::size_t first = 0; first < rays.size(); first += N) {
            const auto some = rays.subspan(first, std::min<std::size_t>(N, rays.size() - first));
            typename Packet<N>::RayHit query{};
            const Valid valid = fill(query.ray, some);
            for (unsigned i = 0; i < N; ++i)
                query.hit.geomID[i] = query.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR < 4
            Packet<N>::closest(valid.of_lane.data(), scene(), &advice.closest, &query);
#else
            Packet<N>::closest(valid.of_lane.data(), scene(), &query, &advice.closest);
#endif
            for (std::size_t i = 0; i < some.size(); ++i)
                found[first + i] = as_hit(query.hit.geomID[i], query.ray.tfar[i], query.hit.primID[i]);
        }
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        Advice advice(Coherent);
        for (std::size_t first = 0; first < rays.size(); first += N) {
            const auto some = rays.subspan(first, std::min<std::size_t>(N, rays.size() - first));
            typename Packet<N>::Ray query{};
            const Valid valid = fill(query, some);
#if RTC_VERSION_MAJOR < 4
            Packet<N>::any(valid.of_lane.data(), scene(), &advice.any, &query);
#else
            Packet<N>::any(valid.of_lane.data(), scene(), &query, &advice.any);
#endif
            for (std::size_t i = 0; i < some.size(); ++i)
                blocked[first + i] = query.tfar[i] < 0;
        }
    }

  private:
    struct alignas(64) Valid {
        std::array<int, N> of_lane{}; // -1 where there is a ray
    };
    static Valid fill(typename Packet<N>::Ray &query, std::span<const TestRay> rays) {
        Valid valid;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto &[origin, direction, t_max] = rays[i];
            query.org_x[i] = origin.x, query.org_y[i] = origin.y, query.org_z[i] = origin.z;
            query.dir_x[i] = direction.x, query.dir_y[i] = direction.y, query.dir_z[i] = direction.z;
            query.tfar[i] = t_max;
            query.mask[i] = ~0u;
            valid.of_lane[i] = -1;
        }
        return valid;
    }
};

#if RTC_VERSION_MAJOR < 4
// A stream of single rays a call. Embree 4 has it no more.
template <bool Coherent> class Streams final : public Embree {
  public:
    using Embree::Embree;

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        Advice advice(Coherent);
        std::array<RTCRayHit, at_once> queries;
        for (std::size_t first = 0; first < rays.size(); first += at_once) {
            const auto some = rays.subspan(first, std::min(at_once, rays.size() - first));
            std::ranges::transform(some, queries.begin(), as_query);
            rtcIntersect1M(scene(), &advice.closest, queries.data(), static_cast<unsigned>(some.size()),
                           sizeof(RTCRayHit));
            for (std::size_t i = 0; i < some.size(); ++i)
                found[first + i] = as_hit(queries[i].hit.geomID, queries[i].ray.tfar, queries[i].hit.primID);
        }
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        Advice advice(Coherent);
        std::array<RTCRay, at_once> queries;
        for (std::size_t first = 0; first < rays.size(); first += at_once) {
            const auto some = rays.subspan(first, std::min(at_once, rays.size() - first));
            std::ranges::transform(some, queries.begin(), as_ray);
            rtcOccluded1M(scene(), &advice.any, queries.data(), static_cast<unsigned>(some.size()), sizeof(RTCRay));
            for (std::size_t i = 0; i < some.size(); ++i)
                blocked[first + i] = queries[i].tfar < 0;
        }
    }

  private:
    static constexpr std::size_t at_once = 64;
};
#endif

template <class Calls = OneByOne>
Entrant embree(const std::string &name, const std::string &config, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE) {
    return {name, "own",
            [=](std::span<const Triangle<>> triangles) -> std::unique_ptr<Contestant> {
                return std::make_unique<Calls>(triangles, config, flags);
            },
            !std::is_same_v<Calls, OneByOne>};
}

// The calls that take many rays, each with either advice.
void enter_batches(std::vector<Entrant> &list, const std::string &name, const std::string &config) {
    list.push_back(embree<Packets<8, true>>(name + "-8-coherent", config));
    list.push_back(embree<Packets<8, false>>(name + "-8", config));
    list.push_back(embree<Packets<16, true>>(name + "-16-coherent", config));
    list.push_back(embree<Packets<16, false>>(name + "-16", config));
#if RTC_VERSION_MAJOR < 4
    list.push_back(embree<Streams<true>>(name + "-stream-coherent", config));
    list.push_back(embree<Streams<false>>(name + "-stream", config));
#endif
}

} // namespace

std::vector<Entrant> embree_contestants() {
    const std::string one_core = "threads=1,user_threads=0";
    std::vector<Entrant> list{embree("embree", one_core), embree("embree-robust", one_core, RTC_SCENE_FLAG_ROBUST)};
    enter_batches(list, "embree", one_core);
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2")) {
        list.push_back(embree("embree-avx2", one_core + ",isa=avx2"));
        enter_batches(list, "embree-avx2", one_core + ",isa=avx2");
    }
#endif
    return list;
}

} // namespace course
