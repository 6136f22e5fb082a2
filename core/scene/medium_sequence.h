#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// One frame of a sequence; no number twice, ascending, as many as Gaussians.
struct SequenceFrame {
  std::vector<GaussianNumber> ids;
  std::vector<Gaussian> gaussians;

  bool operator==(const SequenceFrame&) const = default;
};

// Gaussians that come from one file per frame. Those of the same number are the same Gaussian.
struct MediumSequence {
  std::filesystem::path file;  // with %04d for the frame
  int first = 0;               // 0 <= first <= last
  int last = 0;
  double frames_per_second = 30.0;                           // > 0
  double start = 0.0;                                        // when the first frame is shown [s]
  std::shared_ptr<const std::vector<SequenceFrame>> frames;  // never null in a loaded scene
  std::string unknown{};                                     // as UnknownKeys of core/scene/scene.h

  bool operator==(const MediumSequence&) const = default;
};

// What lies the share u in [0, 1] of the way from a frame to the next. The centre and the density
// of a Gaussian go linearly, its radius by the same factor in the same time; one that is in only
// one of them fades where it is.
std::vector<Gaussian> between_frames(const SequenceFrame& a, const SequenceFrame& b, double u);

// The Gaussians at a moment [s]; before the first frame and after the last those of that one.
std::vector<Gaussian> sequence_at(const MediumSequence& sequence, double time);

// Of all frames: they all are in memory, and no moment has more.
std::size_t gaussian_count(const MediumSequence& sequence);

// When the last frame is reached [s].
double end_of(const MediumSequence& sequence);

}  // namespace brume
