// Lesson 17, step 10: from a point to its place on the screen, which is what rasterisation starts with.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"

namespace course {

// What the camera's rays do, backwards: a point to its place on the screen, and its distance to a depth. `near` and
// `far` are the distances between which anything is seen.
inline glm::mat4 screen_matrix(const Viewpoint &view, int width, int height, double near, double far) {
    const Camera camera(view, width, height);
    const Vec<double> middle = camera.ray(0.5 * width, 0.5 * height).direction;
    const glm::dmat3 frame(camera.ray(width, 0.5 * height).direction - middle,
                           camera.ray(0.5 * width, height).direction - middle, middle);
    const glm::dmat3 back = inverse(frame); // a point from the eye to (x w, y w, w)
    glm::dmat4 matrix(0);
    for (int column = 0; column < 3; ++column) {
        const Vec<double> v = back[column];
        matrix[column] = {v.x, v.y, (far + near) / (far - near) * v.z, v.z};
    }
    matrix[3][2] = -2 * far * near / (far - near);
    glm::dmat4 to_eye(1);
    to_eye[3] = glm::dvec4(-view.eye, 1);
    return glm::mat4(matrix * to_eye);
}

} // namespace course
