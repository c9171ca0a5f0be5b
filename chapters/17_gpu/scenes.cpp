#include "chapters/17_gpu/scenes.hpp"
#include "chapters/03_light_and_shadow/sundial.hpp"
#include "chapters/05_texture/textured_scene.hpp"
#include "chapters/06_whitted/mirror_scene.hpp"
#include "chapters/07_glass/glass_scenes.hpp"
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/17_gpu/pack.hpp"

namespace course {

namespace {

template <class AnyWorld> Exhibit exhibit_of(AnyWorld world, const Viewpoint &view, const Limits &limits) {
    world.limits = limits;
    return {pack(world), view,
            [world](const Ray<double> &ray, Random &random) { return radiance(ray, world, Path{}, random); }};
}

// Chapter 02's still life in its colours.
template <class... Shapes> auto painted(const Scene<Shapes...> &scene, const std::vector<Colour> &colours) {
    std::size_t next = 0;
    const auto paint_list = [&]<class Shape>(const std::vector<Shape> &shapes) {
        std::vector<Object<Shape, Facing<>>> objects;
        for (const Shape &shape : shapes)
            objects.push_back({shape, {colours[next]}});
        ++next;
        return objects;
    };
    return std::apply([&](const auto &...lists) { return Scene{paint_list(lists)...}; }, scene.shapes);
}
auto facing_still_life() {
    return World{painted(still_life(), {{0.42f, 0.45f, 0.52f},
                                        {0.85f, 0.50f, 0.13f},
                                        {0.10f, 0.42f, 0.50f},
                                        {0.85f, 0.82f, 0.74f},
                                        {0.66f, 0.10f, 0.07f},
                                        {0.08f, 0.19f, 0.46f},
                                        {0.80f, 0.76f, 0.70f},
                                        {0.22f, 0.45f, 0.17f},
                                        {0.80f, 0.30f, 0.22f}}),
                 Lights<PointLight>({}), ConstantSky{{0.012f, 0.014f, 0.02f}}};
}

// The drink of chapter 07 on its table cloth, under the evening sky.
auto evening_drink(std::uint64_t seed) {
    const Placed<Checker> cloth{
        {screen_colour(226, 218, 200), screen_colour(150, 172, 160)}, {0.2, 0.1}, {1.6, 0}, {0, 1.6}};
    const Object<Plane<>, Diffuse<Placed<Checker>>> table{{{0, 0, 0}, {0, 1, 0}}, {cloth}};
    return drink_world(juice, table, ImageSky{paint_evening(2048, {-0.5, 0.3, -1}, seed + 11)});
}

// Chapter 03's sundial under its soft lamp, a cell of it in each pass.
Exhibit soft_sundial(const Limits &limits, std::uint64_t seed) {
    const auto pass = std::make_shared<int>(0);
    const std::vector lamps{PassLight<Disk<>>{{lamp_disk, lamp_radiance, 8}, pass}};
    Exhibit exhibit = exhibit_of(
        World{sundial_scene(), Lights(lamps, std::vector{fill_light()}), ConstantSky{{0.010f, 0.014f, 0.026f}}},
        sundial_view, limits);
    exhibit.pass = pass;
    exhibit.scene.seed = seed;
    return exhibit;
}

} // namespace

Exhibit mesh_exhibit(Studio on_table) {
    const auto studio = std::make_shared<const Studio>(std::move(on_table));
    const auto scene = std::make_shared<const decltype(exhibit<Bvh>(*studio))>(exhibit<Bvh>(*studio));
    const auto &[bvhs, tables] = scene->shapes;
    const Object<SmoothMesh, Diffuse<>> mesh{{&bvhs.front().shape, &studio->mesh()}, bvhs.front().material};
    return {pack(World{Scene(std::vector{mesh}, tables), studio->lights, StudioSky{}}), studio->view,
            [studio, scene](const Ray<double> &ray, Random &random) {
                return exhibit_radiance(ray, *scene, *studio, random);
            }};
}

Exhibit first_hits_exhibit(const Studio &studio) {
    const auto all = triangles(studio.mesh());
    std::vector<Object<Bvh<Triangle<>>, Facing<>>> objects;
    objects.push_back({Bvh<Triangle<>>(std::span<const Triangle<>>(all)), {Colour(1)}});
    const Lights<PointLight> no_lights({});
    const ConstantSky dark{Colour(0)};
    const Object<SmoothMesh, Facing<>> mesh{{&objects.front().shape, &studio.mesh()}, {Colour(1)}};
    PackedScene scene = pack(World{Scene(std::vector{mesh}), no_lights, dark});
    const auto world =
        std::make_shared<const World<Scene<Object<Bvh<Triangle<>>, Facing<>>>, Lights<PointLight>, ConstantSky>>(
            World{Scene(std::move(objects)), no_lights, dark});
    return {std::move(scene), studio.view,
            [world](const Ray<double> &ray, Random &random) { return radiance(ray, *world, Path{}, random); }};
}

Exhibit enamel_exhibit(const Studio &studio) {
    using Enamel = Sum<Diffuse<>, Mirror<>>;
    const auto &[meshes, tables] = studio.scene.shapes;
    const Enamel coat({meshes.front().material.diffuse}, {Colour(0.25f)}),
        polish({tables.front().material.diffuse}, {Colour(0.4f)});
    const std::vector table{Object<Disk<>, Enamel>{tables.front().shape, polish}};
    const ConstantSky sky{{0.05f, 0.055f, 0.07f}};
    const auto all = triangles(studio.mesh());
    std::vector<Object<Bvh<Triangle<>>, Enamel>> objects;
    objects.push_back({Bvh<Triangle<>>(std::span<const Triangle<>>(all)), coat});
    Mesh<> flat = studio.mesh(); // as World's triangles are
    flat.normals.clear();
    const Object<SmoothMesh, Enamel> mesh{{&objects.front().shape, &flat}, coat};
    PackedScene scene = pack(World{Scene(std::vector{mesh}, table), studio.lights, sky});
    using Enamelled =
        World<Scene<Object<Bvh<Triangle<>>, Enamel>, Object<Disk<>, Enamel>>, Lights<PointLight>, ConstantSky>;
    const auto world = std::make_shared<const Enamelled>(World{Scene(std::move(objects), table), studio.lights, sky});
    return {std::move(scene), studio.view,
            [world](const Ray<double> &ray, Random &random) { return radiance(ray, *world, Path{}, random); }};
}

const std::vector<std::string> &exhibit_names() {
    static const std::vector<std::string> names{"whitted", "primitives", "textures",   "mirrors", "drink",
                                                "sundial", "bunny",      "first-hits", "enamel"};
    return names;
}

Exhibit exhibit_named(const std::string &name, const std::string &mesh, const Limits &limits, std::uint64_t seed) {
    if (name == "bunny")
        return mesh_exhibit(studio_of(mesh));
    if (name == "first-hits")
        return first_hits_exhibit(studio_of(mesh));
    if (name == "enamel")
        return enamel_exhibit(studio_of(mesh));
    if (name == "primitives")
        return exhibit_of(facing_still_life(), still_life_view, limits);
    if (name == "textures") {
        const Wardrobe wardrobe = paint_wardrobe(seed);
        return exhibit_of(World{textured_scene(wardrobe), evening_lights(), ImageSky{wardrobe.sky}}, textured_view(),
                          limits);
    }
    if (name == "mirrors")
        return exhibit_of(mirror_world(), mirror_view(), limits);
    if (name == "sundial")
        return soft_sundial(limits, seed);
    if (name == "drink")
        return exhibit_of(evening_drink(seed), drink_view(), limits);
    return exhibit_of(whitted_world(), whitted_view(), limits);
}

} // namespace course
