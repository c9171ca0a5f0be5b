// Chapter 08: a real model, 69,666 triangles, and every ray asks every one of them.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/08_mesh/load.hpp"
#include "chapters/08_mesh/measure.hpp"
#include "chapters/08_mesh/normals.hpp"
#include "chapters/08_mesh/studio.hpp"
#include "common/program.hpp"

using namespace course;

namespace {

// The normal to shade with: a mesh interpolates, whatever else is in the scene is what it is.
Vec<double> shown_normal(const Surface<double, Triangle<>> &surface, const Mesh<> &mesh) {
    return shading_normal(mesh, surface.id, surface.point);
}
template <class Shape> Vec<double> shown_normal(const Surface<double, Shape> &surface, const Mesh<> &) {
    return surface.normal;
}

Colour radiance(const Ray<double> &ray, const Studio &studio, Random &random) {
    count_ray();
    const auto hit = closest_hit(ray, studio.scene);
    if (!hit)
        return backdrop(ray.direction);
    return with_hit(ray, hit, studio.scene, [&](const auto &surface, const auto &material) {
        Vec<double> normal = shown_normal(surface, studio.mesh());
        if (dot(surface.normal, ray.direction) > 0)
            normal = -normal; // the side that is seen
        const Colour diffuse = value(material.diffuse, surface);
        return diffuse * ambient(normal) + direct_light(surface, normal, diffuse, studio.scene, studio.lights, random);
    });
}

} // namespace

int main(int argc, char **argv) {
    return run_program("08_mesh", "Meshes: a real model by brute force", argc, argv, [](Program &program) {
        program.width = 160, program.height = 120; // every ray asks every triangle
        std::string file;
        bool flat = false, measure = false;
        program.options.option("--mesh", file, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.flag("--flat", flat, "Show the triangles as flat as they are");
        program.options.flag("--measure", measure, "Instead measure the triangle tests and the cost of brute force");
        program.parse();
        if (measure) {
            measure_forms(program);
            measure_cost(program);
            return;
        }

        Mesh<> mesh = load_mesh(file.empty() ? find_bunny() : std::filesystem::path(file));
        if (flat)
            mesh.normals.clear();
        const Studio room = studio(std::move(mesh));
        program.render(room.view, [&room, seed = program.seed](const Viewpoint &from, int width, int height) {
            return each_pixel([&room, seed, camera = Camera(from, width, height)](int x, int y) {
                Random random(seed, static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x));
                return radiance(camera.ray(x + 0.5, y + 0.5), room, random);
            });
        });
    });
}
