#pragma once

#include <QIcon>

namespace brume {

// An icon of resources/icons; currentColor becomes the theme's button text colour, or the accent
// colour if checked.
QIcon load_icon(const QString& name);
// The same, never in the accent colour: trees draw icons of expanded items as if checked.
QIcon load_tree_icon(const QString& name);

}  // namespace brume
