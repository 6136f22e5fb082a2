#include "render/splats/lit_splat_file.h"

#include <zlib.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "brume/camera.h"
#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/disk/installed_files.h"
#include "core/io/gaussians/splat_ply.h"
#include "core/io/import/uri.h"
#include "render/display/to_display.h"
#include "render/render_plan.h"
#include "render/splats/baked_splats.h"
#include "render/transfer/transfer_cache.h"

namespace brume {
namespace {

using OrderedJson = nlohmann::ordered_json;

// The page without content.
std::string viewer() {
  const std::filesystem::path file = resources_folder() / "web" / "viewer.html.gz";
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> packed(gzopen(file.c_str(), "rb"), gzclose);
  if (!packed) throw InputError(file, "", "the viewer of the web page is not installed");
  std::string page;
  std::array<char, 1 << 16> part;
  int count = 0;
  while ((count = gzread(packed.get(), part.data(), part.size())) > 0) {
    page.append(part.data(), static_cast<std::size_t>(count));
  }
  if (count < 0) throw InputError(file, "", "is damaged");
  return page;
}

// Replaces what stands between two marks.
void replace_between(std::string& page, std::string_view begin, std::string_view end,
                     const std::string& text) {
  const std::size_t mark = page.find(begin);
  const std::size_t first = mark + begin.size();
  const std::size_t last = mark == std::string::npos ? mark : page.find(end, first);
  if (last == std::string::npos) throw std::runtime_error("the viewer has no place for a scene");
  page.replace(first, last - first, text);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<' || c == '&') {
      result += c == '<' ? "&lt;" : "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

OrderedJson three_of(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

// Half the height at distance 1. The viewer has no parallel rays: it shows as much at the target.
double slope_of(const Camera& camera) {
  return camera.height ? 0.5 * *camera.height / glm::distance(camera.eye, camera.target)
                       : std::tan(0.5 * glm::radians(camera.vertical_fov));
}

// The viewer adds no effects to what was baked.
OrderedJson viewer_settings(const Camera& camera, const Film& film) {
  // Its angle of view is that of the longer side.
  const double aspect = std::max(1.0, static_cast<double>(film.width) / film.height);
  const double half = slope_of(camera) * aspect;
  const double angle = glm::degrees(2.0 * std::atan(half));
  const auto off = [](OrderedJson effect) {
    effect["enabled"] = false;
    return effect;
  };
  return {
      {"version", 2},
      {"tonemapping", "none"},
      {"highPrecisionRendering", true},
      {"background", {{"color", {0, 0, 0}}}},
      {"postEffectSettings",
       {{"sharpness", off({{"amount", 0}})},
        {"bloom", off({{"intensity", 1}, {"blurLevel", 2}})},
        {"grading",
         off({{"brightness", 1}, {"contrast", 1}, {"saturation", 1}, {"tint", {1, 1, 1}}})},
        {"vignette", off({{"intensity", 0.5}, {"inner", 0.3}, {"outer", 0.75}, {"curvature", 1}})},
        {"fringing", off({{"intensity", 0.5}})}}},
      {"animTracks", OrderedJson::array()},
      {"cameras",
       {{{"initial",
          {{"position", three_of(camera.eye)},
           {"target", three_of(camera.target)},
           {"fov", angle}}}}}},
      {"annotations", OrderedJson::array()},
      {"startMode", "default"}};
}

// One page that shows splats in a browser, without a server or a network: the viewer of
// resources/web with them inside. `ply`: of splats whose y points down; the camera is where it
// begins. Throws InputError if the viewer is not installed.
std::string splat_page(const std::string& title, const std::string& ply, const Camera& camera,
                       const Film& film) {
  const OrderedJson content{{"settings", viewer_settings(camera, film)},
                            {"contentUrl", encoded_data_uri(ply)},
                            {"contentFilename", "fog.ply"}};
  std::string page = viewer();
  replace_between(page, "<title>", "</title>", escaped(title));
  replace_between(page, "id=\"sse-bootstrap\">", "</script>", content.dump());
  return page;
}

std::optional<std::vector<SplatColor>> baked(const Scene& scene, double exposure, const Job& job,
                                             std::vector<std::string>* warnings) {
  Settings settings = sliced_settings({}, 24);
  settings.scattering = Scattering::multiple;
  TransferStore transfers;
  const std::vector<TransferRequest> needed = needed_transfers(scene, settings);
  const double first = needed.empty() ? 0.0 : 0.5;  // of the progress
  if (!transfers.make(needed, cache_folder(), job.subrange(0.0, first), warnings)) return {};
  const auto show = [exposure](const glm::vec3& radiance) {
    return to_display(radiance, exposure);
  };
  return bake_splats(scene, settings, show, transfers, job.subrange(first, 1.0));
}

}  // namespace

std::optional<std::string> lit_splat_file(const Scene& scene, const LitSplatOptions& options,
                                          const std::filesystem::path& file, const Job& job,
                                          std::vector<std::string>* warnings) {
  auto colors = baked(scene, options.exposure, job, warnings);
  if (!colors) return std::nullopt;
  std::vector<Gaussian> gaussians = scene.medium.gaussians();
  if (options.only) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < gaussians.size(); ++i) {
      if (!std::ranges::binary_search(*options.only, scene.medium.ids()[i])) continue;
      gaussians[count] = gaussians[i];
      (*colors)[count++] = (*colors)[i];
    }
    gaussians.resize(count);
    colors->resize(count);
  }
  const bool is_page = lower_case_extension(file) == ".html";
  std::string ply = splats_ply(
      gaussians, {options.along, scene.optics.albedo, *colors, options.y_down || is_page});
  if (!is_page) return ply;
  return splat_page(file.stem().string(), ply, scene.camera, scene.film);
}

}  // namespace brume
