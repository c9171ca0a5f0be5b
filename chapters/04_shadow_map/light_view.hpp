// Lesson 04, step 1: the scene as the lamp sees it, and where in that picture a point lies.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "common/viewpoint.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// Where a point lies in the lamp's picture: x to the right and y down, from 0 to 1 within the picture, and the depth
// along the lamp's line of sight, positive before it.
struct SeenPlace {
    double x, y, depth;

    bool in_picture() const { return depth > 0 && x >= 0 && x < 1 && y >= 0 && y < 1; }
};

// A square pinhole picture, taken from the lamp. It needs the way back from a point to its place in the picture, which
// a camera does not.
class LightView {
  public:
    // The viewpoint's up must not point along the line of sight.
    explicit LightView(const Viewpoint &view)
        : eye_(view.eye), forward_(normalize(view.target - view.eye)), right_(normalize(cross(forward_, view.up))),
          up_(cross(right_, forward_)), half_width_(std::tan(view.field_of_view * pi / 360)) {}

    // The ray through a place of the picture. Its direction advances by one along the line of sight, so t is the depth.
    Ray<double> ray(double x, double y) const {
        return {eye_, forward_ + (2 * x - 1) * half_width_ * right_ + (1 - 2 * y) * half_width_ * up_};
    }

    SeenPlace place_of(const Vec<double> &point) const {
        const Vec<double> from_eye = point - eye_;
        const double depth = dot(from_eye, forward_), scale = 1 / (2 * half_width_ * depth);
        return {0.5 + scale * dot(from_eye, right_), 0.5 - scale * dot(from_eye, up_), depth};
    }

    // How wide the picture is at a depth, in units of the scene.
    double width_at(double depth) const { return 2 * half_width_ * depth; }

    // How much the depth of a surface with this normal changes over the whole width and height of the picture, if it
    // went on as it is at the point: |dz/dx| + |dz/dy|. Limited where the lamp sees the surface from its edge.
    double depth_slope(const Vec<double> &point, const Vec<double> &normal) const {
        const Vec<double> from_eye = point - eye_;
        const double depth = dot(from_eye, forward_);
        const double facing = std::max(std::abs(dot(normal, from_eye)), 1e-3 * length(from_eye));
        return width_at(depth) * depth * (std::abs(dot(normal, right_)) + std::abs(dot(normal, up_))) / facing;
    }

  private:
    Vec<double> eye_, forward_, right_, up_;
    double half_width_;
};

} // namespace course
