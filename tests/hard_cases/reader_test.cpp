// Readers' kernels: what works is measured, and what does not compile, crashes or loops is said.
#include "common/errors.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/reader.hpp"

#include <gtest/gtest.h>

#include <fstream>

using namespace course;
using namespace course::hard;

namespace {

std::string file_with(const std::string &name, const std::string &text) {
    const auto path = std::filesystem::temp_directory_path() / ("course_reader_test_" + name);
    std::ofstream(path) << text;
    return path.string();
}

std::string why_not(const std::string &file) {
    try {
        const Reader reader(file);
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

std::vector<double> run(Reader &reader) {
    const std::vector<Ray<float>> rays(3, {{0, 0, 5}, {0, 0, -1}});
    const std::vector<Sphere<>> spheres(3, {{0, 0, 0}, 1});
    std::vector<double> t(3);
    reader.run("sphere", "float", rays.data(), sizeof rays[0] * 3, spheres.data(), sizeof spheres[0] * 3, t, 1);
    return t;
}

const std::string signature = "float sphere(const float *, const float *, float, float, const float *, float) ";

TEST(Readers, TheExampleAnswers) {
    Reader reader("tests/hard_cases/example_kernel.cpp");
    EXPECT_TRUE(reader.has("sphere", "float"));
    EXPECT_FALSE(reader.has("sphere", "double"));
    EXPECT_FALSE(reader.has("cone", "float"));
    EXPECT_EQ(run(reader), std::vector<double>(3, 4.0));
    EXPECT_TRUE(reader.failures().empty());
}

TEST(Readers, ACrashAndALoopAreReported) {
    Reader crash(file_with("crash.cpp", signature + "{ __builtin_trap(); }"));
    EXPECT_EQ(run(crash), std::vector<double>(3, hard::no_hit));
    ASSERT_EQ(crash.failures().size(), 1u);
    EXPECT_NE(crash.failures()[0].find("crashed"), std::string::npos);

    Reader loop(file_with("loop.cpp", signature + "{ for (volatile int i = 0;; i = i + 1) {} }"), 1);
    EXPECT_EQ(run(loop), std::vector<double>(3, hard::no_hit));
    ASSERT_EQ(loop.failures().size(), 1u);
    EXPECT_NE(loop.failures()[0].find("did not finish"), std::string::npos);
}

TEST(Readers, WhatCannotBeUsedIsRefusedInOneLine) {
    EXPECT_NE(why_not("no_such_file.cpp").find("no such file"), std::string::npos);
    EXPECT_NE(why_not(file_with("wrong.cpp", "this is not C++")).find("does not compile"), std::string::npos);
    EXPECT_NE(why_not(file_with("empty.cpp", "int other();")).find("defines no function"), std::string::npos);
}

} // namespace
