#pragma once

#include <QString>

namespace brume {

// The frames of a film of the editor, as FOLDER/0000.png and on: fog is painted into the scene of a
// file, a light is dragged, and the error beside the picture settles. Whether all of it went well.
bool make_editor_film(const QString& scene, const QString& folder);

}  // namespace brume
