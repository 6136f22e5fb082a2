#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "app/commands/merge_id.h"
#include "app/document/scene_part.h"
#include "brume/camera.h"

namespace brume {

class Document;
struct Scene;

// Edits of the scene's cameras, each one undo step. Cameras are known by their names.

// All names, that of the one in use first.
QStringList camera_names(const Scene& scene);
// A camera's name after an edit, by all names before and after it; empty: it went.
QString camera_name_after(const QStringList& names_before, const QStringList& names_after,
                          const QString& name);
// Nullptr: there is none.
const Camera* find_camera(const Scene& scene, const QString& name);

// A name that files may have and no other camera of a scene has: the wanted one, or with a number.
std::string allowed_camera_name(const Scene& scene, const QString& wanted);

// Adds a camera, which is then in use; false if the scene has as many as it may.
bool add_camera(Document& document, const Camera& camera);
void use_camera(Document& document, const QString& name);
// Adds a copy with its keyframes, likewise.
bool duplicate_camera(Document& document, const QString& name);
// Surrounding spaces do not count. No change for an empty name; a taken one gets a number.
void rename_camera(Document& document, const QString& name, const QString& new_name);
// If it is in use, another one is then. The only one is kept.
void delete_camera(Document& document, const QString& name);

// The camera in use with other values, and its keyframes of those that are there.
KeyedCamera keyed_camera(const Document& document, const Camera& camera);

// Replaces values of a camera, and says `what` in the undo text, "Set field of view". Sets
// keyframes for values that have any.
void set_camera(Document& document, const QString& name, const Camera& camera, const QString& what,
                MergeId gesture);
// Moves the camera in use by a gesture in the view. Sets keyframes if it has any.
void move_camera(Document& document, const Camera& camera, MergeId gesture);

}  // namespace brume
