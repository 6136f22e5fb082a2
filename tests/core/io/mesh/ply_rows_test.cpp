// Rows of binary PLY files that are read in parallel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "brume/mesh_arrays.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/ply.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/random.h"

namespace brume {
namespace {

// A PLY file as it is written, in each of its formats.
class PlyText {
 public:
  enum class Format { ascii, little, big };

  explicit PlyText(Format format) : format_(format) {
    constexpr const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    header_ = std::string("ply\nformat ") + names[static_cast<int>(format)] + " 1.0\n";
  }
  void header(const std::string& line) { header_ += line + "\n"; }
  template <class Number>
  void add(Number value) {
    if (format_ == Format::ascii) {
      char text[32];
      std::snprintf(text, sizeof text, "%.17g ", static_cast<double>(value));
      data_ += text;
      return;
    }
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (format_ == Format::big) std::ranges::reverse(bytes);
    data_ += bytes;
  }
  void end_row() {
    if (format_ == Format::ascii) data_ += "\n";
  }
  [[nodiscard]] std::string bytes() const { return header_ + "end_header\n" + data_; }

 private:
  Format format_;
  std::string header_;
  std::string data_;
};

// The content of a random file; the same seed makes the same content in every format.
std::string random_ply(unsigned seed, PlyText::Format format) {
  Random random(seed);
  const auto one_of = [&](int count) { return static_cast<int>(random.uniform(0.0, count)); };
  PlyText ply(format);
  const int vertices = 3 + one_of(40);
  const int faces = 1 + one_of(40);
  const int corners = 3 + one_of(3);
  const bool are_doubles = one_of(2) == 0;
  const bool has_normals = one_of(2) == 0;
  const bool has_colors = one_of(2) == 0;
  const bool has_texcoords = one_of(2) == 0;
  const bool has_weights = one_of(2) == 0;
  const bool has_sensors = one_of(2) == 0;
  const bool has_flags = one_of(2) == 0;
  const bool are_shorts = one_of(2) == 0;
  const bool has_repeated = one_of(2) == 0;
  const std::string number = are_doubles ? "double " : "float ";
  if (has_sensors) {
    ply.header("element sensor 2");
    ply.header("property short id");
  }
  ply.header("element vertex " + std::to_string(vertices));
  if (has_weights) ply.header("property list ushort float weights");
  for (const char* name : {"x", "y", "z"}) ply.header("property " + number + name);
  if (has_normals) {
    for (const char* name : {"nx", "ny", "nz"}) ply.header(std::string("property float ") + name);
  }
  if (has_colors) {
    for (const char* name : {"red", "green", "blue"})
      ply.header(std::string("property uchar ") + name);
  }
  if (has_texcoords) {
    for (const char* name : {"s", "t"}) ply.header(std::string("property float ") + name);
  }
  ply.header("element face " + std::to_string(faces));
  if (has_flags) ply.header("property char flag");
  ply.header(std::string("property list uchar ") + (are_shorts ? "ushort" : "int") +
             " vertex_indices");
  if (has_flags) ply.header("property double quality");

  const auto add_number = [&] {
    const double value = random.uniform(-4.0, 4.0);
    are_doubles ? ply.add(value) : ply.add(static_cast<float>(value));
  };
  const auto add_float = [&] { ply.add(static_cast<float>(random.uniform(-1.0, 1.0))); };
  for (int i = 0; has_sensors && i < 2; ++i) {
    ply.add(static_cast<std::int16_t>(-i));
    ply.end_row();
  }
  for (int i = 0; i < vertices; ++i) {
    if (has_weights) {
      ply.add(std::uint16_t{2});
      for (int k = 0; k < 2; ++k) add_float();
    }
    for (int k = 0; k < 3; ++k) add_number();
    for (int k = 0; has_normals && k < 3; ++k) add_float();
    for (int k = 0; has_colors && k < 3; ++k) ply.add(static_cast<std::uint8_t>(one_of(256)));
    for (int k = 0; has_texcoords && k < 2; ++k) add_float();
    ply.end_row();
  }
  for (int i = 0; i < faces; ++i) {
    if (has_flags) ply.add(static_cast<std::int8_t>(-one_of(100)));
    ply.add(static_cast<std::uint8_t>(corners));
    int last = 0;
    for (int k = 0; k < corners; ++k) {
      const int corner = has_repeated && k > 0 && one_of(4) == 0 ? last : one_of(vertices);
      are_shorts ? ply.add(static_cast<std::uint16_t>(corner)) : ply.add(corner);
      last = corner;
    }
    if (has_flags) ply.add(random.uniform(0.0, 1.0));
    ply.end_row();
  }
  return ply.bytes();
}

using PlyRows = FolderTest;

TEST_F(PlyRows, EqualRowsHaveTheValuesOfEachRow) {
  for (unsigned seed = 0; seed < random_cases(50); ++seed) {
    for (const auto format : {PlyText::Format::little, PlyText::Format::big}) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const std::string bytes = random_ply(seed, format);
      const PlyFile ply("a.ply", bytes);
      const auto rows = ply.equal_rows();
      ASSERT_TRUE(rows);
      ply.for_each_row(
          [&](const PlyFile::Element& element, std::uint64_t row, const PlyFile::Row& expected) {
            const auto& own = (*rows)[static_cast<std::size_t>(&element - ply.elements().data())];
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
              if (!element.properties[p].list_count) {
                ASSERT_EQ(own.value(row, p), expected.scalars[p]);
                continue;
              }
              ASSERT_EQ(own.length(p), expected.lists[p].size());
              for (std::size_t i = 0; i < own.length(p); ++i)
                ASSERT_EQ(own.value(row, p, i), expected.lists[p][i]);
            }
          });
    }
  }
}

TEST_F(PlyRows, MeshesAreThoseOfTheSameFileInAscii) {
  for (unsigned seed = 0; seed < random_cases(50); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto read = [&](PlyText::Format format) -> MeshArrays {
      const auto file = folder_.write("a.ply", random_ply(seed, format));
      try {
        return to_arrays(*read_mesh(file));
      } catch (const InputError& error) {  // all faces may have too few different corners
        EXPECT_TRUE(contains(error.what(), "no faces"));
        return {};
      }
    };
    const MeshArrays ascii = read(PlyText::Format::ascii);
    EXPECT_EQ(read(PlyText::Format::little), ascii);
    EXPECT_EQ(read(PlyText::Format::big), ascii);
  }
}

// A file of two faces, of so many corners and with these indices.
std::string two_faces(std::uint8_t second_count, std::int32_t last_index, float last_x = 1.0f) {
  PlyText ply(PlyText::Format::little);
  ply.header("element vertex 4");
  for (const char* name : {"x", "y", "z"}) ply.header(std::string("property float ") + name);
  ply.header("element face 2");
  ply.header("property list uchar int vertex_indices");
  for (int i = 0; i < 4; ++i) {
    ply.add(i == 3 ? last_x : static_cast<float>(i));
    ply.add(static_cast<float>(i % 2));
    ply.add(0.0f);
  }
  ply.add(std::uint8_t{3});
  for (std::int32_t k = 0; k < 3; ++k) ply.add(k);
  ply.add(second_count);
  for (std::int32_t k = 1; k < second_count; ++k) ply.add(k - 1);
  ply.add(last_index);
  return ply.bytes();
}

TEST_F(PlyRows, FacesOfSeveralSizesAreReadOneByOne) {
  const std::string bytes = two_faces(4, 3);
  EXPECT_FALSE(PlyFile("a.ply", bytes).equal_rows());
  EXPECT_EQ(read_mesh(folder_.write("a.ply", bytes))->n_faces(), 3u);
}

TEST_F(PlyRows, DamagedFilesNameTheirPlace) {
  const auto expect_refused = [&](const std::string& bytes, const char* place) {
    expect_error([&] { read_mesh(folder_.write("a.ply", bytes)); }, place);
  };
  EXPECT_EQ(read_mesh(folder_.write("a.ply", two_faces(3, 3)))->n_faces(), 2u);
  expect_refused(two_faces(3, 4), "face 1");
  expect_refused(two_faces(3, -1), "face 1");
  expect_refused(two_faces(3, 3, std::numeric_limits<float>::infinity()), "vertex 3");
  const std::string whole = two_faces(3, 3);
  EXPECT_FALSE(PlyFile("a.ply", std::string_view(whole).substr(0, whole.size() - 1)).equal_rows());
  expect_refused(whole.substr(0, whole.size() - 1), "face 1: vertex_indices");
}

}  // namespace
}  // namespace brume
