#include "core/io/scene/usd_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "core/io/disk/atomic_file.h"
#include "core/io/gaussians/splat_output.h"
#include "core/io/scene/usd_surface.h"
#include "core/io/scene/usd_text.h"
#include "core/math/max_component.h"
#include "core/medium/splat.h"
#include "core/scene/camera_rays.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/environment.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {
namespace {

using Frames = std::span<const UsdFrame>;

// A frame with -z towards `forward` and y as far towards `up` as that allows, as cameras and lights
// of USD have them.
glm::dmat4 looking(const glm::dvec3& position, const glm::dvec3& forward, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(forward);
  glm::dvec3 right = glm::cross(up, back);
  if (glm::length(right) < 1e-9 * glm::length(up)) {  // up and forward are one line
    right = glm::cross(
        std::abs(back.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0), back);
  }
  right = glm::normalize(right);
  const glm::dvec3 top = glm::cross(back, right);
  return {glm::dvec4(right, 0.0), glm::dvec4(top, 0.0), glm::dvec4(back, 0.0),
          glm::dvec4(position, 1.0)};
}

void write_camera(UsdText& out, Frames frames) {
  out.open("Camera", frames.front().scene.camera_name);
  const auto camera = [&](std::size_t k) -> const Camera& { return frames[k].scene.camera; };
  out.transform([&](std::size_t k) {
    const CameraRays rays(camera(k), frames[k].scene.film);
    return looking(rays.eye(), rays.forward(), rays.up());
  });
  // Lengths are tenths of a unit; only their ratios count for a pinhole. A film of 24 mm.
  constexpr double height = 24.0;
  const Film& film = frames.front().scene.film;
  const double aspect = static_cast<double>(film.width) / film.height;
  if (camera(0).height) {
    constexpr double tenths = 10.0;
    const auto seen = [&](std::size_t k) { return tenths * *camera(k).height; };
    out.constant("token projection", "\"orthographic\"");
    out.each_frame("float verticalAperture", seen);
    out.each_frame("float horizontalAperture", [&](std::size_t k) { return aspect * seen(k); });
    out.close();
    return;
  }
  const double width = height * film.width / film.height;
  out.constant("float verticalAperture", usd_value(height));
  out.constant("float horizontalAperture", usd_value(width));
  out.each_frame("float focalLength", [&](std::size_t k) {
    return 0.5 * height / std::tan(0.5 * glm::radians(camera(k).vertical_fov));
  });
  out.close();
}

// A schema of USD, and what a light without a name is called, for each kind.
struct LightNames {
  const char* type;
  const char* name;
};
constexpr std::array light_names{
    LightNames{"SphereLight", "Point light"}, LightNames{"SphereLight", "Spot light"},
    LightNames{"DistantLight", "Sun"},        LightNames{"RectLight", "Area light"},
    LightNames{"DiskLight", "Area light"},    LightNames{"SphereLight", "Area light"}};
static_assert(light_names.size() == light_kinds.size());

glm::dmat4 place_of(const Light& light) {
  const glm::dvec3 y(0.0, 1.0, 0.0);
  const bool is_far = light.as<light::Directional>() != nullptr;
  const glm::dvec3 position = is_far ? glm::dvec3(0.0) : light.position;
  const auto* rectangle = light.as<light::Rectangle>();
  if (const auto* direction = find_value<glm::dvec3>(light, "direction")) {
    return looking(position, *direction, rectangle ? rectangle->up : y);
  }
  if (profile_of(light) || light.as<light::Sphere>()) return looking(position, -y, y);
  return glm::translate(glm::dmat4(1.0), position);
}

// Writes what lights of each type have besides colour, intensity and place.
void write_shape(UsdText& out, Frames frames, std::size_t i, const std::filesystem::path& folder) {
  const auto light = [&](std::size_t k) -> const Light& { return frames[k].scene.lights[i]; };
  const Light& first = light(0);
  const auto write = [&](const char* declaration, const char* name) {
    if (find_value<double>(first, name) == nullptr) return;
    out.each_frame(declaration, [&](std::size_t k) { return *find_value<double>(light(k), name); });
  };
  write("float inputs:angle", "angular_diameter");
  write("float inputs:width", "width");
  write("float inputs:height", "height");
  write("float inputs:radius", "radius");
  write("float inputs:shaping:cone:angle", "outer_angle");
  if (first.as<light::Point>() || first.as<light::Spot>()) {
    constexpr double radius = 0.001;  // with normalize, what it shines does not depend on it
    out.constant("float inputs:radius", usd_value(radius));
    out.constant("bool treatAsPoint", usd_value(true));
  }
  if (first.as<light::Spot>()) {
    out.each_frame("float inputs:shaping:cone:softness", [&](std::size_t k) {
      const auto& spot = std::get<light::Spot>(light(k).kind);
      return spot.outer_angle > 0.0 ? 1.0 - spot.inner_angle / spot.outer_angle : 0.0;
    });
  }
  if (const LightProfile* profile = profile_of(first)) {
    out.constant("asset inputs:shaping:ies:file", named_from(folder, profile->file));
    out.constant("bool inputs:shaping:ies:normalize", usd_value(true));
  }
  if (const LightTexture* texture = texture_of(first)) {
    out.constant("custom asset brume:texture:file", named_from(folder, texture->file));
  }
  const auto area = area_of(first);
  if (area && is_two_sided(*area)) out.constant("custom bool brume:twoSided", usd_value(true));
  if (area && is_visible(*area)) out.constant("custom bool brume:visible", usd_value(true));
}

// Intensity, per type: area lights radiance; distant lights, normalized, irradiance; normalized
// spheres 4 times radiant intensity, for intensity / (4 pi r^2) is then radiance, and pi r^2 times
// that radiant intensity.
void write_light(UsdText& out, Frames frames, std::size_t i, const std::filesystem::path& folder) {
  const auto light = [&](std::size_t k) -> const Light& { return frames[k].scene.lights[i]; };
  const Light& first = light(0);
  const bool has_shaping = first.as<light::Spot>() || profile_of(first);
  const bool is_area = area_of(first).has_value();
  const LightNames& names = light_names[first.kind.index()];
  out.open(names.type, first.name.empty() ? names.name : first.name,
           has_shaping ? "\"ShapingAPI\"" : "");
  out.transform([&](std::size_t k) { return place_of(light(k)); });
  const double factor = first.as<light::Directional>() || is_area ? 1.0 : 4.0;
  out.each_frame("float inputs:intensity", [&](std::size_t k) {
    return light(k).on ? factor * max_component(light(k).intensity) : 0.0;
  });
  out.each_frame("color3f inputs:color", [&](std::size_t k) {
    const double max = max_component(light(k).intensity);
    return max > 0.0 ? light(k).intensity / max : glm::dvec3(1.0);
  });
  out.constant("bool inputs:normalize", usd_value(!is_area));
  write_shape(out, frames, i, folder);
  out.close();
}

glm::dvec3 mean_radiance(const RadianceMap& map) {
  // The first harmonic and the integral's share of it are 1 / sqrt(4 pi).
  return 0.5 * std::numbers::inv_sqrtpi * map_sh(map, 1)[0];
}

// USD's maps have +z in the middle, Brume's -z.
void write_environment(UsdText& out, Frames frames, const std::filesystem::path& folder) {
  if (!frames.front().scene.environment) return;
  const auto environment = [&](std::size_t k) -> const Environment& {
    return *frames[k].scene.environment;
  };
  out.open("DomeLight", "Environment");
  out.transform([&](std::size_t k) {
    const glm::dmat4 half_turn =
        glm::rotate(glm::dmat4(1.0), glm::radians(180.0), glm::dvec3(0.0, 1.0, 0.0));
    return glm::mat4_cast(environment_rotation(environment(k))) * half_turn;
  });
  if (environment(0).file.empty()) {
    // A computed sky has no file that could be named: its light is the same from all directions.
    out.each_frame("color3f inputs:color",
                   [&](std::size_t k) { return mean_radiance(*environment(k).map); });
  } else {
    out.constant("asset inputs:texture:file", named_from(folder, environment(0).file));
    out.constant("token inputs:texture:format", "\"latlong\"");
  }
  out.each_frame("float inputs:intensity", [&](std::size_t k) { return environment(k).intensity; });
  out.close();
}

bool have_splats(Frames frames) {
  return std::ranges::any_of(frames, [](const UsdFrame& frame) { return !frame.splats.empty(); });
}

// The fog as UsdVol's particle field of 3D Gaussians: `scales` are standard deviations, `opacities`
// linear, the color is the harmonic of degree 0.
void write_splats_usd(UsdText& out, Frames frames, OpacityAlong along) {
  if (!have_splats(frames)) return;
  const auto each_splat = [&](std::string_view declaration, auto value_of,
                              std::string_view metadata = {}) {
    std::vector<std::string> values;
    for (const UsdFrame& frame : frames) {
      const SplatOutput output{along, frame.scene.optics.albedo};
      values.push_back(usd_list(frame.splats.size(),
                                [&](std::size_t i) { return value_of(frame.splats[i], output); }));
    }
    out.animated(declaration, values, metadata);
  };
  const auto number = [](double value) { return usd_value(static_cast<float>(value)); };
  const auto vector = [&](const glm::dvec3& v) { return usd_value(glm::dvec3(glm::vec3(v))); };
  out.open("ParticleField3DGaussianSplat", "Fog splats");
  out.constant("uniform token purpose", "\"proxy\"");
  each_splat("point3f[] positions",
             [&](const Gaussian& g, const SplatOutput&) { return vector(g.center); });
  each_splat("quatf[] orientations", [&](const Gaussian& g, const SplatOutput&) {
    const glm::quat q(g.shape.rotation);
    return usd_tuple({q.w, q.x, q.y, q.z});
  });
  each_splat("float3[] scales",
             [&](const Gaussian& g, const SplatOutput&) { return vector(splat_of(g).deviations); });
  each_splat("float[] opacities", [&](const Gaussian& g, const SplatOutput& output) {
    return number(opacity_of_depth(depth_along(g, output.along)));
  });
  out.constant("uniform int radiance:sphericalHarmonicsDegree", "0");
  each_splat(
      "float3[] radiance:sphericalHarmonicsCoefficients",
      [&](const Gaussian& g, const SplatOutput& output) { return vector(sh_color(g, output)); },
      "elementSize = 1\ninterpolation = \"vertex\"");
  out.constant("uniform token sortingModeHint", "\"cameraDistance\"");
  out.close();
}

void write_fog(UsdText& out, Frames frames) {
  const auto optics = [&](std::size_t k) -> const MediumOptics& { return frames[k].scene.optics; };
  const std::string path = out.open("Volume", "Fog");
  if (have_splats(frames)) out.constant("uniform token purpose", "\"render\"");
  out.each_frame("custom color3f brume:albedo", [&](std::size_t k) { return optics(k).albedo; });
  out.each_frame("custom double brume:anisotropy",
                 [&](std::size_t k) { return optics(k).anisotropy; });
  out.each_frame("custom double brume:homogeneousDensity",
                 [&](std::size_t k) { return frames[k].scene.medium.homogeneous_density(); });
  const auto any = [&](bool UsdFrame::*has) {
    return std::ranges::any_of(frames, [has](const UsdFrame& frame) { return frame.*has; });
  };
  std::vector<std::string> fields;
  const auto has_volume = [](const UsdFrame& frame) { return !frame.volume.empty(); };
  if (std::ranges::any_of(frames, has_volume)) fields.emplace_back("density");
  if (any(&UsdFrame::has_albedo)) fields.emplace_back("albedo");
  if (any(&UsdFrame::has_emission)) fields.emplace_back("emission");
  for (const std::string& field : fields) {
    out.constant("rel field:" + field, "<" + path + "/" + field + ">");
  }
  std::vector<std::string> files;
  for (const UsdFrame& frame : frames) files.push_back(usd_asset(frame.volume.generic_string()));
  for (const std::string& field : fields) {
    out.open("OpenVDBAsset", field);
    out.constant("token fieldName", usd_string(field));
    out.animated("asset filePath", files);
    out.close();
  }
  out.close();
}

}  // namespace

std::filesystem::path volume_of_stage(const std::filesystem::path& stage,
                                      std::optional<int> frame) {
  std::array<char, 16> number{};
  if (frame) std::snprintf(number.data(), number.size(), "_%04d", *frame);
  std::filesystem::path file = stage;
  return file.replace_filename(stage.stem().string() + "_fog" + number.data() + ".vdb");
}

void replace_medium(UsdFrame& frame, const std::filesystem::path& volume,
                    const VolumeColors& colors) {
  frame.volume = volume.filename();
  frame.has_albedo = colors.albedo.has_value();
  frame.has_emission = colors.emission.has_value();
  const double homogeneous = frame.scene.medium.homogeneous_density();
  frame.scene.medium = {};
  frame.scene.medium.set_homogeneous_density(homogeneous);
}

void write_usd(const std::filesystem::path& file, Frames frames, double frames_per_second,
               OpacityAlong along, const AddOutput& add_output) {
  assert(!frames.empty());
  std::vector<std::optional<int>> codes;
  for (const UsdFrame& frame : frames) codes.push_back(frame.frame);
  UsdText out(codes);
  const Scene& first = frames.front().scene;
  UsdTextures textures(file, add_output);
  const std::filesystem::path& folder = textures.folder();
  out.open("Xform", "World");
  write_camera(out, frames);
  for (std::size_t i = 0; i < first.lights.size(); ++i) write_light(out, frames, i, folder);
  write_environment(out, frames, folder);
  for (std::size_t i = 0; i < first.surfaces.size(); ++i)
    write_usd_surface(out, frames, i, textures);
  write_fog(out, frames);
  write_splats_usd(out, frames, along);
  out.close();
  std::string head = "#usda 1.0\n(\n    defaultPrim = \"World\"\n    doc = \"Made by Brume\"\n";
  head += "    metersPerUnit = 1\n    upAxis = \"Y\"\n";
  if (codes.front()) {
    head += "    startTimeCode = " + std::to_string(*codes.front()) + "\n";
    head += "    endTimeCode = " + std::to_string(codes.back().value()) + "\n";
    head += "    timeCodesPerSecond = " + usd_value(frames_per_second) + "\n";
    head += "    framesPerSecond = " + usd_value(frames_per_second) + "\n";
  }
  write_atomically(file, head + ")\n" + out.text());
}

}  // namespace brume
