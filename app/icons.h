#pragma once

#include <QIcon>

namespace brume {

// An icon of resources/icons, drawn in `color` wherever the SVG says currentColor.
QIcon load_icon(const QString& name, const QColor& color);

}  // namespace brume
