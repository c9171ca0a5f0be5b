// Mesh files: the same tetrahedron out of every format, and one clear refusal for every kind of bad file.
#include "common/errors.hpp"
#include "common/mesh_files.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

using namespace course;

namespace {

using namespace std::string_literals;

class MeshFiles : public testing::Test {
  protected:
    MeshFiles() { std::filesystem::create_directories(folder_); }
    ~MeshFiles() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string &name, const std::string &content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }

    // The refusal must be one line, begin with the file's name and hold the given words.
    void expect_refusal(const std::string &name, const std::string &content, const std::string &words) const {
        expect_refusal(write(name, content), words);
    }
    static void expect_refusal(const std::filesystem::path &file, const std::string &words) {
        try {
            read_mesh(file);
            ADD_FAILURE() << file << " was read";
        } catch (const InputError &error) {
            const std::string line = error.what();
            EXPECT_TRUE(line.starts_with(file.string() + ": ")) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
            EXPECT_NE(line.find(words), std::string::npos) << line;
        }
    }

    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() /
        ("course_mesh_files_"s + testing::UnitTest::GetInstance()->current_test_info()->name());
};

template <class Number> std::string bytes(Number number, bool swapped = false) {
    std::string text(reinterpret_cast<const char *>(&number), sizeof number);
    return swapped ? std::string(text.rbegin(), text.rend()) : text;
}

// A tetrahedron: corners, and faces that wind counter-clockwise seen from outside.
constexpr float corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5f}};
constexpr int face[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

std::string obj_text() {
    std::string text = "# a tetrahedron\n";
    for (const auto &p : corner)
        text += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    for (const auto &f : face)
        text +=
            "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " + std::to_string(f[2] + 1) + "\n";
    return text;
}

std::string off_text() {
    std::string text = "OFF\n4 4 0\n";
    for (const auto &p : corner)
        text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    for (const auto &f : face)
        text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
    return text;
}

std::string ply_header(const std::string &format, const std::string &line_end = "\n") {
    std::string header;
    for (const std::string &line : {"ply"s, "format " + format + " 1.0", "comment made by hand"s, "element vertex 4"s,
                                    "property float x"s, "property float y"s, "property float z"s, "element face 4"s,
                                    "property list uchar int vertex_indices"s, "end_header"s})
        header += line + line_end;
    return header;
}

std::string ply_text() {
    std::string text = ply_header("ascii");
    const std::string off = off_text();
    return text + off.substr(off.find("0\n") + 2);
}

std::string ply_binary(bool big) {
    std::string text = ply_header(big ? "binary_big_endian" : "binary_little_endian");
    for (const auto &p : corner)
        for (const float x : p)
            text += bytes(x, big);
    for (const auto &f : face) {
        text += '\3';
        for (const int i : f)
            text += bytes(i, big);
    }
    return text;
}

std::string stl_text() {
    std::string text = "solid tetrahedron\n";
    for (const auto &f : face) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int i : f)
            text += "vertex " + std::to_string(corner[i][0]) + " " + std::to_string(corner[i][1]) + " " +
                    std::to_string(corner[i][2]) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid tetrahedron\n";
}

std::string stl_binary(const std::string &head = "binary") {
    std::string text = head + std::string(80 - head.size(), ' ') + bytes(std::uint32_t{4});
    for (const auto &f : face) {
        text += std::string(12, '\0');
        for (const int i : f)
            for (const float x : corner[i])
                text += bytes(x);
        text += std::string(2, '\0');
    }
    return text;
}

void expect_tetrahedron(const MeshFile &mesh) {
    ASSERT_EQ(mesh.points.size(), 4u);
    ASSERT_EQ(mesh.triangles.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec<float> &p = mesh.points[mesh.triangles[i][k]];
            const auto &expected = corner[face[i][k]];
            EXPECT_EQ(p, Vec<float>(expected[0], expected[1], expected[2]));
        }
}

TEST_F(MeshFiles, TheSameMeshOutOfEveryFormat) {
    expect_tetrahedron(read_mesh(write("a.obj", obj_text())));
    expect_tetrahedron(read_mesh(write("a.OBJ", obj_text())));
    expect_tetrahedron(read_mesh(write("a.off", off_text())));
    expect_tetrahedron(read_mesh(write("a.ply", ply_text())));
    expect_tetrahedron(read_mesh(write("little.ply", ply_binary(false))));
    expect_tetrahedron(read_mesh(write("big.ply", ply_binary(true))));
    expect_tetrahedron(read_mesh(write("a.stl", stl_text())));
    expect_tetrahedron(read_mesh(write("binary.stl", stl_binary())));
    expect_tetrahedron(read_mesh(write("solid.stl", stl_binary("solid but binary"))));
}

TEST_F(MeshFiles, ObjAsItIsFoundInTheWild) {
    const std::string points = "v 0 0 0 1 0 0\r\nv 1 0 0\r\nv\t0\t1\t0\r\nv +0.0 0 1.5e0\r\n";
    expect_tetrahedron(read_mesh(write("crlf.obj", points + "f 1 3 2\r\nf 1 2 4\r\nf 2 3 4\r\nf 3 1 4\r\n")));
    expect_tetrahedron(
        read_mesh(write("uv.obj", points + "vt 0 0\nvn 0 0 1\nusemtl tin\ns off\nl 1 2\nf 1/1/1\t3/1/1\t2/1/1\n"
                                           "f 1//1 2//1 4//1 # base\nf 2/1 3/1 4/1\nf 3 1 4")));
    expect_tetrahedron(read_mesh(write("back.obj", points + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n")));
}

TEST_F(MeshFiles, PolygonsBecomeFans) {
    const auto mesh = read_mesh(write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.5 2 0\nv 0 1 0\nf 1 2 3 4 5\n"));
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.triangles[2], (std::array<std::uint32_t, 3>{0, 3, 4}));
    EXPECT_EQ(read_mesh(write("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n")).triangles.size(),
              2u);
    EXPECT_EQ(read_mesh(write("c.off", "COFF\n3 1 0\n0 0 0 1 2 3\n1 0 0\n1 1 0 9\n3 0 1 2\n")).triangles.size(), 1u);
}

TEST_F(MeshFiles, NoFileNoMesh) {
    expect_refusal(folder_ / "absent.obj", "no such file");
    expect_refusal(folder_, "is a folder");
    expect_refusal("a.xyz", obj_text(), "ending");
    expect_refusal("noending", obj_text(), "ending");
    for (const char *name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
        expect_refusal(name, "", "is empty");
        expect_refusal(name, "\n", "");
        expect_refusal(name, "Call me Ishmael. Some years ago,\nnever mind how long precisely\n", "");
        expect_refusal(name, std::string(3000, '\0'), "");
        expect_refusal(name, std::string(3000, '\xff'), "");
        expect_refusal(name, "solid \xff\xff\xff\xff"s + std::string(200, 'f'), "");
    }
}

TEST_F(MeshFiles, PointsWithoutFaces) {
    expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no face");
    expect_refusal("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no face");
    expect_refusal("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                   "end_header\n0 0 0\n",
                   "no faces");
    expect_refusal("a.stl",
                   "solid nothing at all in here, but long enough to be taken for a binary file by some\n"
                   "endsolid nothing\n",
                   "no face");
}

TEST_F(MeshFiles, CoordinatesThatAreNotFinite) {
    for (const std::string odd : {"nan", "inf", "-inf", "1e39", "1e400", "abc", "0x1p3z"}) {
        const std::string point = "0 " + odd + " 0\n";
        expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv " + point + "f 1 2 3\n", "line 3");
        expect_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n" + point + "3 0 1 2\n", "line 5");
        std::string ply = ply_text(), stl = stl_text();
        expect_refusal("a.ply", ply.replace(ply.find("1.500000"), 8, odd), "");
        expect_refusal("a.stl", stl.replace(stl.find("1.500000"), 8, odd), "");
    }
    for (const float odd : {std::nanf(""), INFINITY}) {
        for (const bool big : {false, true}) {
            std::string ply = ply_binary(big);
            expect_refusal("a.ply", ply.replace(ply.find(bytes(1.5f, big)), 4, bytes(odd, big)), "not finite");
        }
        std::string stl = stl_binary();
        expect_refusal("a.stl", stl.replace(stl.find(bytes(1.5f)), 4, bytes(odd)), "facet 2");
    }
}

TEST_F(MeshFiles, IndicesOutOfRange) {
    for (const std::string odd :
         {"4", "0", "-4", "99999999999999999999", "2147483648", "-2147483649", "x", "1.5", "/1"})
        expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + odd + "\n", "point");
    for (const std::string odd : {"3", "-1", "4294967296", "1e300", "nan", "x"})
        expect_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + odd + "\n", "line 6");
    for (const std::string odd : {"3 0 1 4", "3 0 1 -1", "3 0 1 99999999999", "-3 0 1 2", "2 0 1", "99999999 1 2 3"}) {
        std::string ply = ply_text();
        expect_refusal("a.ply", ply.replace(ply.find("3 0 2 1"), 7, odd), "");
    }
    for (const bool big : {false, true})
        for (const int odd : {4, -1, 0x7fffffff}) {
            std::string ply = ply_binary(big);
            expect_refusal("a.ply", ply.replace(ply.size() - 4, 4, bytes(odd, big)), "not there");
        }
}

TEST_F(MeshFiles, CountsThatPromiseTooMuch) {
    expect_refusal("a.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", "ends before point 2");
    expect_refusal("a.off", "OFF\n-1 5 0\n", "numbers of points");
    expect_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", "line 6");
    std::string ply = ply_text();
    expect_refusal("a.ply", ply.replace(ply.find("vertex 4"), 8, "vertex 2000000000"), "promises");
    std::string lists = ply_header("binary_little_endian");
    lists.replace(lists.find("uchar"), 5, "uint");
    expect_refusal("a.ply", lists + std::string(48, '\0') + bytes(0xffffffffu) + std::string(60, '\1'), "promises");
    std::string stl = stl_binary();
    expect_refusal("a.stl", stl.replace(80, 4, bytes(0xffffffffu)), "promises");
}

TEST_F(MeshFiles, HeadersOfPlyThatTheReaderWouldMistake) {
    const auto changed = [](const std::string &from, const std::string &to) {
        std::string ply = ply_text();
        return ply.replace(ply.find(from), from.size(), to);
    };
    expect_refusal("a.ply", changed("float x", "float q"), "x, y and z");
    expect_refusal("a.ply", changed("float x", "int x"), "x, y and z");
    expect_refusal("a.ply", changed("float x", "quaternion x"), "unknown kind");
    expect_refusal("a.ply", changed("vertex_indices", "corners"), "vertex_indices");
    expect_refusal("a.ply", changed("uchar int vertex_indices", "uchar short vertex_indices"), "vertex_indices");
    expect_refusal("a.ply", changed("ascii", "ebcdic"), "format");
    expect_refusal("a.ply", changed("end_header", "end"), "end");
}

// Cut anywhere, a file is refused or, where what is left happens to be well-formed, read as what it says.
TEST_F(MeshFiles, CutShortAnywhereNothingCrashes) {
    const auto expect_refused = [this](const std::string &name, const std::string &content, std::size_t allowed) {
        std::set<std::size_t> read;
        for (std::size_t length = 0; length + 1 < content.size(); length += 1 + content.size() / 60)
            try {
                read_mesh(write(name, content.substr(0, length)));
                read.insert(length);
            } catch (const InputError &) {
            }
        EXPECT_LE(read.size(), allowed) << name;
    };
    // An OBJ file does not say how many faces it has: a cut in the last two goes unnoticed, every point is named by
    // then.
    expect_refused("a.obj", obj_text(), 5);
    expect_refused("a.off", off_text(), 0);
    expect_refused("a.ply", ply_text(), 0);
    expect_refused("b.ply", ply_binary(false), 0);
    expect_refused("a.stl", stl_text(), 1); // the name after endsolid is no loss
    expect_refused("b.stl", stl_binary(), 0);
}

} // namespace
