// One parser under libFuzzer. Which one BRUME_FUZZ_PARSER says: a name of `parsers` below.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "brume/error.h"
#include "brume/medium.h"
#include "brume/scene.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_csv.h"
#include "core/io/gaussians/gaussian_ply.h"
#include "core/io/gaussians/splat_gltf.h"
#include "core/io/ies_file.h"
#include "core/io/image/hdr_file.h"
#include "core/io/image/image_file.h"
#include "core/io/image/pixel_decoders.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/image/texture_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/import/raw_scene_bytes.h"
#include "core/io/merl_file.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/scene/scene_file.h"
#include "core/io/volume/volume_optics.h"

namespace brume {
namespace {

using Path = std::filesystem::path;

struct Parser {
  std::string_view name;
  std::string_view extension;
  void (*parse)(const Path& file);
  // A single allocation larger than this fails.
  std::size_t max_memory = std::numeric_limits<std::size_t>::max();
};

// Rows without columns and nodes that share a mesh are many Gaussians in a few bytes.
constexpr std::size_t max_fuzzed = 100'000;

// Gaussians that were read are in their domains, or else the reader is wrong.
void check_gaussians(const std::vector<Gaussian>& gaussians) {
  Medium medium;
  for (const Gaussian& gaussian : gaussians) medium.append(gaussian);
  check(medium);
}

constexpr Parser parsers[] = {
    {"scene", ".brume", [](const Path& file) { load_scene(file); }},
    {"gaussian_ply", ".ply", [](const Path& file) { read_gaussians_ply(file); }},
    {"splat_ply", ".ply",
     [](const Path& file) {
       for (const auto along : {OpacityAlong::shortest, OpacityAlong::longest}) {
         check_gaussians(read_gaussians_ply(file, nullptr, max_fuzzed, nullptr, {along, true}));
       }
     }},
    {"splat_gltf", ".glb",
     [](const Path& file) {
       has_splats_gltf(file);
       splat_count_gltf(file);
       check_gaussians(read_splats_gltf(file, max_fuzzed, {OpacityAlong::mean, true}));
     }},
    {"gaussian_csv", ".csv", [](const Path& file) { read_gaussians_csv(file); }},
    {"mesh_ply", ".ply", [](const Path& file) { read_mesh(file); }},
    {"obj", ".obj", [](const Path& file) { read_mesh(file); }},
    {"off", ".off", [](const Path& file) { read_mesh(file); }},
    {"stl", ".stl", [](const Path& file) { read_mesh(file); }},
    // A few bytes can be a large image of one colour: the fuzzer would do little but fill it.
    {"exr", ".exr",
     [](const Path& file) {
       read_radiance_map(file);
       read_exr(file);
     },
     1 << 24},
    {"hdr", ".hdr", [](const Path& file) { read_hdr(file); }},
    {"png", ".png", [](const Path& file) { read_texture(file, false); }, 1 << 24},
    {"jpeg", ".jpg", [](const Path& file) { read_texture(file, false); }, 1 << 24},
    {"tga", ".tga", [](const Path& file) { decode_tga(file, read_bytes(file)); }, 1 << 24},
    {"bmp", ".bmp", [](const Path& file) { decode_bmp(file, read_bytes(file)); }, 1 << 24},
    {"ies", ".ies", [](const Path& file) { read_ies(file); }},
    {"gltf", ".glb",
     [](const Path& file) {
       std::vector<std::string> warnings;
       read_imported_scene(file, warnings);
     }},
    {"raw_scene", ".bytes", [](const Path& file) { read_raw_scene(file, read_bytes(file)); }},
    {"merl", ".binary", [](const Path& file) { read_merl(file); }},
    {"vdb", ".vdb",
     [](const Path& file) {
       volume_grids(file);
       read_velocity(file);
       read_volume(file, "density");
       read_volume_optics(file, {.temperature = "density", .flame = "density"}, 1.0, 1000);
     }},
};

const Parser& parser() {
  for (const Parser& p : parsers) {
    if (p.name == BRUME_FUZZ_PARSER) return p;
  }
  throw std::logic_error("no parser " BRUME_FUZZ_PARSER);
}

// The input as a file: that is what parsers read. In memory where the system has such a folder.
Path input_file() {
  const Path memory = "/dev/shm";
  const Path folder =
      std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("brume-fuzz-" + std::to_string(::getpid()) + std::string(parser().extension));
}

}  // namespace
}  // namespace brume

// Libraries may use their own `new` and our `delete`.
extern "C" const char* __asan_default_options() {
  return "alloc_dealloc_mismatch=0";
}

static std::size_t max_memory = std::numeric_limits<std::size_t>::max();

void* operator new(std::size_t size) {
  void* memory = size > max_memory ? nullptr : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new[](std::size_t size) {
  return operator new(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

// An InputError is what a bad file gets; whatever else leaves a parser ends the fuzzer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file = brume::input_file();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  max_memory = brume::parser().max_memory;
  try {
    brume::parser().parse(file);
  } catch (const brume::InputError&) {
  }
  max_memory = std::numeric_limits<std::size_t>::max();
  std::filesystem::remove(file);
  return 0;
}
