#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/samples/exposure.h"

namespace brume {

// A picture that is solved for, and two of the same view by paths that are independent of each
// other and of it: rows of RGB pixels.
struct SolvedAndTraced {
  int width = 0;
  std::vector<glm::vec3> solved;
  std::vector<glm::vec3> traced[2];
};

// The difference of the mean of those by paths from the solved picture, as far as it stands out
// from their noise. It is taken relative to the solved light around, and split into details of 1,
// 2, 4 ... 32 pixels and the rest (the a trous algorithm: Holschneider et al. 1989, with the B3
// spline of Starck and Murtagh). Each detail is weighed by its power over that and the noise's
// (Wiener), both taken around the pixel: the power by the product of the two differences, whose
// noise is independent, the noise by their difference. With more paths it converges to all of the
// difference. Invalid after the job was stopped.
std::vector<glm::vec3> significant_difference(const SolvedAndTraced& pictures, const Job& job);

// The airlight of a frame's pixels, and what else is in its beauty.
struct AirlightAndOthers {
  std::vector<glm::vec3> airlight, others;

  AirlightAndOthers() = default;
  AirlightAndOthers(const std::vector<float>& frame_airlight,
                    const std::vector<float>& frame_beauty);
};

// The settings of the solved picture: `sliced`, all orders.
Settings solved_settings(int slices);

// Denoises frames of a view of 1, 2, 4 ... paths, each with the paths of the frame before, and of
// one sample a pixel.
class DenoisedView {
 public:
  // Begins with the solved frame.
  explicit DenoisedView(const Frame& solved) : solved_(solved.airlight, solved.beauty) {}
  // Replaces the light of the next frame; that of the first is the solved one's. Invalid after the
  // job was stopped.
  void denoise(Frame& traced, const Job& job);

 private:
  AirlightAndOthers solved_;
  AirlightAndOthers last_;  // by paths; empty before the first frame
};

// A frame of `path` that begins with the solved picture and keeps of the paths' what is
// significant. Half of the paths make each of the two pictures; where a lens or a shutter blurs,
// they are at least 64. nullopt if stopped.
std::optional<Frame> render_denoised(FrameRenderer& renderer, const ExposedView& view,
                                     const Settings& settings, const Job& job);

}  // namespace brume
