// A picture whose rays were collected and traced kind by kind is the picture that each ray by itself makes.
#include "chapters/15_wide_bvh/bounced.hpp"
#include "chapters/15_wide_bvh/by_kind.hpp"
#include "common/parallel.hpp"

#include <gtest/gtest.h>

namespace {

using namespace course;

// A bumpy ball of many triangles.
Mesh<> ball() {
    Mesh<> mesh;
    constexpr Id around = 24, along = 16;
    for (Id i = 0; i <= along; ++i)
        for (Id j = 0; j < around; ++j) {
            const double theta = pi * (i + 0.1) / (along + 0.2), phi = 2 * pi * j / around;
            const double radius = 1 + 0.2 * std::sin(5 * phi) * std::sin(7 * theta);
            mesh.points.push_back(Vec<float>(radius * Vec<double>(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                                  std::sin(theta) * std::sin(phi))));
        }
    for (Id i = 0; i < along; ++i)
        for (Id j = 0; j < around; ++j) {
            const Id a = i * around + j, b = i * around + (j + 1) % around;
            mesh.indices.push_back({a, b, b + around});
            mesh.indices.push_back({a, b + around, a + around});
        }
    return mesh;
}

Picture filled(const TileFunction &fill, int width, int height) {
    Picture picture(width, height);
    for (const Tile &tile : tiles_of(width, height))
        fill(tile, picture);
    return picture;
}

TEST(ByKind, MakesTheSamePictureBitForBit) {
    constexpr int width = 45, height = 33, samples = 2; // no multiples of anything
    const Studio room = studio(ball());
    const auto scene = exhibit<WideBvh>(room);
    const auto colour = bounced_exhibit(room, Camera(room.view, width, height), samples, 7);
    const std::uint64_t before = rays_of_this_thread;
    const Picture expected = filled(each_pixel_ray_by_ray(scene, samples * samples, colour), width, height);
    const std::uint64_t rays = rays_of_this_thread - before;
    for (const Way one : all_ways)
        for (const Way other : all_ways) {
            const std::uint64_t start = rays_of_this_thread;
            const Ways ways{one, other, other, one};
            const Picture picture = filled(each_pixel_by_kind(scene, samples * samples, ways, colour), width, height);
            EXPECT_EQ(rays_of_this_thread - start, rays);
            std::size_t different = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    different += picture(x, y) != expected(x, y);
            EXPECT_EQ(different, 0u);
        }
}

// Of what a pixel asks after a closest hit that is not known, nothing is believed.
TEST(ByKind, AsksInOrder) {
    Questions questions(1);
    const auto run = [&] {
        questions.begin(0);
        if (!questions.ask(Ray<double>{}, false))
            questions.ask(Ray<double>{}, true);
        questions.ask(Ray<double>{}, true);
        return questions.has_all();
    };
    std::array<std::size_t, ray_kinds> asked{};
    const auto answer = [&](RayKind kind, Batch rays) {
        asked[kind] += rays.size();
        return std::vector<Hit<double>>(rays.size(), Hit<double>{1, 0});
    };
    EXPECT_FALSE(run());
    questions.answer_all(answer);
    EXPECT_EQ(asked, (std::array<std::size_t, ray_kinds>{1, 0, 0, 0}));
    EXPECT_FALSE(run());
    questions.answer_all(answer);
    EXPECT_EQ(asked, (std::array<std::size_t, ray_kinds>{1, 1, 0, 0}));
    EXPECT_TRUE(run());
}

} // namespace
