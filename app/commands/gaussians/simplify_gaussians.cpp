#include "app/commands/gaussians/simplify_gaussians.h"

#include <algorithm>
#include <iterator>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"

namespace brume {

std::vector<GaussianId> to_simplify(const Document& document) {
  if (!document.selection().empty()) {
    return {document.selection().begin(), document.selection().end()};
  }
  std::vector<GaussianId> ids;
  std::ranges::copy_if(document.medium().ids(), std::back_inserter(ids),
                       [&](GaussianId id) { return document.is_editable(id); });
  return ids;
}

Medium chosen_gaussians(const Medium& medium, std::span<const GaussianId> ids) {
  Medium chosen;
  chosen.reserve(ids.size());
  for (const GaussianId id : ids) chosen.append(medium.gaussian(*medium.index_of(id)));
  return chosen;
}

SimplifyLimits limits_of(const SimplifyNumbers& numbers) {
  return {.max_error = 0.01 * numbers.max_error, .ellipsoids = numbers.ellipsoids};
}

void apply_simplified(Document& document, std::span<const GaussianId> ids,
                      const Simplified& simplified) {
  std::vector<GaussianId> removed;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!std::ranges::binary_search(simplified.kept, static_cast<std::uint32_t>(i))) {
      removed.push_back(ids[i]);
    }
  }
  replace_gaussians(document, removed, simplified.merged,
                    undo_text("Simplify %1").arg(gaussians_text(ids.size())));
}

}  // namespace brume
