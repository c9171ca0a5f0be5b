// The shaders of chapter 17 as rows beside the CPU's: the same cases, answered by the GLSL that the tracer draws with.
#pragma once
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/02_primitives/plane.hpp"
#include "chapters/08_mesh/triangle.hpp"
#include "tests/hard_cases/suite.hpp"

#include <memory>
#include <vector>

namespace course::hard {

// What a shape's test reads: texels of four floats as the shader's file for that shape has them. Of a mesh's triangles
// the corners are given, and the GPU works the rest out first.
struct ShaderShapes {
    std::vector<glm::vec4> scene, triangles, corners;
};
inline void give(ShaderShapes &to, const Sphere<> &s) { to.scene.insert(to.scene.end(), {{s.centre, s.radius}, {}}); }
inline void give(ShaderShapes &to, const Plane<> &p) { to.scene.insert(to.scene.end(), {{p.point, 0}, {p.normal, 0}}); }
inline void give(ShaderShapes &to, const Disk<> &d) {
    to.scene.insert(to.scene.end(), {{d.centre, d.radius}, {d.normal, 0}, {}});
}
inline void give(ShaderShapes &to, const Cylinder<> &c) {
    to.scene.insert(to.scene.end(), {{c.bottom, c.radius}, {c.top, 0}});
}
inline void give(ShaderShapes &to, const Cone<> &c) {
    to.scene.insert(to.scene.end(), {{c.apex, c.radius}, {c.base, 0}});
}
inline void give(ShaderShapes &to, const Box<> &b) { to.scene.insert(to.scene.end(), {{b.lo, 0}, {b.hi, 0}}); }
inline void give(ShaderShapes &to, const AffineTriangle<> &t) {
    to.triangles.insert(to.triangles.end(), {{t.corner, 0}, {t.normal, 0}, {t.k1, 0}, {t.k2, 0}});
}
inline void give(ShaderShapes &to, const Triangle<> &t) {
    to.corners.insert(to.corners.end(), {{t.a, 0}, {t.b, 0}, {t.c, 0}});
}

// A context in a thread of its own, which answers one batch after the other, whoever asks.
class Shaders {
  public:
    virtual ~Shaders() = default;

    // What the tests of the shape named so in the shaders ("sphere") say; the median seconds of the drawing alone.
    virtual double run(const std::string &shape, const std::vector<Ray<float>> &rays, const ShaderShapes &shapes,
                       std::span<double> t, int rounds) = 0;

    // What shaders/probe_optics.frag says of each boundary, in the order that stands there.
    virtual std::vector<glm::vec4> optics(std::span<const glm::vec4> boundaries) = 0;
};

// Nothing, after one line on stderr, where no OpenGL is to be had.
std::shared_ptr<Shaders> open_shaders();

// The row for a primitive's shader. It must not be wrong more often than the CPU's form of that name in float.
template <class Shape> void add_shader_row(const std::shared_ptr<Shaders> &shaders, const std::string &test,
                                           const std::string &peer, std::vector<Kernel<Shape>> &rows) {
    if (!shaders)
        return;
    const std::string shape = test == "affine triangle" ? "triangle" : test;
    const auto run = [=](const Batch<Shape> &batch, std::span<double> t, int rounds) {
        ShaderShapes given;
        for (const Shape &one : batch.shapes)
            give(given, one);
        return shaders->run(shape, batch.float_rays, given, t, rounds);
    };
    Kernel<Shape> row{.name = "GLSL", .scalar = "float", .run = {}};
    row.run = [run](const Batch<Shape> &batch, std::span<double> t) { run(batch, t, 1); };
    row.seconds = run;
    row.no_worse_than = peer;
    rows.push_back(row);
}

} // namespace course::hard
