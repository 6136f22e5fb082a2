#pragma once

#include <QIcon>

namespace brume {

// An icon of resources/icons; currentColor becomes the theme's button text colour, or the accent
// colour if checked.
QIcon load_icon(const QString& name);

}  // namespace brume
