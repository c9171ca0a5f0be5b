// Lesson 07, step 4: a disk with a hole, the rim of a drinking glass. A new shape, without a change to any old file.
#pragma once
#include "chapters/02_primitives/disk.hpp"
#include "chapters/03_light_and_shadow/spawn.hpp"

namespace course {

// The part of the disk that is at least `hole` away from its centre; both rims belong to it.
template <class S = float> struct Annulus {
    Disk<S> disk;
    S hole;
};

template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Annulus<S> &annulus) {
    const auto t = intersect(ray, annulus.disk);
    if (!t)
        return {};
    const Vec<double> from_centre = Vec<double>(point_at(ray, *t)) - Vec<double>(annulus.disk.centre);
    const double hole = static_cast<double>(annulus.hole);
    return dot(from_centre, from_centre) >= hole * hole ? t : std::nullopt;
}

template <class T, class S> Surface<T, Annulus<S>> surface(const Ray<T> &ray, T t, const Annulus<S> &annulus) {
    const auto on_disk = surface(ray, t, annulus.disk);
    return {on_disk.point, on_disk.normal, annulus};
}

template <class S> double spawn_offset(const Annulus<S> &annulus, const Vec<double> &point) {
    return spawn_offset(annulus.disk, point);
}

} // namespace course
