// Lesson 17, step 3: from the scene's type to #defines. What the type does not hold, the shader does not contain.
#pragma once
#include "chapters/02_primitives/still_life.hpp"
#include "chapters/05_texture/sky.hpp"
#include "chapters/06_whitted/materials.hpp"
#include "chapters/07_glass/annulus.hpp"
#include "chapters/07_glass/dielectric.hpp"
#include "chapters/08_mesh/studio.hpp"
#include "chapters/17_gpu/compose.hpp"
#include "chapters/17_gpu/pack_tree.hpp"
#include "chapters/17_gpu/passes.hpp"

namespace course {

// A type as an argument. needs(Type<X>(), defines) says what a shader needs to draw an X; a type that no overload knows
// cannot be drawn on the GPU, and the compiler says which one it is.
template <class X> struct Type {};

inline void need(Defines &defines, const char *name) { defines.emplace(name, ""); }

// Chapter 02's light, from before there were lamps: a surface shows as much of its colour as it faces the eye, on
// either side, and for the rest what is behind it.
template <class Coefficient = Colour> struct Facing { Coefficient facing; };
template <class Coefficient, class T, class Shape, class World, class AnyPath> Colour
shade(const Facing<Coefficient> &material, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    const double cosine = std::abs(dot(surface.normal, normalize(arrival.ray.direction)));
    return mix(sky_radiance(arrival.world.sky, arrival.ray.direction), value(material.facing, surface),
               static_cast<float>(cosine * std::sqrt(cosine)));
}

// What chapter 08's studio shows behind the mesh, with the little light that its walls send back.
struct StudioSky {};
inline Colour sky_radiance(StudioSky, const Vec<double> &direction) { return backdrop(direction); }

// ---- Shapes ---------------------------------------------------------------------------------------------------------
inline void needs(Type<Sphere<>>, Defines &defines) { need(defines, "HAS_SPHERE"); }
inline void needs(Type<Plane<>>, Defines &defines) { need(defines, "HAS_PLANE"); }
inline void needs(Type<Disk<>>, Defines &defines) { need(defines, "HAS_DISK"); }
inline void needs(Type<Annulus<>>, Defines &defines) {
    need(defines, "HAS_DISK");
    need(defines, "HAS_HOLE");
}
inline void needs(Type<Cylinder<>>, Defines &defines) { need(defines, "HAS_CYLINDER"); }
inline void needs(Type<Cone<>>, Defines &defines) { need(defines, "HAS_CONE"); }
inline void needs(Type<Box<>>, Defines &defines) { need(defines, "HAS_BOX"); }

inline void needs(Type<Implicit<Torus<>>>, Defines &defines) { need(defines, "HAS_QUARTIC"); }
inline void needs(Type<Implicit<LatticeBlob<>>>, Defines &defines) { need(defines, "HAS_QUARTIC"); }

// Triangles by themselves are looked through one by one; a mesh is walked through.
inline void needs(Type<AffineTriangle<>>, Defines &defines) { need(defines, "HAS_TRIANGLE"); }
inline void needs(Type<SmoothMesh>, Defines &defines) {
    need(defines, "HAS_TRIANGLE");
    need(defines, "HAS_MESH");
    need(defines, "HAS_NORMALS");
}

// ---- Coefficients ---------------------------------------------------------------------------------------------------
inline void needs(Type<Colour>, Defines &) {}
inline void needs(Type<White>, Defines &) {}
inline void needs(Type<Checker>, Defines &defines) {
    need(defines, "HAS_TEXTURE");
    need(defines, "HAS_CHECKER");
}
inline void needs(Type<ImageTexture>, Defines &defines) {
    need(defines, "HAS_TEXTURE");
    need(defines, "HAS_PICTURE");
}
template <class Inner> void needs(Type<Placed<Inner>>, Defines &defines) { needs(Type<Inner>(), defines); }

// ---- Materials ------------------------------------------------------------------------------------------------------
template <class C> void needs(Type<Diffuse<C>>, Defines &defines) {
    need(defines, "HAS_DIFFUSE");
    needs(Type<C>(), defines);
}
template <class C> void needs(Type<Glow<C>>, Defines &defines) {
    need(defines, "HAS_GLOW");
    needs(Type<C>(), defines);
}
template <class C> void needs(Type<Mirror<C>>, Defines &defines) {
    need(defines, "HAS_MIRROR");
    needs(Type<C>(), defines);
}
template <class C> void needs(Type<Facing<C>>, Defines &defines) {
    need(defines, "HAS_FACING");
    needs(Type<C>(), defines);
}
inline void needs(Type<Clear<>>, Defines &) {}
inline void needs(Type<Tinted<>>, Defines &defines) { need(defines, "HAS_ABSORPTION"); }
template <class Inside, class Outside, class R, class T>
void needs(Type<Dielectric<Inside, Outside, R, T>>, Defines &defines) {
    need(defines, "HAS_GLASS");
    needs(Type<Inside>(), defines);
    needs(Type<Outside>(), defines);
    needs(Type<R>(), defines);
    needs(Type<T>(), defines);
}
template <class... Parts> void needs(Type<Sum<Parts...>>, Defines &defines) { (needs(Type<Parts>(), defines), ...); }

// ---- Skies ----------------------------------------------------------------------------------------------------------
inline void needs(Type<ConstantSky>, Defines &defines) { need(defines, "SKY_CONSTANT"); }
inline void needs(Type<GradientSky>, Defines &defines) { need(defines, "SKY_GRADIENT"); }
inline void needs(Type<ImageSky>, Defines &defines) { need(defines, "SKY_PICTURE"); }
inline void needs(Type<StudioSky>, Defines &defines) { need(defines, "SKY_STUDIO"); }
inline void needs(Type<SkyBox>, Defines &defines) { need(defines, "SKY_BOX"); }

// ---- Lights ---------------------------------------------------------------------------------------------------------
inline void needs(Type<PointLight>, Defines &) {}
template <class Form> void needs(Type<PassLight<Form>>, Defines &defines) { need(defines, "HAS_AREA_LIGHT"); }
template <class... Kinds> void needs(Type<Lights<Kinds...>>, Defines &defines) { (needs(Type<Kinds>(), defines), ...); }

// ---- All of it ------------------------------------------------------------------------------------------------------
template <class Shape, class Material> void needs(Type<Object<Shape, Material>>, Defines &defines) {
    needs(Type<Shape>(), defines);
    needs(Type<Material>(), defines);
}
template <class... Objects, class AnyLights, class AnySky>
void needs(Type<World<Scene<Objects...>, AnyLights, AnySky>>, Defines &defines) {
    (needs(Type<Objects>(), defines), ...);
    needs(Type<AnyLights>(), defines);
    needs(Type<AnySky>(), defines);
}

} // namespace course
