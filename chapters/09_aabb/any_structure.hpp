// Lesson 09, step 8b: a structure that is chosen when the program runs. What is built upon it need not be compiled anew
// for each structure; each ray pays a virtual call.
#pragma once
#include "chapters/09_aabb/accelerate.hpp"
#include "chapters/09_aabb/counters.hpp"
#include "chapters/09_aabb/structure.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

namespace course {

// Any structure over triangles, itself a shape: searches ask it as they ask the structure inside.
class AnyStructure {
  public:
    template <Structure X> explicit AnyStructure(X structure)
        : held_(std::make_shared<const Held<X>>(std::move(structure))) {}

    struct Questions {
        virtual ~Questions() = default;
        virtual Id size() const = 0;
        virtual Hit<double> closest(const Ray<double> &ray) const = 0;
        virtual Hit<double> closest(const CountedRay<> &ray) const = 0;
        virtual bool any(const Ray<double> &ray) const = 0;
        virtual const Triangle<> &triangle(Id id) const = 0;
    };
    const Questions *operator->() const { return held_.get(); }

  private:
    template <class X> struct Held final : Questions {
        X structure;

        explicit Held(X given) : structure(std::move(given)) {}
        Id size() const override { return course::size(structure); }
        Hit<double> closest(const Ray<double> &ray) const override { return closest_hit(ray, structure); }
        Hit<double> closest(const CountedRay<> &ray) const override { return closest_hit(ray, structure); }
        bool any(const Ray<double> &ray) const override { return any_hit(ray, structure); }
        const Triangle<> &triangle(Id id) const override { return structure.shapes[structure.shapes.find(id).slot]; }
    };

    std::shared_ptr<const Questions> held_;
};

inline Id size(const AnyStructure &structure) { return structure->size(); }

// R is Ray<double> or CountedRay<>.
template <class R> Hit<double> closest_hit(const R &ray, const AnyStructure &structure) {
    return structure->closest(ray);
}

template <class R> bool any_hit(const R &ray, const AnyStructure &structure) { return structure->any(ray); }

template <class R, class F, class... Context>
auto with_hit(const R &ray, const Hit<double> &hit, const AnyStructure &structure, F &&f, const Context &...context) {
    return f(surface(ray, hit.t, structure->triangle(hit.id)), context...);
}

// The structure of that name over the triangles; the name is one of the list's.
template <class... Names> AnyStructure any_structure(const std::tuple<Names...> &structures, std::string_view name,
                                                     std::span<const Triangle<>> triangles) {
    std::optional<AnyStructure> chosen;
    const auto try_one = [&]<template <class> class X>(const Named<X> &one) {
        if (one.name == name)
            chosen.emplace(X<Triangle<>>(triangles));
    };
    std::apply([&](const auto &...one) { (try_one(one), ...); }, structures);
    return chosen.value();
}

} // namespace course
