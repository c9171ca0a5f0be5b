// Lesson 17, step 7: a world of the chapters before, packed: its lists of shapes, its lights, its sky.
#pragma once
#include "chapters/17_gpu/pack_lamp.hpp"
#include "chapters/17_gpu/pack_material.hpp"

namespace course {

class Packer {
  public:
    template <class... Objects, class AnyLights, class AnySky>
    explicit Packer(const World<Scene<Objects...>, AnyLights, AnySky> &world) {
        needs(Type<World<Scene<Objects...>, AnyLights, AnySky>>(), packed_.defines);
        packed_.limits = world.limits;
        packed_.ray_stack = world.limits.bounces;
        std::apply([&](const auto &...lists) { (list(lists), ...); }, world.scene.shapes);
        put_lamps(packed_, world.lights);
        sky(world.sky);
    }

    PackedScene take() && { return std::move(packed_); }

  private:
    void put(const Vec<float> &v, float w) { course::put(packed_, v, w); }

    // The materials come before the shapes that name them.
    template <class Shape, class Material> void list(const std::vector<Object<Shape, Material>> &objects) {
        std::vector<int> materials;
        for (const auto &object : objects)
            materials.push_back(put_material(packed_, object.material));
        // Triangles lie in a buffer of their own, four texels each once the GPU has prepared them.
        const int first = std::is_same_v<Shape, AffineTriangle<>> ? 4 * packed_.trees.triangles() : here(packed_);
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

    // ---- Skies ----
    void sky(StudioSky) {}
    void sky(const ConstantSky &sky) { packed_.colours["sky_colour"] = sky.radiance; }
    void sky(const GradientSky &sky) {
        packed_.colours = {{"sky_horizon", sky.horizon}, {"sky_zenith", sky.zenith}, {"sky_ground", sky.ground}};
    }
    void sky(const ImageSky &sky) { packed_.sky_table = put_picture(packed_, sky.picture); }
    void sky(const SkyBox &box) {
        packed_.sky_table = here(packed_);
        for (const ImageTexture &face : box.faces)
            put_picture(packed_, face);
    }

    PackedScene packed_;
};

template <class AnyWorld> PackedScene pack(const AnyWorld &world) { return Packer(world).take(); }

// The counter-example: a shader that could draw any scene, as note A's can. The scene's own lists keep their order.
inline PackedScene with_everything(PackedScene scene) {
    scene.specialised = false;
    for (const char *name :
         {"HAS_HOLE", "HAS_TEXTURE", "HAS_CHECKER", "HAS_PICTURE", "HAS_NORMALS", "HAS_MESH", "HAS_DIFFUSE",
          "HAS_FACING", "HAS_QUARTIC", "HAS_GLOW", "HAS_MIRROR", "HAS_GLASS", "HAS_ABSORPTION", "HAS_AREA_LIGHT"})
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
