#include "app/commands/merge_id.h"

namespace brume {

MergeId new_merge_id() {
  static MergeId last = no_merge;
  return ++last;
}

}  // namespace brume
