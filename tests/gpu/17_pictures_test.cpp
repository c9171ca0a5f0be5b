// The GPU's pictures against the CPU's in double, from the same samples.
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/17_gpu/compare.hpp"
#include "chapters/17_gpu/rasteriser.hpp"
#include "tests/gpu/context.hpp"

using namespace course;

namespace {

constexpr int width = 160, height = 90;

// How many pixels of a million may differ by more than one step of 8 bits. Float decides another way than double at
// outlines, in checkers far away, and most of all behind glass, where small differences grow from bounce to bounce.
struct Tolerance {
    std::string scene;
    double differing_per_million, rmse;
};
const Tolerance tolerances[]{{"whitted", 2000, 0.003}, {"primitives", 100, 1e-4}, {"textures", 1500, 0.01},
                             {"mirrors", 500, 0.003},  {"drink", 12000, 0.02},    {"sundial", 300, 0.005},
                             {"bunny", 500, 0.003},    {"enamel", 1500, 0.01},    {"first-hits", 500, 0.003}};

Exhibit small_exhibit(const std::string &name) {
    const bool is_mesh = name == "bunny" || name == "first-hits" || name == "enamel";
    return exhibit_named(name, is_mesh ? "tests/golden/08_mesh.ply" : "", Limits{.least_weight = 0x1p-10f}, 1);
}

Picture drawn(const GlContext &context, const PackedScene &scene, const Viewpoint &view,
              const std::string &walk = "stack", int size = 1, bool compute = false) {
    Defines defines = shader_defines(scene, walk);
    if (compute)
        need(defines, "COMPUTE");
    GpuTracer tracer(context.gl(), scene, defines);
    return gpu_picture(context, tracer, view, width / size, height / size, 1).picture;
}

} // namespace

class GpuPicture : public testing::TestWithParam<Tolerance> {};

TEST_P(GpuPicture, IsTheCpusWithinTolerance) {
    COURSE_CONTEXT_OR_SKIP(context);
    const Exhibit exhibit = small_exhibit(GetParam().scene);
    const Picture exact = cpu_picture(exhibit, width, height, 1, 1).picture;
    const ImageDifference apart = difference(exact, drawn(*context, exhibit.scene, exhibit.view));
    EXPECT_LE(apart.differing_per_million, GetParam().differing_per_million);
    EXPECT_LE(apart.rmse, GetParam().rmse);
    std::printf("%s: RMSE %.2g, %.0f of a million pixels differ\n", GetParam().scene.c_str(), apart.rmse,
                apart.differing_per_million);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GpuPicture, testing::ValuesIn(tolerances), [](const auto &each) {
    std::string name = each.param.scene;
    std::erase(name, '-');
    return name;
});

// Every scene of the program has its line above.
TEST(Pictures, EverySceneIsCompared) { EXPECT_EQ(std::size(tolerances), exhibit_names().size()); }

TEST(Pictures, AShaderThatHoldsEverythingDrawsTheSame) {
    COURSE_CONTEXT_OR_SKIP(context);
    for (const std::string name : {"whitted", "primitives", "mirrors", "sundial", "bunny"}) {
        const Exhibit exhibit = small_exhibit(name);
        const ImageDifference apart =
            difference(drawn(*context, exhibit.scene, exhibit.view, "stack", 2),
                       drawn(*context, with_everything(exhibit.scene), exhibit.view, "stack", 2));
        EXPECT_EQ(apart.differing_per_million, 0) << name;
        EXPECT_LE(apart.largest, 1e-4) << name;
    }
}

TEST(Pictures, BothWalksFindTheSame) {
    COURSE_CONTEXT_OR_SKIP(context);
    const Exhibit exhibit = small_exhibit("bunny");
    const ImageDifference apart = difference(drawn(*context, exhibit.scene, exhibit.view, "stack"),
                                             drawn(*context, exhibit.scene, exhibit.view, "skip"));
    EXPECT_EQ(apart.largest, 0);
}

TEST(Pictures, AComputeShaderDrawsTheSame) {
    COURSE_CONTEXT_OR_SKIP(context);
    for (const std::string name : {"whitted", "sundial", "bunny"}) {
        const Exhibit exhibit = small_exhibit(name);
        const ImageDifference apart = difference(drawn(*context, exhibit.scene, exhibit.view),
                                                 drawn(*context, exhibit.scene, exhibit.view, "stack", 1, true));
        EXPECT_EQ(apart.differing_per_million, 0) << name;
        EXPECT_LE(apart.largest, 1e-4) << name;
    }
}

// Two contexts that the same driver computes for draw the same to the last bit; drivers differ as float allows.
TEST(Pictures, EveryContextDrawsTheSame) {
    const Exhibit exhibit = small_exhibit("whitted");
    for (const bool compute : {false, true}) {
        std::vector<std::string> renderers;
        std::vector<Picture> pictures;
        for (const std::string &name : context_names())
            try {
                const auto context = open_context(name);
                pictures.push_back(drawn(*context, exhibit.scene, exhibit.view, "stack", 1, compute));
                renderers.push_back(context->renderer());
                std::printf("%s: %s\n", name.c_str(), renderers.back().c_str());
            } catch (const InputError &error) {
                std::printf("left out: %s\n", error.what());
            }
        if (pictures.size() < 2)
            GTEST_SKIP() << "fewer than two contexts here";
        for (std::size_t i = 1; i < pictures.size(); ++i) {
            const ImageDifference apart = difference(pictures.front(), pictures[i]);
            const bool same_driver = renderers[i] == renderers.front();
            EXPECT_LE(apart.differing_per_million, same_driver ? 0 : 3000) << compute;
            EXPECT_LE(apart.largest, same_driver ? 0 : 1) << compute;
        }
    }
}

// Many passes, each with its own cell of the lamp and its own place in the pixel, are the CPU's picture with its
// passes.
TEST(Pictures, SoftShadowsAddUpOverThePasses) {
    COURSE_CONTEXT_OR_SKIP(context);
    const Exhibit exhibit = small_exhibit("sundial");
    GpuTracer tracer(context->gl(), exhibit.scene, shader_defines(exhibit.scene));
    const Picture gpu = gpu_picture(*context, tracer, exhibit.view, width / 2, height / 2, 16).picture;
    const ImageDifference apart = difference(cpu_picture(exhibit, width / 2, height / 2, 16, 1).picture, gpu);
    EXPECT_LE(apart.rmse, 0.001);
    EXPECT_LE(apart.differing_per_million, 1000);
}

// A picture that covers the same pixels as the traced one, with the same light; shadow maps err at the shadows' edges.
TEST(Pictures, TheRasteriserDrawsTheSameMesh) {
    COURSE_CONTEXT_OR_SKIP(context);
    const Studio on_table = studio_of("tests/golden/08_mesh.ply");
    const Picture exact = cpu_picture(mesh_exhibit(on_table), width, height, 1, 1).picture;
    Rasteriser rasteriser(context->gl(), on_table);
    rasteriser.draw(on_table.view, width, height);
    const ImageDifference apart = difference(exact, rasteriser.picture(on_table.view));
    std::printf("rasterised: RMSE %.2g, %.0f of a million pixels differ\n", apart.rmse, apart.differing_per_million);
    EXPECT_LE(apart.differing_per_million, 30000);
    EXPECT_LE(apart.rmse, 0.03);
}

// k1 and k2 from the GPU against chapter 02's, which are worked out in double.
TEST(Prepared, TrianglesHaveTheirConstants) {
    COURSE_CONTEXT_OR_SKIP(context);
    const Gl &gl = context->gl();
    std::vector<glm::vec4> corners;
    std::vector<AffineTriangle<>> expected;
    Random random(7);
    const auto point = [&] { return Vec<float>(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
    for (int i = 0; i < 1000; ++i) {
        const Vec<float> a = point(), b = point(), c = point();
        corners.insert(corners.end(), {{a, static_cast<float>(i)}, {b, 0}, {c, 0}});
        expected.push_back(affine_triangle(a, b, c));
    }
    const GlName vertices = make_vertex_array(gl);
    const TexelBuffer prepared = prepared_triangles(gl, vertices, corners);
    std::vector<glm::vec4> found(4 * expected.size());
    gl.BindBuffer(GL_TEXTURE_BUFFER, prepared.buffer());
    gl.GetBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(found.size() * sizeof found[0]), found.data());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto near = [&](std::size_t texel, const Vec<float> &v) {
            EXPECT_LE(length(Vec<float>(found[4 * i + texel]) - v), 2e-4f * length(v)) << i << " " << texel;
        };
        EXPECT_EQ(found[4 * i], glm::vec4(expected[i].corner, static_cast<float>(i)));
        near(1, expected[i].normal);
        near(2, expected[i].k1);
        near(3, expected[i].k2);
    }
}

// 70,000 spheres are more than llvmpipe's loops can look through. Either the pixels say so, or they are right.
TEST(Budget, LoopsThatAreCutShortAreTold) {
    COURSE_CONTEXT_OR_SKIP(context);
    std::vector<Object<Sphere<>, Glow<>>> spheres(70000, {{{100, 0, 0}, 1}, {Colour(1)}});
    spheres.back().shape.centre = {0, 0, 0};
    const World world{Scene(spheres), Lights<PointLight>({}), ConstantSky{Colour(0)}};
    const PackedScene scene = pack(world);
    GpuTracer tracer(context->gl(), scene, shader_defines(scene));
    tracer.start(Viewpoint{}, 16, 16);
    tracer.pass(0);
    const bool all_seen = tracer.picture()(8, 8) == Colour(1);
    EXPECT_EQ(all_seen, tracer.counts().cut_short == 0);
    if (!all_seen) {
        EXPECT_THROW(gpu_picture(*context, tracer, Viewpoint{}, 16, 16, 1), InputError);
    }
}

TEST(Budget, AFullStackIsCounted) {
    COURSE_CONTEXT_OR_SKIP(context);
    Exhibit exhibit = small_exhibit("whitted");
    const auto not_kept = [&](int stack) {
        exhibit.scene.ray_stack = stack;
        GpuTracer tracer(context->gl(), exhibit.scene, shader_defines(exhibit.scene));
        tracer.start(exhibit.view, width, height);
        tracer.pass(0);
        return tracer.counts().rays_not_kept;
    };
    EXPECT_GT(not_kept(1), 0);
    EXPECT_EQ(not_kept(32), 0);
}

// The rays that both tracers count are the same, but for those at outlines.
TEST(Budget, RaysAreCountedAsOnTheCpu) {
    COURSE_CONTEXT_OR_SKIP(context);
    const Exhibit exhibit = small_exhibit("mirrors");
    GpuTracer tracer(context->gl(), exhibit.scene, shader_defines(exhibit.scene));
    const auto on_gpu = static_cast<double>(gpu_picture(*context, tracer, exhibit.view, width, height, 1).rays);
    const auto on_cpu = static_cast<double>(cpu_picture(exhibit, width, height, 1, 1).rays);
    EXPECT_NEAR(on_gpu / on_cpu, 1, 0.01);
}
