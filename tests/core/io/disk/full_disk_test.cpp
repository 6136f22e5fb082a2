#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <functional>
#include <ostream>

#include "core/io/disk/atomic_file.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/gather.h"
#include "core/io/scene/scene_file.h"
#include "core/io/volume/volume_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// While one lives, no file grows beyond a limit [bytes]: writing fails as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::uintmax_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &old_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
};

struct Writer {
  const char* name;  // of the file
  std::function<void(const fs::path&)> write;
};

std::vector<Gaussian> some_gaussians() {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 1000; ++i) gaussians.push_back({{i / 7.0, i / 11.0, i / 13.0}, 1.0, 0.5});
  return gaussians;
}

Scene some_scene() {
  Scene scene;
  for (const Gaussian& gaussian : some_gaussians()) scene.medium.append(gaussian);
  return scene;
}

// Values that do not compress.
ImageLayers incompressible_image() {
  ImageLayers image;
  image.width = 64;
  image.height = 48;
  std::vector<float>& values = image.channels["R"];
  for (std::uint32_t i = 0; i < 64 * 48; ++i) {
    values.push_back(static_cast<float>(i * 2654435761u % 1000003u));
  }
  return image;
}

DensityGrid some_grid() {
  DensityGrid grid;
  for (int block = 0; block < 40; ++block) {
    DensityGrid::Block& added = grid.blocks.emplace_back();
    added.corner = {DensityGrid::side * block, 0, 0};
    for (std::size_t i = 0; i < added.values.size(); ++i) {
      added.values[i] = static_cast<float>(i * 2654435761u % 1000003u);
    }
  }
  return grid;
}

std::vector<Writer> writers() {
  std::vector<std::uint8_t> rgb(64 * 48 * 3);
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    rgb[i] = static_cast<std::uint8_t>((i * i + 12345) * 2654435761u >> 24);
  }
  return {
      {"a.txt", [](const fs::path& file) { write_atomically(file, std::string(50'000, 'x')); }},
      {"a.exr", [](const fs::path& file) { write_exr(file, incompressible_image()); }},
      {"a.png",
       [rgb](const fs::path& file) {
         write_png(file, 64, 48, rgb, {{"a", "b"}});
       }},
      {"a.vdb", [](const fs::path& file) { write_volume(file, some_grid(), false); }},
      {"half.vdb", [](const fs::path& file) { write_volume(file, some_grid(), true); }},
      {"a.ply", [](const fs::path& file) { write_gaussians(file, some_gaussians()); }},
      {"splats.ply", [](const fs::path& file) { write_splats(file, some_gaussians()); }},
      {"a.csv", [](const fs::path& file) { write_gaussians(file, some_gaussians()); }},
      {"a.glb", [](const fs::path& file) { write_splats(file, some_gaussians()); }},
      {"a.gltf", [](const fs::path& file) { write_splats(file, some_gaussians()); }},
      {"a.brume", [](const fs::path& file) { save_document(some_scene(), file); }},
  };
}

class FullDisk : public FolderTest {
 protected:
  FullDisk() : old_(std::signal(SIGXFSZ, SIG_IGN)) {}
  ~FullDisk() override { std::signal(SIGXFSZ, old_); }

 private:
  void (*old_)(int);
};

// Wherever in the file the disk becomes full: at its first bytes, in the middle, or at what is
// written last, when a library closes it.
TEST_F(FullDisk, EveryWriterSaysSoAndKeepsTheOldFile) {
  for (const Writer& writer : writers()) {
    SCOPED_TRACE(writer.name);
    const fs::path file = folder_ / writer.name;
    writer.write(file);
    const auto size = fs::file_size(file);
    ASSERT_GT(size, 8192u) << "not more than a buffer";
    const fs::path old = folder_.write(writer.name, "old");
    const std::size_t entries = folder_.entry_count();
    for (const auto limit :
         {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 4096, size - 1}) {
      SCOPED_TRACE(limit);
      std::string error;
      {
        const FileSizeLimit full(limit);
        error = error_of([&] { writer.write(file); });
      }
      EXPECT_TRUE(contains(error, file.string() + ": cannot be written: File too large"));
      EXPECT_EQ(content_of(old), "old");
      EXPECT_EQ(folder_.entry_count(), entries);
    }
  }
}

TEST_F(FullDisk, GatherLeavesNothing) {
  const Scene scene = some_scene();
  expect_error(
      [&] {
        const FileSizeLimit full(1000);
        gather_scene(scene, folder_ / "all", "scene");
      },
      (folder_ / "all").string() + ": cannot be created");
  EXPECT_EQ(folder_.entry_count(), 0u);
}

// Like libraries that cannot report errors.
TEST_F(FullDisk, SwallowedExceptionsAreReported) {
  const fs::path file = folder_.write("a.txt", "old");
  std::string error;
  {
    const FileSizeLimit full(1000);
    error = error_of([&] {
      write_atomically(file, [](std::ostream& out) {
        try {
          out << std::string(100'000, 'x');
        } catch (const std::ios_base::failure&) {
        }
      });
    });
  }
  EXPECT_TRUE(contains(error, "cannot be written"));
  EXPECT_EQ(content_of(file), "old");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

}  // namespace
}  // namespace brume
