#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "brume/export.h"
#include "brume/gaussian.h"
#include "brume/object_id.h"

namespace brume {

// One frame of a sequence; ids are unique and ascending, one per Gaussian.
struct SequenceFrame {
  std::vector<GaussianNumber> ids;
  std::vector<Gaussian> gaussians;

  bool operator==(const SequenceFrame&) const = default;
};

// Gaussians from one file per frame, matched by id.
struct MediumSequence {
  std::filesystem::path file;  // with %04d for the frame
  int first = 0;               // 0 <= first <= last
  int last = 0;
  double frames_per_second = 30.0;                           // > 0
  double start = 0.0;                                        // when the first frame is shown [s]
  std::shared_ptr<const std::vector<SequenceFrame>> frames;  // never null in a loaded scene
  ObjectId id = 0;

  bool operator==(const MediumSequence&) const = default;
};

// Interpolates between frames, u in [0, 1]: center, density, albedo and emission linearly, radius
// geometrically; Gaussians present in one frame only fade in place. `medium_albedo`: what one of
// them may have where the other has an albedo of its own.
BRUME_EXPORT std::vector<Gaussian> between_frames(const SequenceFrame& a, const SequenceFrame& b,
                                                  double u, const glm::dvec3& medium_albedo);

// The Gaussians at a time [s], clamped to the first and last frame.
BRUME_EXPORT std::vector<Gaussian> sequence_at(const MediumSequence& sequence, double time,
                                               const glm::dvec3& medium_albedo);

// Sum over all frames, an upper bound at any time.
BRUME_EXPORT std::size_t gaussian_count(const MediumSequence& sequence);

// Time of the last frame [s].
BRUME_EXPORT double end_of(const MediumSequence& sequence);

}  // namespace brume
