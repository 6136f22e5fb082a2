#pragma once

namespace brume {

// What frames in motion may take from frames before them: they then depend on those. A frame at
// rest is made without any of it.
struct Motion {
  // The medium is kept at the precision of frames in motion beside that of those at rest, and
  // merged Gaussians follow edits.
  bool has_own_medium = false;
  // What the medium scatters, of a grid that was made with other tables and at another merge_error,
  // is used again: after a frame at rest.
  bool any_source_precision = false;
  // Light that is scattered more than once is solved for from the last solution on.
  bool warm_start = false;

  bool operator==(const Motion&) const = default;
};

}  // namespace brume
