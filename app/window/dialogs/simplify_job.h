#pragma once

#include <QString>
#include <functional>

#include "app/jobs/background_job.h"

namespace brume {

class Document;
struct SimplifyLimits;

// Background work that simplifies what to_simplify() chooses, within limits. `tell` is called
// with how many Gaussians became how many, and the error. Nothing is merged if the fog is edited
// meanwhile.
BackgroundJob::Work simplifying(Document& document, const SimplifyLimits& limits,
                                const std::function<void(const QString&)>& tell);

}  // namespace brume
