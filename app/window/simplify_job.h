#pragma once

#include <QString>
#include <functional>

#include "app/jobs/background_job.h"

namespace brume {

class Document;

// Background work that simplifies what to_simplify() chooses, within an error. `tell` is called
// with how many Gaussians became how many, and the error. Nothing is merged if the fog is edited
// meanwhile.
BackgroundJob::Work simplifying(Document& document, double max_error,
                                const std::function<void(const QString&)>& tell);

}  // namespace brume
