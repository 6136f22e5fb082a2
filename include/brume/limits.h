#pragma once

#include <cstddef>
#include <cstdint>

// Limits of files, far beyond any real scene: they keep hostile files from exhausting memory, and
// every product in the renderer finite.
namespace brume::limits {

inline constexpr std::uintmax_t file_bytes = std::uintmax_t{1} << 30;  // scenes, meshes, Gaussians
inline constexpr std::size_t scene_bytes = std::size_t{8} << 30;       // of all that a scene loads
inline constexpr std::size_t gaussians = 10'000'000;  // of a scene with its emitters and sequences
inline constexpr std::uint32_t volume_grids = 1024;
inline constexpr std::size_t volume_blocks = 2'000'000;  // of 8 x 8 x 8 voxels: 4 GB
inline constexpr std::size_t lights = 1024;
inline constexpr int profile_angles = 1024;  // of each kind, in a photometric profile
inline constexpr std::size_t cameras = 1024;
inline constexpr std::size_t name_length = 256;  // of an object [bytes]
inline constexpr int paths = 1'000'000;          // traced per pixel
inline constexpr int samples = 4096;             // per pixel
inline constexpr std::size_t groups = 1024;
inline constexpr std::size_t splines = 1024;
inline constexpr std::size_t spline_points = 1024;  // of one spline
inline constexpr std::size_t emitters = 1024;
inline constexpr std::size_t sequences = 1024;
inline constexpr int frame = 1'000'000;  // of what is played
inline constexpr int sequence_frames = 100'000;
inline constexpr std::size_t surfaces = 4096;
inline constexpr std::size_t copy_bytes = 1024;  // that a copy of a surface counts, of scene_bytes
inline constexpr std::size_t copies = scene_bytes / copy_bytes;  // of all surfaces
inline constexpr int film_side = 16384;                          // pixels
inline constexpr int image_side = 32768;                         // pixels
inline constexpr int texture_side = 16384;                       // texels
inline constexpr int json_depth = 64;                            // nested arrays and objects
inline constexpr std::size_t keys = 1024;                        // of one JSON object
// Memory limit of parsed JSON: a base, plus a multiple of the text's length. Gaussians without
// decimals need 7.
inline constexpr std::size_t json_bytes = std::size_t{64} << 20;
inline constexpr std::size_t json_bytes_per_byte = 8;
inline constexpr std::size_t keys_of_value = 100'000;  // of an animation

inline constexpr double coordinate = 1e12;   // |x| [u]
inline constexpr double min_length = 1e-12;  // of radii and scales [u]
inline constexpr double max_length = 1e12;
inline constexpr double min_stretch = 1e-4;  // of radii of an ellipsoid, to the greatest
inline constexpr double density = 1e12;      // [1/u]
inline constexpr double intensity = 1e20;    // [W/sr]
inline constexpr double slope = 1e30;        // of a value with keyframes [1/s]

}  // namespace brume::limits
