#include "chapters/08_mesh/studio.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace course {
namespace {

// The smallest box along the axes around the points.
std::pair<Vec<double>, Vec<double>> corners_around(const std::vector<Vec<float>> &points) {
    Vec<float> low(infinity<float>), high(-infinity<float>);
    for (const Vec<float> &point : points)
        low = min(low, point), high = max(high, point);
    return {Vec<double>(low), Vec<double>(high)};
}

} // namespace

Studio studio(Mesh<> mesh) {
    const auto [low, high] = corners_around(mesh.points);
    const Vec<double> middle = 0.5 * (low + high);
    const double size = std::max(0.5 * length(high - low), 1e-30);
    const Vec<double> foot(middle.x, low.y - 1e-4 * size, middle.z);

    const Disk<> table{Vec<float>(foot), {0, 1, 0}, static_cast<float>(1.7 * size)};
    const double reach = 3.4 * size;
    const Vec<double> key = middle + reach * normalize(Vec<double>(-0.75, 0.85, 0.75));
    const Vec<double> rim = middle + reach * normalize(Vec<double>(0.95, 0.45, -0.35));
    const auto strength = [&](const Colour &colour) { return static_cast<float>(reach * reach) * colour; };

    const Viewpoint view{.eye = middle + size * Vec<double>(0.3, 0.72, 2.5),
                         .target = middle - size * Vec<double>(0.03, 0.06, 0),
                         .field_of_view = 38};
    return {StudioScene({{std::move(mesh), {Colour(0.78f, 0.62f, 0.47f)}}}, {{table, {Colour(0.30f, 0.37f, 0.43f)}}}),
            Lights<PointLight>({{key, strength({1.05f, 1.0f, 0.92f})}, {rim, strength({0.30f, 0.38f, 0.55f})}}), view};
}

} // namespace course
