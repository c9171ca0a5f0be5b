// The acceleration structures that H6, H7 and H12 run through: all that were taught so far. They are compiled once
// (structures.cpp), whatever they are asked.
#pragma once
#include "chapters/08_mesh/triangle.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace course::hard {

// A structure around some triangles, and what the families ask of it.
class Built {
  public:
    virtual ~Built() = default;
    virtual Hit<double> closest(const Ray<double> &ray) const = 0;
    virtual bool any(const Ray<double> &ray) const = 0;
    // How many triangles the ray meets, by way of the structure, which may come upon one several times.
    virtual std::size_t count(const Ray<double> &ray) const = 0;
};

struct NamedStructure {
    std::string name;
    std::function<std::unique_ptr<const Built>(const std::vector<Triangle<>> &triangles)> around;
};

const std::vector<NamedStructure> &all_structures();

} // namespace course::hard
