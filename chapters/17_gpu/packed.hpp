// Lesson 17, step 4: the scene as the shader reads it: texels of four floats, one behind the other.
#pragma once
#include "chapters/17_gpu/needs.hpp"
#include "common/errors.hpp"

#include <map>
#include <memory>
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
    std::vector<glm::vec4> texels;   // shapes, materials, lights
    std::vector<glm::vec4> pictures; // all pictures' texels
    std::vector<ShapeRun> runs;
    PackedTrees trees;
    int first_light = 0, light_count = 0, lamp_size = 2, sky_table = 0;
    int strata = 1; // how many cells a lamp with an area has each way
    std::uint64_t seed = 1;
    std::map<std::string, Colour> colours; // uniforms: the sky's
    Limits limits;
    int ray_stack = 1; // how many rays may wait; one for each bounce is always enough
    std::map<std::shared_ptr<const Picture>, std::size_t> first_texels; // of the pictures that are in already
};

// The shader is told places as floats, which count up to here without a gap.
inline constexpr std::size_t most_places = std::size_t{1} << 24;

inline int here(const PackedScene &scene) { return static_cast<int>(scene.texels.size()); }

// Throws InputError where the scene is too long to be numbered.
inline void put(PackedScene &scene, const Vec<float> &v, float w) {
    if (scene.texels.size() >= most_places)
        throw InputError("scene", "has more shapes than the shader can number");
    scene.texels.emplace_back(v, w);
}

// Returns where the picture's description lies. Materials that share a picture share its texels.
inline int put_picture(PackedScene &scene, const ImageTexture &texture) {
    const Picture &image = *texture.picture;
    const auto [known, is_new] = scene.first_texels.emplace(texture.picture, scene.pictures.size());
    if (is_new)
        for (const Colour &colour : image.pixels)
            scene.pictures.emplace_back(colour, 0);
    if (scene.pictures.size() > most_places)
        throw InputError("scene", "has more texels in its pictures than the shader can number");
    const int at = here(scene);
    put(scene, {known->second, image.width, image.height}, static_cast<float>(texture.border));
    return at;
}

} // namespace course
