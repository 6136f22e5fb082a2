#pragma once

namespace brume {

// Commands of one gesture (a drag, a scrub) carry one merge id and become one step; ids are never
// used twice, so that the next drag is a step of its own.
using MergeId = int;
inline constexpr MergeId no_merge = -1;
MergeId new_merge_id();

}  // namespace brume
