// Lesson 17, step 5: the scene as the shader reads it: texels of four floats, one behind the other.
#pragma once
#include "chapters/17_gpu/needs.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace course {

// Shapes of one kind, one behind the other, as `lists` in scene.glsl.
struct ShapeRun {
    std::string kind; // "SPHERE", ...; the shader's functions bear the same name in small letters
    int first, count;
    int size = 1; // texels of each
};

struct PackedScene {
    bool specialised = true; // the shader is this scene's alone
    Defines defines;
    std::vector<glm::vec4> texels, pictures;
    std::vector<ShapeRun> runs;
    PackedTrees trees;
    int first_light = 0, light_count = 0, sky_table = 0;
    std::map<std::string, Colour> colours; // uniforms: the sky's
    Limits limits;
    int ray_stack = 1; // how many rays may wait; one for each bounce is always enough
};

class Packer {
  public:
    template <class... Objects, class AnyLights, class AnySky>
    explicit Packer(const World<Scene<Objects...>, AnyLights, AnySky> &world) {
        needs(Type<World<Scene<Objects...>, AnyLights, AnySky>>(), packed_.defines);
        packed_.limits = world.limits;
        packed_.ray_stack = world.limits.bounces;
        std::apply([&](const auto &...lists) { (list(lists), ...); }, world.scene.shapes);
        packed_.first_light = here();
        for (const PointLight &light : std::get<0>(world.lights.kinds)) {
            put(Vec<float>(light.position), 0);
            put(light.intensity, 0);
            ++packed_.light_count;
        }
        sky(world.sky);
    }

    PackedScene take() && { return std::move(packed_); }

  private:
    int here() const { return static_cast<int>(packed_.texels.size()); }
    void put(const Vec<float> &v, float w) { packed_.texels.emplace_back(v, w); }

    // The materials come before the shapes that name them.
    template <class Shape, class Material> void list(const std::vector<Object<Shape, Material>> &objects) {
        std::vector<int> materials;
        for (const auto &object : objects)
            materials.push_back(material(object.material));
        // Triangles lie in a buffer of their own, four texels each once the GPU has prepared them.
        const int first = std::is_same_v<Shape, AffineTriangle<>> ? 4 * packed_.trees.triangles() : here();
        for (std::size_t i = 0; i < objects.size(); ++i)
            shape(objects[i].shape, static_cast<float>(materials[i]));
        packed_.runs.push_back(kind_of(Type<Shape>()));
        packed_.runs.back().first = first;
        packed_.runs.back().count = static_cast<int>(objects.size());
    }

    // ---- Shapes, in the order of the fields in the shape's shader file ----
    static ShapeRun kind_of(Type<Sphere<>>) { return {"SPHERE", 0, 0, 2}; }
    static ShapeRun kind_of(Type<Plane<>>) { return {"PLANE", 0, 0, 2}; }
    static ShapeRun kind_of(Type<Disk<>>) { return {"DISK", 0, 0, 3}; }
    static ShapeRun kind_of(Type<Annulus<>>) { return {"DISK", 0, 0, 3}; }
    static ShapeRun kind_of(Type<Cylinder<>>) { return {"CYLINDER", 0, 0, 2}; }
    static ShapeRun kind_of(Type<Cone<>>) { return {"CONE", 0, 0, 2}; }
    static ShapeRun kind_of(Type<Box<>>) { return {"BOX", 0, 0, 2}; }
    static ShapeRun kind_of(Type<Implicit<Torus<>>>) { return {"TORUS", 0, 0, 4}; }
    static ShapeRun kind_of(Type<Implicit<LatticeBlob<>>>) { return {"BLOB", 0, 0, 4}; }
    static ShapeRun kind_of(Type<AffineTriangle<>>) { return {"TRIANGLE", 0, 0, 4}; }
    static ShapeRun kind_of(Type<SmoothMesh>) { return {"TREE", 0, 0, 1}; }

    void shape(const Sphere<> &sphere, float material) {
        put(sphere.centre, sphere.radius);
        put({material, 0, 0}, 0);
    }
    void shape(const Plane<> &plane, float material) {
        put(plane.point, material);
        put(plane.normal, 0);
    }
    void shape(const Disk<> &disk, float material, float hole = 0) {
        put(disk.centre, disk.radius);
        put(disk.normal, hole);
        put({material, 0, 0}, 0);
    }
    void shape(const Annulus<> &annulus, float material) { shape(annulus.disk, material, annulus.hole); }
    void shape(const Cylinder<> &cylinder, float material) {
        put(cylinder.bottom, cylinder.radius);
        put(cylinder.top, material);
    }
    void shape(const Cone<> &cone, float material) {
        put(cone.apex, cone.radius);
        put(cone.base, material);
    }
    void shape(const Box<> &box, float material) {
        put(box.lo, material);
        put(box.hi, 0);
    }

    void shape(const Implicit<Torus<>> &torus, float material) {
        put(torus.f.centre, torus.f.ring);
        put(torus.f.axis, torus.f.tube);
        shape(torus.bounds, material);
    }
    void shape(const Implicit<LatticeBlob<>> &blob, float material) {
        put(blob.f.centre, blob.f.size);
        put({blob.f.level, 0, 0}, 0);
        shape(blob.bounds, material);
    }
    void shape(const AffineTriangle<> &triangle, float material) {
        const auto [a, b, c] = corners(triangle);
        append_triangle(packed_.trees, Vec<float>(a), Vec<float>(b), Vec<float>(c), material);
    }
    void shape(const SmoothMesh &mesh, float material) {
        packed_.texels.push_back(append_mesh(packed_.trees, mesh, material));
    }

    // ---- Materials: coefficients of four texels, then the media, as material.glsl has them ----
    struct Coefficient {
        glm::vec4 first{0}, second{0}, placed{0, 0, 1, 0}, up{0, 1, 0, 0};
    };
    struct Record {
        Coefficient diffuse, glow, reflection, transmission, facing;
        glm::vec4 inside{0, 0, 0, 1}, outside{0, 0, 0, 1};
    };

    Coefficient coefficient(const Colour &colour) { return {.first = {colour, 0}}; }
    Coefficient coefficient(White) { return {.first = {1, 1, 1, 0}}; }
    Coefficient coefficient(const Checker &checker) { return {.first = {checker.even, 1}, .second = {checker.odd, 0}}; }
    Coefficient coefficient(const ImageTexture &texture) {
        return {.first = {0, 0, 0, 2}, .second = {0, 0, 0, picture(texture)}};
    }
    template <class Inner> Coefficient coefficient(const Placed<Inner> &placed) {
        Coefficient inner = coefficient(placed.texture);
        inner.placed = {placed.origin, placed.across};
        inner.up = {placed.up, 0, 0};
        return inner;
    }
    static glm::vec4 medium(const Clear<> &clear) { return {0, 0, 0, clear.index}; }
    static glm::vec4 medium(const Tinted<> &tinted) { return {tinted.absorption, tinted.index}; }

    template <class C> void add(Record &record, const Diffuse<C> &m) { record.diffuse = coefficient(m.diffuse); }
    template <class C> void add(Record &record, const Glow<C> &m) { record.glow = coefficient(m.glow); }
    template <class C> void add(Record &record, const Mirror<C> &m) { record.reflection = coefficient(m.reflection); }
    template <class C> void add(Record &record, const Facing<C> &m) { record.facing = coefficient(m.facing); }
    template <class... Kinds> void add(Record &record, const Dielectric<Kinds...> &m) {
        record.reflection = coefficient(m.reflection);
        record.transmission = coefficient(m.transmission);
        record.inside = medium(m.inside);
        record.outside = medium(m.outside);
    }
    template <class... Parts> void add(Record &record, const Sum<Parts...> &sum) {
        std::apply([&](const auto &...parts) { (add(record, parts), ...); }, sum.parts);
    }

    template <class Material> int material(const Material &material) {
        Record record;
        add(record, material);
        const int at = here();
        for (const Coefficient &c :
             {record.diffuse, record.glow, record.reflection, record.transmission, record.facing})
            packed_.texels.insert(packed_.texels.end(), {c.first, c.second, c.placed, c.up});
        packed_.texels.insert(packed_.texels.end(), {record.inside, record.outside});
        return at;
    }

    // ---- Pictures and skies ----
    // Returns where its description lies. Its texels follow those of the pictures before it.
    float picture(const ImageTexture &texture) {
        const Picture &image = *texture.picture;
        const int at = here();
        put({packed_.pictures.size(), image.width, image.height}, static_cast<float>(texture.border));
        for (const Colour &colour : image.pixels)
            packed_.pictures.emplace_back(colour, 0);
        return static_cast<float>(at);
    }

    void sky(StudioSky) {}
    void sky(const ConstantSky &sky) { packed_.colours["sky_colour"] = sky.radiance; }
    void sky(const GradientSky &sky) {
        packed_.colours = {{"sky_horizon", sky.horizon}, {"sky_zenith", sky.zenith}, {"sky_ground", sky.ground}};
    }
    void sky(const ImageSky &sky) { packed_.sky_table = static_cast<int>(picture(sky.picture)); }
    void sky(const SkyBox &box) {
        packed_.sky_table = here();
        for (const ImageTexture &face : box.faces)
            picture(face);
    }

    PackedScene packed_;
};

template <class AnyWorld> PackedScene pack(const AnyWorld &world) { return Packer(world).take(); }

// The counter-example: a shader that could draw any scene, as note A's can. The scene's own lists keep their order.
inline PackedScene with_everything(PackedScene scene) {
    scene.specialised = false;
    for (const char *name :
         {"HAS_HOLE", "HAS_TEXTURE", "HAS_CHECKER", "HAS_PICTURE", "HAS_NORMALS", "HAS_MESH", "HAS_DIFFUSE",
          "HAS_FACING", "HAS_QUARTIC", "HAS_GLOW", "HAS_MIRROR", "HAS_GLASS", "HAS_ABSORPTION"})
        need(scene.defines, name);
    for (const std::string kind : {"SPHERE", "PLANE", "DISK", "CYLINDER", "CONE", "BOX", "TRIANGLE"}) {
        scene.defines.emplace("HAS_" + kind, "");
        scene.runs.push_back({kind, 0, 0});
    }
    for (const char *kind : {"TORUS", "BLOB", "TREE"})
        scene.runs.push_back({kind, 0, 0});
    return scene;
}

} // namespace course
