#include "app/commands/simplify_gaussians.h"

#include <algorithm>
#include <iterator>

#include "app/commands/medium_command.h"
#include "app/commands/merge_id.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "core/authoring/simplify.h"

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

void apply_simplified(Document& document, std::span<const GaussianId> ids,
                      const Simplified& simplified) {
  std::vector<GaussianId> removed;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!std::ranges::binary_search(simplified.kept, static_cast<std::uint32_t>(i))) {
      removed.push_back(ids[i]);
    }
  }
  MediumEdit edit = MediumEdit::remove(document.medium(), removed);
  edit.merge(MediumEdit::add(document.medium(), simplified.merged));
  document.undo_stack().push(
      new MediumCommand(document, std::move(edit),
                        undo_text("Simplify %1").arg(gaussians_text(ids.size())), no_merge));
}

}  // namespace brume
