#pragma once

#include <vector>

namespace brume {

// The forward lobe of a phase function widens where light is scattered in it more than once, which
// the bands of a SourceGrid cannot show. Light from a point light that passes the scattering
// optical depth s and is scattered in the lobe only has, in the small-angle approximation (van de
// Hulst, Multiple Light Scattering, 1980, ch. 14), exp(s g^l) - 1 of what was not scattered in band
// l. What counts as not scattered once it has left the lobe has g^l (exp(s f) - 1) / f there
// instead, f = forward_lobe(): too narrow, by 8.6% in a cloud of optical depth 10 and g = 0.85.
//
// The table holds that minus the former: what the phase function loses, times 4 pi; over
//   sqrt((1 - cosine) / 2) = i / (angles - 1) and s / (s + depth_scale) = k / depths.
class LobeBroadening {
 public:
  static constexpr int angles = 128;
  static constexpr int depths = 24;
  static constexpr float depth_scale = 4.0f;

  // Smaller lobes, of g below 0.66, would change less than 1% of a picture.
  static constexpr double min_lobe = 0.2;

  LobeBroadening() = default;  // empty
  // Takes the bands from `first_band` on of Henyey-Greenstein's phase function; empty if its lobe
  // is below min_lobe.
  LobeBroadening(double anisotropy, int first_band);

  [[nodiscard]] bool empty() const { return values_.empty(); }
  // Row by row: `depths` values for each angle.
  [[nodiscard]] const std::vector<float>& values() const { return values_; }

 private:
  std::vector<float> values_;
};

}  // namespace brume
