#pragma once

namespace brume {

// Permissions of frames in motion to reuse data of earlier frames, on which they then depend. A
// frame at rest is made without any of it.
struct Motion {
  // The medium is kept at the precision of frames in motion beside that of those at rest, and
  // merged Gaussians follow edits.
  bool has_own_medium = false;
  // The scattered light of a grid that was made with other tables and at another merge_error
  // is used again: after a frame at rest.
  bool any_source_precision = false;
  // Light that is scattered more than once is solved for from the last solution on.
  bool warm_start = false;

  bool operator==(const Motion&) const = default;
};

}  // namespace brume
