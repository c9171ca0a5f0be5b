// The course's own structures, each twice: with the default triangle and with the textbook's in float.
#include "chapters/16_comparison/contest.hpp"
#include "chapters/16_comparison/plain_triangle.hpp"
#include "chapters/16_comparison/taught.hpp"

#include <cstdint>
#include <type_traits>

namespace course {
namespace {

// T is what the rays are computed in.
template <class X, class T> class Ours final : public Contestant {
  public:
    explicit Ours(std::span<const Triangle<>> triangles) : built_(around(triangles)) {}

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = closest_hit(as_ray(rays[i]), built_);
            found[i] = {static_cast<double>(hit.t), hit.id};
        }
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        for (std::size_t i = 0; i < rays.size(); ++i)
            blocked[i] = any_hit(as_ray(rays[i]), built_);
    }
    std::size_t bytes() const override { return course::bytes(built_); }
    Counts steps(std::span<const TestRay> rays, bool shadow) const override {
        Counts counts;
        for (const TestRay &ray : rays) {
            const Counted<Ray<T>> counted{as_ray(ray), &counts};
            if (shadow)
                any_hit(counted, built_);
            else
                closest_hit(counted, built_);
        }
        return counts;
    }

  private:
    using Shape = typename X::Shape;

    static Ray<T> as_ray(const TestRay &ray) { return {Vec<T>(ray.origin), Vec<T>(ray.direction), 0, T(ray.t_max)}; }

    static X around(std::span<const Triangle<>> triangles) {
        if constexpr (std::is_same_v<Shape, Triangle<>>)
            return X(triangles);
        else {
            std::vector<Shape> copies;
            copies.reserve(triangles.size());
            for (const Triangle<> &triangle : triangles)
                copies.push_back({triangle});
            return X(std::span<const Shape>(copies));
        }
    }

    X built_;
};

// Chapter 10's grid with 4 cells for each triangle, not the notes' 27: fewer steps, more tests, and in all faster.
template <class S> struct CoarseGrid : Grid<S> {
    explicit CoarseGrid(std::span<const S> given) : Grid<S>(given, CellsPerShape{.cells = 4}) {}
};

template <template <class> class X> void enter(std::vector<Entrant> &list, const Named<X> &named) {
    Entrant entrant{std::string(named.name), "default",
                    [](std::span<const Triangle<>> triangles) -> std::unique_ptr<Contestant> {
                        return std::make_unique<Ours<X<Triangle<>>, double>>(triangles);
                    }};
    list.push_back(entrant);
    entrant.kernel = "plain";
    entrant.build = [](std::span<const Triangle<>> triangles) -> std::unique_ptr<Contestant> {
        return std::make_unique<Ours<X<PlainTriangle<>>, float>>(triangles);
    };
    list.push_back(entrant);
}

} // namespace

std::vector<Entrant> our_structures() {
    std::vector<Entrant> list;
    std::apply([&](const auto &...named) { (enter(list, named), ...); }, structures_of_16);
    enter(list, Named<CoarseGrid>{"grid-4"});
    return list;
}

} // namespace course
