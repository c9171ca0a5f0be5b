// Lesson 01, step 2: a pinhole camera, which turns a place in the picture into a ray.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "common/viewpoint.hpp"

#include <cmath>

namespace course {

class Camera {
  public:
    // A viewer who looks straight up or at their own eye still gets a picture: a frame is chosen for them.
    Camera(const Viewpoint &view, int width, int height) : eye_(view.eye) {
        const Vec<double> forward = unit_or(view.target - view.eye, {0, 0, -1});
        const Vec<double> aside = std::abs(forward.y) < 0.9 ? Vec<double>(0, 1, 0) : Vec<double>(0, 0, 1);
        const Vec<double> right = unit_or(cross(forward, view.up), normalize(cross(forward, aside)));
        const Vec<double> up = cross(right, forward);

        // The image plane stands one unit before the eye; a pixel is as wide as it is high.
        const double half_height = std::tan(view.field_of_view * pi / 360);
        const double pixel = 2 * half_height / height;
        across_ = pixel * right;
        down_ = -pixel * up;
        top_left_ = forward - 0.5 * width * across_ - 0.5 * height * down_;
    }

    // The ray from the eye through the picture at (x, y), in pixels from the top left corner: the centre of the first
    // pixel is (0.5, 0.5). The direction reaches from the eye to the image plane and is not normalised.
    Ray<double> ray(double x, double y) const { return {eye_, top_left_ + x * across_ + y * down_}; }

  private:
    static Vec<double> unit_or(const Vec<double> &v, const Vec<double> &otherwise) {
        const double length_squared = dot(v, v);
        return length_squared > 1e-24 ? v / std::sqrt(length_squared) : otherwise;
    }

    Vec<double> eye_, top_left_, across_, down_;
};

} // namespace course
