#pragma once

namespace brume {

// Commands of one gesture share a merge id and become one undo step; ids are never reused.
using MergeId = int;
inline constexpr MergeId no_merge = -1;
inline MergeId new_merge_id() {
  static MergeId last = no_merge;
  return ++last;
}

}  // namespace brume
