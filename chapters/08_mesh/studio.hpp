// Lesson 08, step 9: any mesh on a round table, lit from the upper left and seen as a whole.
#pragma once
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/08_mesh/normals.hpp"
#include "common/viewpoint.hpp"

#include <tuple>

namespace course {

using StudioScene = Scene<Object<Mesh<>, Diffuse<>>, Object<Disk<>, Diffuse<>>>;

struct Studio {
    StudioScene scene;
    Lights<PointLight> lights;
    Viewpoint view;

    const Mesh<> &mesh() const { return std::get<0>(scene.shapes).front().shape; }
};

// Everything is measured in the mesh's own size, so that a mesh of a millimetre looks like one of a kilometre.
Studio studio(Mesh<> mesh);

// What is seen where nothing is hit: darker towards the top.
inline Colour backdrop(const Vec<double> &direction) {
    const auto height = static_cast<float>(0.5 + 0.5 * normalize(direction).y);
    return mix(Colour(0.13f, 0.135f, 0.15f), Colour(0.015f, 0.018f, 0.026f), height);
}

// A little light from everywhere, more from above: it stands in for all that the walls of a room send back.
inline Colour ambient(const Vec<double> &normal) {
    return static_cast<float>(0.6 + 0.4 * normal.y) * Colour(0.085f, 0.095f, 0.115f);
}

} // namespace course
