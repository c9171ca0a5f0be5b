// How the shaders are put together, what they refuse, and whether another compiler than the driver's accepts them.
#include "chapters/06_whitted/mirror_scene.hpp"
#include "chapters/07_glass/glass_scenes.hpp"
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/17_gpu/pack.hpp"
#include "chapters/17_gpu/rasteriser.hpp"
#include "chapters/17_gpu/scenes.hpp"
#include "chapters/17_gpu/tracer.hpp"
#include "tests/gpu/context.hpp"

#include <cstdlib>

using namespace course;

namespace {

std::string refusal(const std::function<void()> &act) {
    try {
        act();
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

Exhibit small_exhibit(const std::string &name) {
    const bool is_mesh = name == "bunny" || name == "first-hits" || name == "enamel";
    return exhibit_named(name, is_mesh ? "tests/golden/08_mesh.ply" : "", Limits{}, 1);
}

} // namespace

TEST(Compose, KeepsFilesAndLines) {
    const ShaderText shader = compose("trace.frag", {{"HAS_SPHERE", ""}, {"LIST_COUNT", "3"}});
    EXPECT_EQ(shader.text.substr(0, 18), "#version 430 core\n");
    EXPECT_NE(shader.text.find("#define LIST_COUNT 3\n"), std::string::npos);
    EXPECT_EQ(shader.text.find("#include"), std::string::npos);
    ASSERT_GT(shader.files.size(), 10u);
    EXPECT_EQ(shader.files[0], "trace.frag");
    EXPECT_EQ(shader.files[1], "ray.glsl");
    // Line 3 of trace.frag follows the whole of the file that line 2 includes.
    EXPECT_NE(shader.text.find("#line 3 0\n"), std::string::npos);
}

TEST(Compose, AMissingFileIsNamed) {
    EXPECT_NE(refusal([] { compose("no_such.glsl", {}); }).find("no_such.glsl: cannot be read"), std::string::npos);
}

TEST(Compose, ComplaintsNameTheFile) {
    const ShaderText shader{"", {"trace.frag", "ray.glsl"}};
    EXPECT_EQ(first_complaint(shader, "1:12(5): error: no\nmore"), "ray.glsl:12(5): error: no");
    EXPECT_EQ(first_complaint(shader, "1(12) : error C1: no"), "ray.glsl:12) : error C1: no");
    EXPECT_EQ(first_complaint(shader, "out of luck"), "out of luck");
}

TEST(Specialise, TheTypeDecidesWhatIsCompiled) {
    const Defines whitted = shader_defines(pack(whitted_world())), mirrors = shader_defines(pack(mirror_world()));
    EXPECT_TRUE(whitted.contains("HAS_GLASS") && whitted.contains("HAS_CHECKER") && whitted.contains("HAS_BOX"));
    EXPECT_FALSE(whitted.contains("HAS_TRIANGLE") || whitted.contains("HAS_PLANE") || whitted.contains("HAS_PICTURE") ||
                 whitted.contains("HAS_ABSORPTION"));
    EXPECT_TRUE(mirrors.contains("HAS_MIRROR") && mirrors.contains("HAS_DISK"));
    EXPECT_FALSE(mirrors.contains("HAS_GLASS") || mirrors.contains("HAS_BOX") || mirrors.contains("HAS_HOLE"));
    EXPECT_EQ(whitted.at("SCENE_LISTS"),
              "LIST(0, BOX, box_size, box_at) LIST(1, SPHERE, sphere_size, sphere_at) LIST(2, SPHERE, sphere_size, "
              "sphere_at) ");
}

TEST(Specialise, RunsOfManyShapesKeepTheirOrderAndNumber) {
    const auto pieces = short_runs({{"SPHERE", 10, 42, 2}, {"BOX", 90, 1, 2}});
    ASSERT_EQ(pieces.size(), 7u);
    EXPECT_EQ(pieces[1].first, 10 + 8 * 2);
    EXPECT_EQ(pieces[5].count, 2);
    EXPECT_EQ(pieces[6].kind, "BOX");
    EXPECT_EQ(short_runs({{"SPHERE", 10, 4000, 2}}).size(), 1u);
}

// The reference compiler of the language's makers is stricter than most drivers.
TEST(Shaders, GlslangAcceptsEveryVariant) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed (package glslang-tools)";
    const auto folder = std::filesystem::temp_directory_path() / ("course_shaders_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::string files;
    const auto write = [&](const std::string &name, const ShaderText &shader) {
        const auto file = folder / name;
        std::ofstream(file) << shader.text;
        files += " " + file.string();
    };
    write("screen.vert", compose("screen.vert", {}));
    write("triangles.vert", compose("triangles.vert", {}));
    for (const std::string &name : exhibit_names()) {
        const PackedScene scene = small_exhibit(name).scene;
        for (const std::string &walk : walk_names) {
            write(name + "_" + walk + ".frag", compose("trace.frag", shader_defines(scene, walk)));
            write(name + "_" + walk + "_all.frag", compose("trace.frag", shader_defines(with_everything(scene), walk)));
            Defines compute = shader_defines(scene, walk);
            need(compute, "COMPUTE");
            write(name + "_" + walk + ".comp", compose("trace.frag", compute));
        }
    }
    write("show.frag", compose("show.frag", {}));
    write("raster.vert", compose("raster.vert", {}));
    write("raster.frag", compose("raster.frag", {{"LAMPS", "2"}, {"RESOLUTION", "1024"}}));
    for (const std::string shape : {"sphere", "plane", "disk", "cylinder", "cone", "box", "triangle"})
        write("probe_" + shape + ".frag",
              compose(
                  "probe.frag",
                  {{"ROW", "64"}, {"SHAPE_AT", shape + "_at"}, {"SHAPE_SIZE", shape + "_size"}, {"LIST_COUNT", "1"}}));
    write("probe_optics.frag", compose("probe_optics.frag", {{"ROW", "64"}, {"HAS_GLASS", ""}}));
    EXPECT_EQ(std::system(("glslangValidator" + files + " > " + (folder / "log").string()).c_str()), 0)
        << std::ifstream(folder / "log").rdbuf();
    std::filesystem::remove_all(folder);
}

TEST(Shaders, ACompilersComplaintIsOneLineWithThePlace) {
    COURSE_CONTEXT_OR_SKIP(context);
    ShaderText shader = compose("sphere.glsl", {}); // without the ray that it needs
    const std::string line = refusal([&] { compile(context->gl(), GL_FRAGMENT_SHADER, shader); });
    EXPECT_EQ(line.substr(0, 20), "shader: sphere.glsl:");
    EXPECT_EQ(line.find('\n'), std::string::npos);
}

TEST(Limits, ABufferBeyondTheDriversLimitIsRefused) {
    COURSE_CONTEXT_OR_SKIP(context);
    const std::string line = refusal(
        [&] { TexelBuffer(context->gl(), "mesh", GL_RGBA32F, std::span<const glm::vec4>(), std::size_t{1} << 40); });
    EXPECT_EQ(line.substr(0, 42), "mesh: 1099511627776 texels are needed, and");
}

// A driver that holds less: the same functions, but for the one that is asked.
TEST(Limits, AMeshBeyondTheDriversLimitIsRefused) {
    COURSE_CONTEXT_OR_SKIP(context);
    static Gl small(context->gl()), all(context->gl());
    small.GetIntegerv = [](GLenum what, GLint *value) {
        all.GetIntegerv(what, value);
        if (what == GL_MAX_TEXTURE_BUFFER_SIZE)
            *value = 4096;
    };
    const PackedScene scene = small_exhibit("bunny").scene;
    const std::size_t texels = 4 * static_cast<std::size_t>(scene.trees.triangles());
    ASSERT_GT(texels, 4096u);
    const std::string line = refusal([&] { GpuTracer(small, scene, shader_defines(scene)); });
    EXPECT_NE(line.find(" texels are needed, and this driver's buffers hold 4096"), std::string::npos) << line;
}

// The numbers by which the shader knows triangles end at 2^24; so many are not made for a test, but the sum is checked.
TEST(Limits, AMeshBeyondTheNumbersIsRefused) {
    const Studio studio = studio_of("tests/golden/08_mesh.ply");
    const auto all = triangles(studio.mesh());
    const Bvh<Triangle<>> bvh{std::span<const Triangle<>>(all)};
    PackedTrees trees;
    EXPECT_EQ(refusal([&] { append_mesh(trees, {&bvh, &studio.mesh()}, 0); }), "");
    trees.corners.resize(3 * (std::size_t{1} << 24));
    EXPECT_EQ(refusal([&] {
                  append_mesh(trees, {&bvh, &studio.mesh()}, 0);
              }),
              "mesh: has more than the 16,777,216 triangles that the shader can number");
}

TEST(Limits, APictureBeyondTheDriversLimitIsRefused) {
    COURSE_CONTEXT_OR_SKIP(context);
    const PackedScene scene = pack(mirror_world());
    GpuTracer tracer(context->gl(), scene, shader_defines(scene));
    EXPECT_NE(refusal([&] { tracer.start(mirror_view(), 1 << 20, 1); }), "");
}
