// C1, C12, C13, C14 and C19: what the notes say about rays, light and shadow.
#include "chapters/01_ray_casting/forward.hpp"
#include "chapters/01_ray_casting/sunflower.hpp"
#include "chapters/03_light_and_shadow/measure.hpp"
#include "chapters/04_shadow_map/measure.hpp"
#include "chapters/06_whitted/bounces.hpp"
#include "chapters/06_whitted/mirror_scene.hpp"
#include "common/parallel.hpp"
#include "tests/claims/cases.hpp"

namespace course {
namespace {

// ---- C1 ------------------------------------------------------------------------------------------------------------

// How far a world's pictures with some bounce limits are from the one with 32.
template <class AnyWorld>
void ask_bounces(const std::string &name, AnyWorld world, const ClaimOptions &options, Cases &cases, Plot &plot) {
    const int width = options.quick ? 160 : 480, height = width * 9 / 16;
    const Camera camera(mirror_view(), width, height);
    const auto picture = [&](int bounces) {
        world.limits.bounces = bounces;
        return plain_picture(name, world, Path{}, camera, width, height).picture;
    };
    const Picture with_32 = picture(32);
    Series series{name, {}};
    std::vector<Picture> pictures;
    for (const int bounces : {1, 2, 4, 8, 16}) {
        pictures.push_back(picture(bounces));
        series.points.push_back({static_cast<double>(bounces), difference(pictures.back(), with_32).rmse_steps});
    }
    plot.series.push_back(series);
    const Picture &with_8 = pictures[3], &with_16 = pictures[4];
    const double steps = difference(with_8, with_16).rmse_steps;
    cases.add(name, steps < 1,
              said("they differ by %.3g steps of 255 (root mean square), in %d of %d pixels", steps,
                   changed_pixels(with_8, with_16), width * height));
}

Finding eight_and_sixteen_bounces(const ClaimOptions &options) {
    Plot plot{"Error against the bounce limit", "bounces", "RMSE to 32 bounces, in steps of 1/255", true, true, {}};
    Cases cases("the scene");
    ask_bounces("one mirror", mirror_world(false), options, cases, plot);
    ask_bounces("two mirrors face to face", mirror_world(), options, cases, plot);
    ask_bounces("a room of mirrors", closed_room(), options, cases, plot);
    return cases.finding(plot);
}

// ---- C12 -----------------------------------------------------------------------------------------------------------

Finding constant_offset(const ClaimOptions &options) {
    const int rays = options.quick ? 4'000 : 50'000;
    const std::vector<double> deltas{1e-5, 1e-4, 1e-3, 1e-2, -1}; // the last: spawn_ray()
    constexpr int decades = 11;
    std::vector<SpawnTally> tallies(deltas.size() * decades);
    const auto radius = [](std::size_t decade) { return std::pow(10.0, static_cast<double>(decade) - 4); };
    parallel_for(tallies.size(), [&](std::size_t i) {
        tallies[i] = tally_spawns(radius(i % decades), deltas[i / decades], rays, options.seed);
    });

    Plot plot{"Shadow rays that go wrong", "radius of the sphere", "acne and leaks per million", true, true, {}};
    Cases cases("the scale of the scene");
    std::string ours;
    for (std::size_t d = 0; d < deltas.size(); ++d) {
        Series series{deltas[d] > 0 ? said("δ = %g", deltas[d]) : "spawn_ray()", {}};
        std::string good;
        int wrong = 0;
        for (std::size_t decade = 0; decade < decades; ++decade) {
            const SpawnTally &tally = tallies[d * decades + decade];
            const int bad = tally.acne + tally.leaks;
            series.points.push_back({radius(decade), 1e6 * bad / tally.rays});
            wrong += bad;
            if (bad == 0)
                good += said("%s%g", good.empty() ? "" : ", ", radius(decade));
            if (deltas[d] > 0)
                cases.add(said("δ = %g at radius %g", deltas[d], radius(decade)), bad == 0);
        }
        plot.series.push_back(series);
        if (deltas[d] > 0)
            ours += series.name + " is clean at radius " + (good.empty() ? "none" : good) + "; ";
        else
            ours += said("an offset by a bound, in double, gives %d wrong rays at all radii", wrong);
    }
    return cases.finding(plot, ours);
}

// ---- C13 and C19 ---------------------------------------------------------------------------------------------------

Finding shadow_map_quality(const ClaimOptions &options) {
    const SundialScene scene = sundial_scene();
    const auto places = options.quick ? sundial_cases(scene, 320, 180) : sundial_cases(scene, 640, 360);
    const LightView view(lamp_view);
    Plot plot{"Pixels that a shadow map gets wrong", "texels a side", "wrong per million", true, true, {}};
    Series shadow{"shadow where light is", {}}, light{"light where shadow is", {}};
    for (int resolution = 32; resolution <= (options.quick ? 512 : 2048); resolution *= 2) {
        const MapErrors errors = errors_of(ShadowMap(scene, view, resolution), {}, places);
        shadow.points.push_back({static_cast<double>(resolution), errors.false_shadow});
        light.points.push_back({static_cast<double>(resolution), errors.false_light});
    }
    plot.series = {shadow, light};
    const double coarse = shadow.points.front().y + light.points.front().y;
    const double fine = shadow.points.back().y + light.points.back().y;
    const double finer = shadow.points.back().x / shadow.points.front().x;

    // The very points that the map's rays have met, so that a texel's width plays no part.
    const int resolution = 256;
    const ShadowMap map(scene, view, resolution);
    const auto exact = texel_cases<double>(scene, view, resolution);
    const auto rounded = texel_cases<float>(scene, view, resolution);
    const auto wrong = [&](const std::vector<MapCase> &points, double ulps) {
        const MapErrors errors = errors_of(map, {.slope = 0, .ulps = ulps}, points);
        return errors.false_shadow + errors.false_light;
    };
    const double in_double = wrong(exact, 0), in_float = wrong(rounded, 0), allowed = wrong(rounded, 2);

    Cases cases("which half of the sentence is asked");
    cases.add("resolution", fine < 2 * coarse / finer,
              said("with %.0f texels a side %.0f places in a million are wrong, with %.0f times as many %.0f",
                   shadow.points.front().x, coarse, finer, fine));
    cases.add("float comparison", in_float > 1000 && in_double == 0 && allowed == 0,
              said("of the points that the map itself has seen %.0f per million are wrong as floats, %.0f as doubles, "
                   "and %.0f as floats with a tolerance of 2 ulp",
                   in_float, in_double, allowed));
    return cases.finding(plot, said("but without any bias %.0f per million of all places are wrong: a texel's width "
                                    "does more harm than a float's",
                                    wrong(places, 0)));
}

Finding hard_shadows_only(const ClaimOptions &) {
    const std::vector<Row> rows = measure_penumbras();
    Plot plot{"Width of the penumbra", "height of the edge", "width on the floor", false, false, {}};
    const auto widths = [&](const std::string &column, const std::string &name) {
        Series series{name, {}};
        for (const Row &row : rows)
            series.points.push_back({number(row, "edge_height"), number(row, column)});
        plot.series.push_back(series);
        return series.points;
    };
    // The largest width over the smallest.
    const auto spread = [](const std::vector<PlotPoint> &points) {
        const auto [least, most] = std::ranges::minmax(points, {}, &PlotPoint::y);
        return most.y / least.y;
    };
    const auto lamp = widths("lamp", "of a lamp 0.8 wide"), plain = widths("filter_0", "map, no filter");
    Cases cases("the filter");
    const double widest = std::ranges::max(plain, {}, &PlotPoint::y).y;
    cases.add("a plain look-up", widest == 0,
              said("of half-lit places it makes a strip of width %.3g at most, the lamp one of %.2f to %.2f", widest,
                   lamp.front().y, lamp.back().y));
    for (const int filter : {4, 12}) {
        const int texels = 2 * filter + 1;
        const auto blurred = widths("filter_" + std::to_string(filter), said("map, %d x %d texels", texels, texels));
        cases.add(said("the mean of %d x %d texels", texels, texels), spread(blurred) < 0.2 * spread(lamp),
                  said("blurs every edge alike, the widest %.1f times as wide as the narrowest, where the lamp makes "
                       "it %.0f times",
                       spread(blurred), spread(lamp)));
    }
    return cases.finding(plot);
}

// ---- C14 -----------------------------------------------------------------------------------------------------------

Finding forward_tracing(const ClaimOptions &options) {
    const Scene<Sphere<>> scene = sunflower();
    const int photons = options.quick ? 5'000 : 1'000'000;
    constexpr std::size_t shares = 16;
    Plot plot{"Light that reaches the eye", "radius of the pupil", "% of the rays from the light", true, true, {}};
    Series measured{"measured", {}}, straight{"from the lamp straight into the eye", {}, Series::Style::line};
    Cases cases("the eye's size");
    for (const float radius : {0.02f, 0.08f, 0.32f, 1.28f}) {
        const Sphere<> pupil{sunflower_view.eye, radius};
        std::vector<ForwardTally> tallies(shares);
        parallel_for(shares, [&](std::size_t i) {
            tallies[i] = shoot_photons(sunflower_lamp, scene, pupil, 4, photons, options.seed * shares + i);
        });
        double shot = 0, reached = 0;
        for (const ForwardTally &tally : tallies) {
            shot += static_cast<double>(tally.shot);
            reached += static_cast<double>(tally.reached_eye);
        }
        const auto r = static_cast<double>(radius);
        const double seen = r / length(sunflower_view.eye - sunflower_lamp); // the sine of half the angle
        measured.points.push_back({r, 100 * reached / shot});
        straight.points.push_back({r, 50 * (1 - std::sqrt(1 - seen * seen))});
        // Whatever chance does, hardly more than this would arrive of ever so many rays.
        const double at_most = (reached + 4 * std::sqrt(reached + 1)) / shot;
        cases.add(said("a pupil of radius %g", r), at_most < 0.5,
                  said("%.0f of %.0f rays reach the eye", reached, shot));
    }
    plot.series = {measured, straight};
    return cases.finding(plot, "a ray from the eye, on the other hand, always gives a pixel its colour");
}

} // namespace

std::vector<Claim> picture_claims() {
    return {
        {"C1", "8 and 16 bounces differ little", "06_whitted",
         "pictures of three scenes with mirrors, with either limit",
         "they differ by less than one of 255 steps (root mean square)", false, eight_and_sixteen_bounces},
        {"C12", "a small δ before the hit avoids self-intersection", "03_light_and_shadow",
         "shadow rays from spheres of radius 1e-4 to 1e6, started δ before the hit, in float: how many meet the sphere "
         "again, and how many start beyond a wall a hundredth of its radius away",
         "neither happens, asked for each δ at each scale", false, constant_offset},
        {"C13", "a shadow map's quality depends on its resolution and on the comparison of floats", "04_shadow_map",
         "places of a scene at which the map and a shadow ray disagree",
         "n times the texels a side have less than 2/n of the errors; and points that are right as doubles or with a "
         "tolerance are wrong as floats, more than one in a thousand",
         false, shadow_map_quality},
        {"C14", "forward tracing wastes most of its rays", "01_ray_casting",
         "rays from a lamp, followed over four bounces, into eyes of four sizes",
         "fewer than half of them reach the eye, four standard deviations allowed", false, forward_tracing},
        {"C19", "shadow maps give hard shadows only", "04_shadow_map",
         "the width of the half-lit strip under a roof's edge at five heights, by the map and for a lamp with a width",
         "a plain look-up makes no such strip; and of a filter's the widths vary by less than a fifth of the lamp's "
         "factor",
         false, hard_shadows_only},
    };
}

} // namespace course
