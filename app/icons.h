#pragma once

#include <QIcon>

namespace brume {

// An icon of resources/icons, drawn wherever the SVG says currentColor in the theme's colour of
// text on buttons, and in the accent colour where it is on.
QIcon load_icon(const QString& name);

}  // namespace brume
