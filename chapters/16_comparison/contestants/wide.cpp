// Chapter 15 taken apart: the wide BVH with one step of the lesson left out each time, and with many rays in flight.
#include "chapters/15_wide_bvh/in_flight.hpp"
#include "chapters/15_wide_bvh/packet.hpp"
#include "chapters/16_comparison/contest.hpp"

namespace course {
namespace {

template <WideOptions Options> class Variant : public Contestant {
  public:
    explicit Variant(std::span<const Triangle<>> triangles) : bvh_(triangles) {}

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        std::ranges::transform(rays, found.begin(), [&](const TestRay &ray) { return closest_hit(wide(ray), bvh_); });
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        std::ranges::transform(rays, blocked.begin(), [&](const TestRay &ray) { return any_hit(wide(ray), bvh_); });
    }
    std::size_t bytes() const override { return course::bytes(bvh_); }

  protected:
    static Ray<double> wide(const TestRay &ray) {
        return {Vec<double>(ray.origin), Vec<double>(ray.direction), 0, static_cast<double>(ray.t_max)};
    }

    WideBvhBy<Triangle<>, Options> bvh_;
};

// Many rays in flight; each is made when its turn comes.
template <std::size_t Width, WideOptions Options = WideOptions{}> class Flying final : public Variant<Options> {
  public:
    using Variant<Options>::Variant;

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        trace(rays, false, [&](std::size_t i, const Hit<double> &hit) { found[i] = hit; });
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        trace(rays, true, [&](std::size_t i, const Hit<double> &hit) { blocked[i] = bool(hit); });
    }

  private:
    template <class Done> void trace(std::span<const TestRay> rays, bool any, const Done &done) const {
        InFlight<double, Options, Width> flights(this->bvh_);
        flights(
            rays.size(), [&](std::size_t i) { return this->wide(rays[i]); }, any, done);
    }
};

// Eight rays together, as they come.
class InPackets final : public Variant<WideOptions{}> {
  public:
    using Variant::Variant;

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        trace(rays, [&](std::span<const Ray<double>> some, std::size_t first) {
            closest_hits(some, bvh_, found.subspan(first, some.size()));
        });
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        trace(rays, [&](std::span<const Ray<double>> some, std::size_t first) {
            std::array<bool, lanes> hits;
            any_hits(some, bvh_, std::span(hits).first(some.size()));
            std::copy_n(hits.begin(), some.size(), blocked.subspan(first).begin());
        });
    }

  private:
    template <class Each> static void trace(std::span<const TestRay> rays, const Each &each) {
        std::array<Ray<double>, lanes> packet;
        for (std::size_t first = 0; first < rays.size(); first += lanes) {
            const auto some = rays.subspan(first, std::min<std::size_t>(lanes, rays.size() - first));
            std::ranges::transform(some, packet.begin(), wide);
            each(std::span<const Ray<double>>(packet).first(some.size()), first);
        }
    }
};

template <class X> Entrant variant(const std::string &name) {
    return {"wide-" + name, "default",
            [](std::span<const Triangle<>> triangles) -> std::unique_ptr<Contestant> {
                return std::make_unique<X>(triangles);
            },
            true};
}

} // namespace

std::vector<Entrant> wide_variants() {
    using enum WideOptions::Collapse;
    constexpr WideOptions compact{.leaf = WideOptions::Leaf::compact};
    return {variant<Variant<WideOptions{.collapse = greedy}>>("greedy"),
            variant<Variant<WideOptions{.leaf = WideOptions::Leaf::one_by_one}>>("one-by-one"),
            variant<Variant<WideOptions{.order = WideOptions::Order::distance}>>("by-distance"),
            variant<Variant<WideOptions{.two_nodes = false}>>("one-node"),
            variant<Variant<WideOptions{.two_nodes = false, .one_hit_path = true}>>("one-hit-path"),
            variant<Variant<WideOptions{.any_hit_loop = false}>>("without-any-hit"),
            variant<Variant<WideOptions{.quick_t = false}>>("confirming"),
            variant<Variant<compact>>("compact"),
            variant<InPackets>("packets"),
            variant<Flying<8>>("8-in-flight"),
            variant<Flying<16>>("16-in-flight"),
            variant<Flying<32>>("32-in-flight"),
            variant<Flying<32, compact>>("compact-32-in-flight")};
}

} // namespace course
