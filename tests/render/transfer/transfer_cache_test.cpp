#include "render/transfer/transfer_cache.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstring>
#include <limits>
#include <numbers>
#include <span>

#include "core/io/disk/content_hash.h"
#include "core/scene/mesh.h"
#include "tests/contains.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

constexpr TransferSettings cached_settings{.order = 2, .directions = 64, .bounces = 1};

std::shared_ptr<TriangleMesh> small_bowl() {
  MeshArrays mesh;
  add_ball(mesh, 6, {0, 0, 0}, 1.0, 2.0, true);
  return to_mesh(mesh);
}

bool same(const RadianceTransfer& a, const RadianceTransfer& b) {
  if (!(a.settings == b.settings) || a.vertices != b.vertices) return false;
  for (std::size_t s = 0; s < 2; ++s) {
    if (a.sides[s].visibility != b.sides[s].visibility) return false;
    if (a.sides[s].reflected != b.sides[s].reflected) return false;
  }
  return true;
}

// The transfer by way of the folder, and how.
struct Cached {
  RadianceTransfer transfer;
  bool was_read = true;
  std::vector<std::string> warnings;
};

Cached cached(const std::shared_ptr<const TriangleMesh>& mesh, const fs::path& folder,
              const TransferSettings& wanted = cached_settings) {
  Cached result;
  const auto progress = [&](double fraction) { result.was_read &= fraction == 1.0; };
  result.transfer =
      *cached_radiance_transfer(mesh, wanted, folder, {{}, progress}, &result.warnings);
  return result;
}

// The one that is in the folder.
fs::path transfer_file(const TemporaryFolder& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() == ".transfer") return entry.path();
  }
  return {};
}

TEST(TransferCache, RoundTrips) {
  const TemporaryFolder folder;
  const fs::path cache = folder / "to/be/made";
  const RadianceTransfer reference = *radiance_transfer(small_bowl(), cached_settings);
  const Cached first = cached(small_bowl(), cache);
  EXPECT_FALSE(first.was_read);
  const Cached second = cached(small_bowl(), cache);  // another mesh object with the same content
  EXPECT_TRUE(second.was_read);
  EXPECT_TRUE(same(first.transfer, reference));
  EXPECT_TRUE(same(second.transfer, reference));
  EXPECT_TRUE(first.warnings.empty() && second.warnings.empty());

  // A side that is not there.
  MeshArrays ball;
  add_ball(ball, 6, {0, 0, 0}, 1.0, std::numbers::pi, false);
  const RadianceTransfer made = cached(to_mesh(ball), cache).transfer;
  ASSERT_TRUE(made.side(MeshSide::back).visibility.empty());
  const Cached read = cached(to_mesh(ball), cache);
  EXPECT_TRUE(read.was_read && same(read.transfer, made));
}

TEST(TransferCache, DistinguishesMeshesAndSettings) {
  const TemporaryFolder folder;
  const auto is_new = [&](const std::shared_ptr<const TriangleMesh>& mesh,
                          const TransferSettings& settings) {
    return !cached(mesh, folder.path(), settings).was_read;
  };
  const auto mesh = small_bowl();
  EXPECT_TRUE(is_new(mesh, cached_settings));
  EXPECT_TRUE(is_new(mesh, {.order = 3, .directions = 64, .bounces = 1}));
  EXPECT_TRUE(is_new(mesh, {.order = 2, .directions = 72, .bounces = 1}));
  EXPECT_TRUE(is_new(mesh, {.order = 2, .directions = 64, .bounces = 2}));
  MeshArrays moved = to_arrays(*mesh);
  moved.points[7].y += 1e-6f;
  EXPECT_TRUE(is_new(to_mesh(moved), cached_settings));
  MeshArrays bent = to_arrays(*mesh);
  bent.normals[7] = {1, 0, 0};
  EXPECT_TRUE(is_new(to_mesh(bent), cached_settings));
  MeshArrays reordered = to_arrays(*mesh);
  std::swap(reordered.triangles[0], reordered.triangles[1]);
  EXPECT_TRUE(is_new(to_mesh(reordered), cached_settings));
  EXPECT_EQ(folder.entry_count(), 7u);
}

TEST(TransferCache, ReplacesDamagedFiles) {
  const TemporaryFolder folder;
  const auto mesh = small_bowl();
  const RadianceTransfer reference = cached(mesh, folder.path()).transfer;
  const fs::path file = transfer_file(folder);
  const std::string good = content_of(file);

  std::vector<std::string> bad = {"",
                                  "x",
                                  good.substr(0, 47),
                                  good.substr(0, good.size() - 1),
                                  good + "x",
                                  std::string(good.size(), '\0')};
  for (std::size_t i = 0; i < good.size(); i += 1 + good.size() / 97) {
    bad.push_back(good);
    bad.back()[i] = static_cast<char>(bad.back()[i] ^ 0x10);
  }
  for (std::size_t i = 0; i < 48; ++i) {  // the header, byte by byte
    bad.push_back(good);
    bad.back()[i] = static_cast<char>(bad.back()[i] ^ 0xff);
  }
  // A number that is none, in a file that is whole otherwise.
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), 1e30f}) {
    bad.push_back(good);
    std::memcpy(bad.back().data() + 64, &value, sizeof(value));
    ContentHash hash;
    hash.add(std::span<const char>(bad.back().data(), good.size() - 8));
    const std::uint64_t sum = hash.value();
    std::memcpy(bad.back().data() + good.size() - 8, &sum, sizeof(sum));
  }
  for (const std::string& content : bad) {
    folder.write(file.filename().string(), content);
    const Cached got = cached(mesh, folder.path());
    EXPECT_FALSE(got.was_read);
    EXPECT_TRUE(same(got.transfer, reference));
    ASSERT_EQ(got.warnings.size(), 1u);
    EXPECT_TRUE(contains(got.warnings[0], file.string()));
    EXPECT_EQ(content_of(file), good) << "replaced";
  }
  EXPECT_EQ(folder.entry_count(), 1u) << "nothing is left beside it";
}

TEST(TransferCache, ToleratesUnwritableFolders) {
  const TemporaryFolder folder;
  const auto mesh = small_bowl();
  const Cached uncached = cached(mesh, "");
  EXPECT_TRUE(uncached.warnings.empty() && !uncached.was_read);
  const Cached under_a_file = cached(mesh, folder.write("file", "x") / "cache");
  EXPECT_EQ(under_a_file.warnings.size(), 1u);
  EXPECT_TRUE(same(under_a_file.transfer, uncached.transfer));
  // A folder where the file should be.
  cached(mesh, folder.path());
  const fs::path file = transfer_file(folder);
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_TRUE(same(cached(mesh, folder.path()).transfer, uncached.transfer));

  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(
      cached_radiance_transfer(mesh, cached_settings, folder / "new", {source.get_token(), {}}));
  EXPECT_FALSE(fs::exists(folder / "new"));
}

TEST(TransferCache, FollowsTheXdgCacheFolder) {
  // Sets a variable, and back at the end.
  struct Variable {
    Variable(const char* variable, const char* value) : name(variable) {
      if (const char* const now = ::getenv(name)) old = now;
      value ? ::setenv(name, value, 1) : ::unsetenv(name);
    }
    ~Variable() { old ? ::setenv(name, old->c_str(), 1) : ::unsetenv(name); }
    const char* name;
    std::optional<std::string> old;
  };
  const Variable home("HOME", "/home/someone");
  {
    const Variable cache("XDG_CACHE_HOME", "/var/cache/someone");
    EXPECT_EQ(cache_folder(), "/var/cache/someone/brume");
  }
  for (const char* const ignored : {static_cast<const char*>(nullptr), "", "relative"}) {
    const Variable cache("XDG_CACHE_HOME", ignored);
    EXPECT_EQ(cache_folder(), "/home/someone/.cache/brume");
    const Variable no_home("HOME", nullptr);
    EXPECT_EQ(cache_folder(), "");
  }
}

}  // namespace
}  // namespace brume
