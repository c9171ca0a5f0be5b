// The vectors of the course are GLM's: three components of any scalar, and colours as linear RGB.
#pragma once
#include <glm/glm.hpp>

namespace course {

template <class T> using Vec = glm::vec<3, T, glm::defaultp>;

// Linear RGB radiance or reflectance. The sRGB curve is applied only when a PNG is written.
using Colour = Vec<float>;

inline constexpr double pi = 3.141592653589793238462643383279502884;

} // namespace course
