// Lesson 17, step 11: the scenes of the chapters before, ready for either tracer. They are made in scenes.cpp: each is
// a type of its own, and so a tracer of its own to compile.
#pragma once
#include "chapters/08_mesh/studio.hpp"
#include "chapters/17_gpu/packed.hpp"
#include "common/viewpoint.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace course {

// A scene for the GPU, and the very same one for the CPU: the colour along a ray, computed in double.
struct Exhibit {
    PackedScene scene;
    Viewpoint view;
    std::function<Colour(const Ray<double> &, Random &)> colour;
    std::shared_ptr<int> pass = std::make_shared<int>(0); // the one that colour() is asked for
};

// A mesh on chapter 08's table, in chapter 14's hierarchy.
Exhibit mesh_exhibit(Studio on_table);

// The same without light and table: the first hits of the eye's rays, which is the search and little else.
Exhibit first_hits_exhibit(const Studio &studio);

// Whitted's way: a mesh of enamel, which mirrors a little, on a table that does so too, under two lamps.
Exhibit enamel_exhibit(const Studio &studio);

// The exhibits that have a name, and the one of that name. Those that show a mesh take it from the file, or the bunny
// where no file is named. Throws InputError where the file cannot be read.
const std::vector<std::string> &exhibit_names();
Exhibit exhibit_named(const std::string &name, const std::string &mesh, const Limits &limits, std::uint64_t seed);

} // namespace course
