#pragma once

#include "app/widgets/interface_settings.h"

class QCoreApplication;

namespace brume {

// Translates the interface: the plurals of English, and another language if it is chosen. Texts are
// looked up without regard to their contexts, so that each is translated once.
void install_translations(QCoreApplication& application, Language language);

}  // namespace brume
