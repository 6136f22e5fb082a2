#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "render/cpu/film_airlight.h"
#include "render/samples/contrast.h"
#include "render/scattering/environment_light.h"
#include "render/shading/film_surfaces.h"

namespace brume {

// Airlight and transmittance that pixels of a frame are known to have as far as some distance.
struct KnownFog {
  std::span<const float> airlight, transmittance;  // RGB per pixel
  std::span<const float> depth;                    // what ends it, +inf where nothing does
  RayEnds ends;
};

// The view of a pixel's samples.
struct SampledView {
  const FilmTiles& tiles;  // their ends are those of what is seen last
  std::span<const KnownFog> fogs;
  const FilmSurfaces* surfaces = nullptr;  // null: none
  // Highlights of what the frame's pixels see first and, or null, last; with surfaces.
  std::array<const SharedHighlights*, 2> highlights{};
  bool are_lit = false;                           // else they are black
  const EnvironmentLight* environment = nullptr;  // null: none
  // Null: no medium.
  const MediumIndex* medium = nullptr;
  const AirlightIntegrator* method = nullptr;
  double fog_tolerance = 0.01;  // see Settings::upsampling_tolerance
  double picture_rms = 0.0;     // see Brightness
};

struct SampledPixel {
  std::size_t pixel = 0;
  glm::vec3 beauty{0.0f}, airlight{0.0f}, background{0.0f};
  float alpha = 0.0f, transmittance = 0.0f;
  float depth = 0.0f;     // of its last sample
  float variance = 0.0f;  // of beauty, as estimated
};

// View rays pass so many panes at most; the next one is opaque.
inline constexpr std::size_t max_seen_panes = 16;

// Samples the pixels of one tile after another. With the hits k on a sample's ray, panes and what
// lets nothing through, airlight A_k and transmittance T_k as far as each, its radiance S_k, of
// which it covers c_k, and the share P_k of light that passes those before it,
//   sum_k (P_k - P_k+1) A_k + P_k c_k T_k S_k
// is what the sample sees.
class TileSampler {
 public:
  // Keeps references. `offsets`: of the samples of a pixel from its center [pixels].
  TileSampler(const SampledView& view, std::span<const PixelDetail> details,
              std::span<const glm::dvec2> offsets, const Job& job, Frame& frame);

  // Appends the pixels of a tile that have details.
  void sample(std::size_t tile, std::vector<SampledPixel>& results);

  // Gaussian x ray pairs evaluated.
  [[nodiscard]] std::uint64_t view_pairs() const { return view_pairs_; }
  [[nodiscard]] std::uint64_t light_pairs() const { return light_pairs_; }

 private:
  // A hit that a sample sees, or what is behind all.
  struct Part {
    std::size_t sample = 0;  // of the batch
    SurfaceHit hit{};        // none: the sample is open
    float airlight = 1.0f;   // share of the airlight as far as there
    float reaching = 1.0f;   // share of its light that reaches the eye but for the medium
    float counted = 1.0f;    // share of the transmittance that is the sample's
    bool is_opaque = true;   // more than half
    std::size_t panes = 0;   // before it
    glm::vec3 behind{0.0f};  // radiance
    std::size_t cluster = 0;
  };
  // Parts of a pixel about as far away, which see through the same fog.
  struct Cluster {
    std::size_t pixel = 0;     // of the batch
    glm::dvec2 position{0.0};  // mean, on the whole film
    double length = 0.0;       // the same
    std::size_t parts = 0;
    bool is_open = false;
    glm::vec3 airlight{0.0f};
    float transmittance = 1.0f;
  };

  [[nodiscard]] std::size_t index(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(frame_.film.width) +
           static_cast<std::size_t>(pixel.x);
  }
  // A pixel's center on the whole film.
  [[nodiscard]] glm::dvec2 center(const glm::ivec2& pixel) const {
    return glm::dvec2(view_.tiles.rays.first_pixel() + pixel) + 0.5;
  }
  [[nodiscard]] std::size_t pixel_of(const Part& part) const {
    return part.sample / offsets_.size();
  }
  [[nodiscard]] glm::dvec2 position(std::size_t sample) const {
    return center(pixels_[sample / offsets_.size()]) + offsets_[sample % offsets_.size()];
  }

  void finish_batch(std::vector<SampledPixel>& results);
  void find_parts();
  // The parts of a sample that sees a pane first.
  void add_panes(std::size_t sample, const SurfaceHit& first);
  void find_background();
  void shade_parts();
  // Parts on one surface.
  void shade(std::vector<std::size_t>& parts);
  // Whether a distance goes on from those of a cluster: as a surface does, so little that the fog
  // of their mean is the mean of their fog.
  [[nodiscard]] bool continues(double nearest, double last, double distance) const;
  // Parts are in order of their pixels.
  void make_clusters();
  void make_clusters(std::size_t pixel, std::span<std::size_t> parts);
  // Airlight and transmittance of all clusters.
  void find_fog();
  // The fog that is known at the pixel nearest to a cluster, among those around `middle`, about as
  // far away.
  struct Known {
    const KnownFog* fog;
    std::size_t pixel;
  };
  [[nodiscard]] std::optional<Known> known_fog(const glm::ivec2& middle, const Cluster& c) const;
  void evaluate_fog();
  void add_up(std::vector<SampledPixel>& results) const;

  const SampledView& view_;
  std::span<const PixelDetail> details_;
  std::span<const glm::dvec2> offsets_;
  const Job& job_;
  Frame& frame_;
  std::size_t tile_ = 0;
  float tolerance_ = 0.0f;  // of distances through the same fog [u]
  std::uint64_t view_pairs_ = 0, light_pairs_ = 0;
  // The batch: pixels, and so many samples of each.
  std::vector<glm::ivec2> pixels_;
  std::vector<glm::dvec3> directions_;
  std::vector<glm::dvec3> ray_offsets_;  // of parallel rays
  std::vector<SurfaceHit> hits_;         // the first of each sample
  std::vector<Part> parts_;
  std::vector<std::vector<std::size_t>> waiting_;  // parts to shade, per surface
  std::vector<std::size_t> order_;
  std::vector<Cluster> clusters_;
  std::vector<std::size_t> exact_;  // clusters whose fog is evaluated
};

}  // namespace brume
