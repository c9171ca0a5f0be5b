#include "tests/hard_cases/structures.hpp"
#include "chapters/15_wide_bvh/taught.hpp"

#include <algorithm>
#include <tuple>

namespace course::hard {
namespace {

template <class AnyScene> class BuiltScene final : public Built {
  public:
    explicit BuiltScene(AnyScene scene) : scene_(std::move(scene)) {}

    Hit<double> closest(const Ray<double> &ray) const override { return closest_hit(ray, scene_); }
    bool any(const Ray<double> &ray) const override { return any_hit(ray, scene_); }
    std::size_t count(const Ray<double> &ray) const override {
        std::vector<Id> met;
        for_each_shape(scene_, [&](const auto &structure) {
            auto search = with_shear(ray);
            traverse(search, structure, [&](Id slot) {
                if (intersect(search, structure.shapes[slot]))
                    met.push_back(structure.shapes.first_id(slot));
                return false;
            });
        });
        std::ranges::sort(met);
        return static_cast<std::size_t>(std::ranges::unique(met).begin() - met.begin());
    }

  private:
    AnyScene scene_;
};

} // namespace

const std::vector<NamedStructure> &all_structures() {
    const auto enter = [](const auto &one) {
        return NamedStructure{std::string(one.name), [one](const std::vector<Triangle<>> &triangles) {
                                  return std::make_unique<const BuiltScene<decltype(one.around(Scene(triangles)))>>(
                                      one.around(Scene(triangles)));
                              }};
    };
    // A chapter that adds a structure brings a newer list, which is named here.
    static const std::vector<NamedStructure> all =
        std::apply([&](const auto &...one) { return std::vector<NamedStructure>{enter(one)...}; }, structures_of_15);
    return all;
}

} // namespace course::hard
