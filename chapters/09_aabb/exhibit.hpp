// Lesson 09, step 11: chapter 08's studio with its mesh in a structure. The picture is the same with each of them.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/08_mesh/load.hpp"
#include "chapters/08_mesh/normals.hpp"
#include "chapters/08_mesh/studio.hpp"
#include "chapters/09_aabb/any_structure.hpp"

#include <string>
#include <vector>

namespace course {

// The mesh of the file, or the bunny where no file is named, in the studio.
inline Studio studio_of(const std::string &file) {
    return studio(load_mesh(file.empty() ? find_bunny() : std::filesystem::path(file)));
}

// The studio's scene with this structure in place of its mesh, over the mesh's triangles; ids are the same.
template <class X> auto exhibit_with(X structure, const Studio &studio) {
    const auto &[meshes, tables] = studio.scene.shapes;
    std::vector<Object<X, Diffuse<>>> objects;
    objects.push_back({std::move(structure), meshes.front().material});
    return Scene(std::move(objects), tables);
}

template <template <class> class X> auto exhibit(const Studio &studio) {
    return exhibit_with(X<Triangle<>>(std::span<const Triangle<>>(triangles(studio.mesh()))), studio);
}

// In the structure of that name, one of the list's.
template <class... Names>
auto exhibit_in(const std::tuple<Names...> &structures, const std::string &name, const Studio &studio) {
    return exhibit_with(any_structure(structures, name, triangles(studio.mesh())), studio);
}

template <class AnyScene>
Colour exhibit_radiance(const Ray<double> &ray, const AnyScene &scene, const Studio &studio, Random &random) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return backdrop(ray.direction);
    return with_hit(ray, hit, scene, [&](const auto &surface, const auto &material) {
        const bool of_mesh = hit.id < size(studio.mesh());
        Vec<double> normal = of_mesh ? shading_normal(studio.mesh(), hit.id, surface.point) : surface.normal;
        if (dot(surface.normal, ray.direction) > 0)
            normal = -normal; // the side that is seen
        const Colour diffuse = value(material.diffuse, surface);
        return diffuse * ambient(normal) + direct_light(surface, normal, diffuse, scene, studio.lights, random);
    });
}

// The exhibit in the studio's light, as program.render() takes it.
template <class AnyScene> Renderer lit_exhibit(const AnyScene &scene, const Studio &studio, std::uint64_t seed) {
    return [&scene, &studio, seed](const Viewpoint &view, int width, int height) {
        return each_pixel([&scene, &studio, seed, camera = Camera(view, width, height)](int x, int y) {
            Random random(seed, static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x));
            return exhibit_radiance(camera.ray(x + 0.5, y + 0.5), scene, studio, random);
        });
    };
}

} // namespace course
