#include "core/io/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

// A tetrahedron in each format.
constexpr const char* obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr const char* off =
    "OFF\n# four\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3 255 0 0\n";
constexpr const char* ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

constexpr float tetrahedron[4][3][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                        {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                        {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

std::string ascii_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& triangle : tetrahedron) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const auto& p : triangle) {
      text += "vertex";
      for (const float x : p) (text += ' ') += std::to_string(x);
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

std::string binary_stl() {
  std::string bytes = "solid, but binary";
  bytes.resize(80, ' ');
  const std::uint32_t count = 4;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& triangle : tetrahedron) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
    bytes.append(2, '\0');
  }
  return bytes;
}

void expect_unit_normals(const TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    EXPECT_NEAR(glm::length(mesh.normals[v]), 1.0f, 1e-6f) << "vertex " << v;
  }
}

using MeshFile = FolderTest;

TEST_F(MeshFile, ReadsEveryFormat) {
  const std::pair<const char*, std::string> files[] = {{"a.obj", obj},
                                                       {"a.OFF", off},
                                                       {"a.ply", ply},
                                                       {"ascii.stl", ascii_stl()},
                                                       {"binary.stl", binary_stl()}};
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const auto mesh = read_mesh(folder_.write(name, content));
    EXPECT_EQ(mesh->n_vertices(), 4u);
    EXPECT_EQ(mesh->n_faces(), 4u);
    expect_unit_normals(*mesh);
    // Smooth normals of a tetrahedron point away from its middle.
    for (std::size_t v = 0; v < mesh->n_vertices(); ++v) {
      EXPECT_GT(glm::dot(mesh->points[v] - glm::vec3(0.25f), mesh->normals[v]), 0.0f);
    }
  }
}

TEST_F(MeshFile, WeighsSmoothNormalsByArea) {
  // A triangle of area 8 in z = 0 and one of area 0.5 in x = 0 share the origin.
  const auto mesh = read_mesh(
      folder_.write("a.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 -1 0\nv 0 0 -1\nf 1 2 3\nf 1 4 5\n"));
  const auto normal = mesh->normals[0];
  EXPECT_NEAR(normal[0], 0.5f / std::hypot(8.0f, 0.5f), 1e-6f);
  EXPECT_NEAR(normal[2], 8.0f / std::hypot(8.0f, 0.5f), 1e-6f);
}

TEST_F(MeshFile, SmoothsSeamsAndKeepsEdges) {
  // Two squares touch along x = 1 without sharing vertices; the second is bent up by `rise`.
  const auto normal_at_seam = [&](const char* rise) {
    const std::string right = std::string("v 2 0 ") + rise + "\nv 2 1 " + rise + "\n";
    const auto mesh =
        read_mesh(folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\n" + right +
                                             "v 1 1 0\nf 1 2 3 4\nf 5 6 7 8\n"));
    return mesh->normals[1];
  };
  // 45 degrees: one surface, its normal between the two. 80 degrees: an edge.
  EXPECT_LT(normal_at_seam("1")[0], -0.3f);
  EXPECT_EQ(normal_at_seam("5.67")[0], 0.0f);
}

TEST_F(MeshFile, UsesNormalsOfTheFileAndKeepsCreases) {
  const auto mesh =
      read_mesh(folder_.write("a.obj",
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 5\nvn 1 0 0\nvn 0 0 0\n"
                              "f 1//1 2//1 3//1\nf -4//-2 3//2 4//3\n"));
  EXPECT_EQ(mesh->n_vertices(), 6u) << "the two points of the crease have two normals each";
  expect_unit_normals(*mesh);
  EXPECT_EQ(mesh->normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh->normals[3], glm::vec3(1, 0, 0));
}

TEST_F(MeshFile, UsesNormalsOfPlyAndOff) {
  const auto of_off = read_mesh(
      folder_.write("a.off", "NOFF 3 1 0\n0 0 0 0 3 4\n1 0 0 0 3 4\n0 1 0 0 3 4\n3 0 1 2\n"));
  const auto of_ply = read_mesh(folder_.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar uint vertex_index\nend_header\n"
      "0 3 4 0 0 0\n0 3 4 1 0 0\n0 3 4 0 1 0\n3 0 1 2\n"));
  for (const auto& mesh : {of_off, of_ply}) {
    for (const glm::vec3& normal : mesh->normals) {
      EXPECT_NEAR(glm::distance(normal, glm::vec3(0, 0.6f, 0.8f)), 0.0f, 1e-6f);
    }
  }
}

TEST_F(MeshFile, SplitsPolygonsAndAcceptsNonManifolds) {
  EXPECT_EQ(read_mesh(folder_.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"))
                ->n_faces(),
            2u);
  // Three triangles on one edge, one of them twice.
  EXPECT_EQ(read_mesh(folder_.write("fan.obj",
                                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\n"
                                    "f 1 2 4\nf 1 2 5\nf 1 2 5\n"))
                ->n_faces(),
            4u);
}

// Faces of a triangle with one bad face behind it in line 5, and the others.
TEST_F(MeshFile, LeavesOutBadFacesOfObj) {
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* bad : {"f 1 2 4", "f 0 1 2", "f -1 -2 -4", "f 1 2 99999999999999999999",
                          "f 1 2 x", "f 1 2", "f", "f 1/1/1 2/2/2 9/3/3"}) {
    SCOPED_TRACE(bad);
    std::vector<std::string> warnings;
    const auto file = folder_.write("a.obj", good + bad + "\nf 3 2 1\nf 7 8 9\n");
    EXPECT_EQ(read_mesh(file, &warnings)->n_faces(), 2u);
    EXPECT_EQ(read_mesh(file)->n_vertices(), 3u);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(warnings[0].starts_with(file.string() + ": line 5: found a face")) << warnings[0];
    EXPECT_TRUE(contains(warnings[0], "2 in all"));
  }
  std::vector<std::string> warnings;
  const auto file = folder_.write("a.obj", "f 1//1 2//1 3//1\n" + good);
  EXPECT_EQ(read_mesh(file, &warnings)->n_faces(), 2u) << "indices may run ahead";
  EXPECT_TRUE(warnings.empty()) << "normals that are not there are computed";
}

TEST_F(MeshFile, JoinsLinesOfObj) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text =
        "\xef\xbb\xbfv 0 0 \\|0|v 1 0 0|v 1 1 0|v 0\\|1 0|g a \\|b|# folder C:\\|"
        "f 1 2 \\|3\\|4|";
    for (std::size_t i = text.find('|'); i != text.npos; i = text.find('|')) {
      text.replace(i, 1, end);
    }
    std::vector<std::string> warnings;
    EXPECT_EQ(read_mesh(folder_.write("a.obj", text), &warnings)->n_faces(), 2u);
    EXPECT_TRUE(warnings.empty()) << warnings[0];
  }
}

TEST_F(MeshFile, ReadsSpellingsOfStl) {
  std::string upper = ascii_stl();
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string one_line = ascii_stl().substr(ascii_stl().find('\n') + 1);
  std::ranges::replace(one_line, '\n', ' ');
  const std::pair<const char*, std::string> files[] = {
      {"upper case", upper},
      {"byte order mark", "\xef\xbb\xbf" + ascii_stl()},
      {"blanks before", "\n  \t" + ascii_stl()},
      {"one line", "Solid\n" + one_line},
      {"bytes behind", binary_stl() + "trailer"},
      {"count and solid", binary_stl()}};
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    EXPECT_EQ(read_mesh(folder_.write("a.stl", content))->n_faces(), 4u);
  }
  EXPECT_EQ(read_mesh(folder_.write("a.stl", ascii_stl() + upper))->n_faces(), 8u);
  expect_error([&] { read_mesh(folder_.write("a.stl", ascii_stl() + "solid b\n")); },
               "without endsolid");
}

TEST_F(MeshFile, ReadsSpellingsOfPly) {
  const std::string header =
      "ply\ncomment by a test\nformat ascii 1.0\nobj_info none\nelement vertex 4\n"
      "property float32 x\nproperty float32 y\nproperty float32 z\n"
      "property list uint8 int32 neighbours\nelement edge 1\nproperty int a\n";
  const std::string vertices = "0 0 0 0\n1 0 0 1 0\n0 1 0 0\n0 0 1 2 1 2\n7\n";
  const std::pair<std::string, std::string> faces[] = {
      {"element face 2\nproperty uchar flags\nproperty list uint8 uint32 vertex_index\n",
       "0 3 0 1 2\n9 3 1 3 2\n"},
      {"element tristrips 1\nproperty list int int vertex_indices\n", "8 0 1 2 -1 1 2 3 -1\n"},
      {"element tristrips 1\nproperty list int int vertex_indices\n", "4 0 1 2 3\n"}};
  for (const auto& [element, rows] : faces) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
      std::string text = header + element + "end_header\n" + vertices + rows;
      for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + strlen(end))) {
        text.replace(i, 1, end);
      }
      EXPECT_EQ(read_mesh(folder_.write("a.ply", text))->n_faces(), 2u) << element;
    }
  }
}

// Every second triangle of a strip is turned round: all of a flat one face up.
TEST_F(MeshFile, StripsOfPlyFaceOneSide) {
  const MeshArrays mesh = to_arrays(*read_mesh(folder_.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n")));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 side = mesh.points[t.y] - mesh.points[t.x];
    EXPECT_GT(glm::cross(side, mesh.points[t.z] - mesh.points[t.x]).z, 0.0f);
  }
}

// Wuson.ply of Debian's assimp-testmodels has such a line.
TEST_F(MeshFile, SkipsUnknownLinesOfAPlyHeader) {
  const std::string created = "Created by Blender3D 247 - www.blender.org, source file: \n";
  for (const auto& [lines, told] :
       {std::pair(created, "line 3: found the unknown keyword Created; the line is skipped"),
        std::pair(
            created + "Exported at noon\n" + created,
            "line 3: found the unknown keyword Created; the line is skipped, as are 2 more")}) {
    std::string text = ply;
    text.insert(text.find("element"), lines);
    std::vector<std::string> warnings;
    const auto file = folder_.write("a.ply", text);
    EXPECT_EQ(read_mesh(file, &warnings)->n_faces(), 4u);
    EXPECT_EQ(warnings, std::vector{file.string() + ": " + told});
  }
}

TEST_F(MeshFile, ReadsObjInUtf16) {
  std::string little = "\xff\xfe";
  for (const char* c = obj; *c != 0; ++c) (little += *c) += '\0';
  EXPECT_EQ(read_mesh(folder_.write("a.obj", little))->n_faces(), 4u);
}

struct BadFile {
  const char* name;
  const char* file;
  std::string content;
  const char* place;
};

TEST_F(MeshFile, RefusesBadFilesAndNamesThePlace) {
  const std::string o = obj;
  const std::string p = ply;
  const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  };
  std::string huge_stl = binary_stl();
  huge_stl.replace(80, 4, "\xff\xff\xff\xff");
  std::string nan_stl = binary_stl();
  nan_stl.replace(84 + 12, 4, "\xff\xff\xff\x7f");
  const BadFile files[] = {
      {"empty", "a.obj", "", "empty"},
      {"unknown format", "a.fbx", "x", "found a mesh of format .fbx"},
      {"no extension", "a", "x", "allowed: .obj, .ply, .stl, .off"},
      {"obj: no faces", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no faces, only vertices (3)"},
      {"obj: lines", "a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n",
       "no faces, only vertices (2), lines (1)"},
      {"obj: nothing", "a.obj", "# nothing\n", "no faces and no vertices"},
      {"obj: only degenerate faces", "a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n", "no faces"},
      {"obj: only bad faces", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "no faces"},
      {"obj: a word", "a.obj", "v 0 zero 0\n" + o, "line 1"},
      {"obj: NaN", "a.obj", o + "v nan 0 0\n", "line 9"},
      {"obj: huge", "a.obj", o + "v 0 0 1e20\n", "line 9"},
      {"obj: vertex cut short", "a.obj", "v 0 0\n" + o, "line 1"},
      {"off: garbage", "a.off", "\x01\x02\x03", "line 1"},
      {"off: no counts", "a.off", "OFF\n", "count"},
      {"off: huge counts", "a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", "count of 4000000000"},
      {"off: negative count", "a.off", "OFF\n-1 1 0\n", "count of -1"},
      {"off: truncated vertices", "a.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n", "after 2 of 4 vertices"},
      {"off: truncated faces", "a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
       "after 1 of 2"},
      {"off: index", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6"},
      {"off: long face", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "line 6"},
      {"off: binary", "a.off", "OFF BINARY\n", "not supported"},
      {"ply: no faces", "a.ply",
       p.substr(0, p.find("element face")) + "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
       "no faces"},
      {"ply: huge vertex count", "a.ply", replaced(p, "vertex 4", "vertex 4000000000"),
       "too short"},
      {"ply: huge face count", "a.ply", replaced(p, "face 4", "face 4000000000"), "too short"},
      {"ply: huge list", "a.ply", replaced(p, "3 1 2 3", "4000000000 1 2 3"), "face 3"},
      {"ply: negative list", "a.ply", replaced(p, "3 1 2 3", "-3 1 2 3"), "face 3"},
      {"ply: index", "a.ply", replaced(p, "3 1 2 3", "3 1 2 4"), "face 3"},
      {"ply: negative index", "a.ply", replaced(p, "3 1 2 3", "3 1 2 -1"), "face 3"},
      {"ply: NaN", "a.ply", replaced(p, "0 1 0\n", "0 nan 0\n"), "vertex 2"},
      {"ply: truncated", "a.ply", p.substr(0, p.size() - 4), "face 3"},
      {"ply: no position", "a.ply", replaced(p, "float z", "float w"), "x y z"},
      {"stl: garbage", "a.stl", std::string(200, 'x'), "header"},
      {"stl: short", "a.stl", "abc", "header"},
      {"stl: huge count", "a.stl", huge_stl.substr(5), "header"},
      {"stl: truncated", "a.stl", std::string(150, 'x'), "header"},
      {"stl: NaN", "a.stl", nan_stl, "triangle 0"},
      {"stl: ascii truncated", "a.stl", replaced(ascii_stl(), "endsolid tetrahedron\n", ""),
       "endsolid"},
      {"stl: ascii facet of two", "a.stl", replaced(ascii_stl(), "vertex", "#"), "keyword"},
      {"stl: no facets", "a.stl", "solid a\nendsolid a\n", "no faces"},
  };
  for (const auto& [name, file_name, content, place] : files) {
    SCOPED_TRACE(name);
    const auto file = folder_.write(file_name, content);
    expect_error([&] { read_mesh(file); }, {file.string(), place});
  }
  expect_error([&] { read_mesh(folder_ / "none.obj"); }, "no such file");
  std::filesystem::create_directory(folder_ / "folder.obj");
  expect_error([&] { read_mesh(folder_ / "folder.obj"); }, "is a folder");
}

// Whatever is cut off or damaged: a mesh or an InputError, never anything else.
TEST_F(MeshFile, SurvivesTruncationAndDamage) {
  const std::pair<const char*, std::string> files[] = {{"a.obj", obj},
                                                       {"a.off", off},
                                                       {"a.ply", ply},
                                                       {"b.stl", ascii_stl()},
                                                       {"c.stl", binary_stl()}};
  std::size_t refused = 0;
  for (const auto& file : files) {
    const auto read = [&](const std::string& bytes) {
      read_mesh(folder_.write(file.first, bytes));
    };
    refused += refused_damages(file.second, read, 0x55);
    for (std::size_t size = 0; size < file.second.size(); ++size) {
      try {
        read(file.second.substr(0, size));
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 1000u);
}

}  // namespace
}  // namespace brume
