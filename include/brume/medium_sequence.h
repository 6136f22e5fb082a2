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

// The frames of a sequence.
class BRUME_EXPORT SequenceFrames {
 public:
  virtual ~SequenceFrames() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  // At an index in [0, size()). From any thread. Frames that are too many for the memory are read
  // when they are asked for, and those after them ahead; throws InputError if one cannot be.
  [[nodiscard]] virtual std::shared_ptr<const SequenceFrame> frame(std::size_t index) const = 0;
  // Upper bound of the Gaussians of a scene that are this sequence's, at any time.
  [[nodiscard]] virtual std::size_t max_gaussians() const = 0;
  // Whether frame() never reads.
  [[nodiscard]] virtual bool are_in_memory() const = 0;

 protected:
  SequenceFrames() = default;
  SequenceFrames(const SequenceFrames&) = default;
  SequenceFrames& operator=(const SequenceFrames&) = default;
};

// Frames in memory.
BRUME_EXPORT std::shared_ptr<const SequenceFrames> sequence_frames(
    std::vector<SequenceFrame> frames);

// Gaussians from one file per frame, matched by id.
struct MediumSequence {
  std::filesystem::path file{};  // with %04d for the frame
  int first = 0;                 // 0 <= first <= last
  int last = 0;
  double frames_per_second = 30.0;                 // > 0
  double start = 0.0;                              // when the first frame is shown [s]
  std::shared_ptr<const SequenceFrames> frames{};  // never null in a loaded scene
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

// Upper bound of its Gaussians at any time.
BRUME_EXPORT std::size_t gaussian_count(const MediumSequence& sequence);

// Time of the last frame [s].
BRUME_EXPORT double end_of(const MediumSequence& sequence);

}  // namespace brume
