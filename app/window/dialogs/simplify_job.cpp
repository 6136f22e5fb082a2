#include "app/window/dialogs/simplify_job.h"

#include <QCoreApplication>
#include <vector>

#include "app/commands/simplify_gaussians.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/number_text.h"
#include "core/authoring/simplify.h"

namespace brume {
namespace {

QString text(const char* source) {
  return QCoreApplication::translate("Simplify", source);
}

}  // namespace

BackgroundJob::Work simplifying(Document& document, const SimplifyLimits& limits,
                                const std::function<void(const QString&)>& tell) {
  const std::vector<GaussianId> ids = to_simplify(document);
  Medium chosen;
  chosen.reserve(ids.size());
  for (const GaussianId id : ids) {
    chosen.append(document.medium().gaussian(*document.medium().index_of(id)));
  }
  const Revision revision = document.medium().revision();
  return [=, &document](const Job& job) -> BackgroundJob::Apply {
    const auto found = simplify(chosen, limits, job.stop, job.progress);
    if (!found) return {};
    return [=, &document, found = *found] {
      if (document.medium().revision() != revision) {
        tell(text("The fog has changed meanwhile; nothing is simplified"));
      } else if (found.merged.empty()) {
        tell(text("No Gaussians can be merged within this error"));
      } else {
        apply_simplified(document, ids, found);
        tell(text("%1 became %2, with an error of %3%")
                 .arg(gaussians_text(ids.size()))
                 .arg(found.kept.size() + found.merged.size())
                 .arg(number_text(100.0 * found.error)));
      }
    };
  };
}

}  // namespace brume
