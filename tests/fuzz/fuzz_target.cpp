// One parser under libFuzzer. Which one BRUME_FUZZ_PARSER says: a name of `parsers` below.

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/io/gaussian_csv.h"
#include "core/io/gaussian_ply.h"
#include "core/io/hdr_file.h"
#include "core/io/image_file.h"
#include "core/io/merl_file.h"
#include "core/io/mesh_file.h"
#include "core/io/scene_file.h"
#include "core/io/volume_file.h"

namespace brume {
namespace {

using Path = std::filesystem::path;

struct Parser {
  std::string_view name;
  std::string_view extension;
  void (*parse)(const Path& file);
};

constexpr Parser parsers[] = {
    {"scene", ".brume", [](const Path& file) { load_scene(file); }},
    {"gaussian_ply", ".ply", [](const Path& file) { read_gaussians_ply(file); }},
    {"gaussian_csv", ".csv", [](const Path& file) { read_gaussians_csv(file); }},
    {"mesh_ply", ".ply", [](const Path& file) { read_mesh(file); }},
    {"obj", ".obj", [](const Path& file) { read_mesh(file); }},
    {"off", ".off", [](const Path& file) { read_mesh(file); }},
    {"stl", ".stl", [](const Path& file) { read_mesh(file); }},
    {"exr", ".exr", [](const Path& file) { read_exr(file); }},
    {"hdr", ".hdr", [](const Path& file) { read_hdr(file); }},
    {"merl", ".binary", [](const Path& file) { read_merl(file); }},
    {"vdb", ".vdb",
     [](const Path& file) {
       volume_grids(file);
       read_velocity(file);
       read_volume(file, "density");
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

// An InputError is what a bad file gets; whatever else leaves a parser ends the fuzzer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file = brume::input_file();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    brume::parser().parse(file);
  } catch (const brume::InputError&) {
  }
  std::filesystem::remove(file);
  return 0;
}
