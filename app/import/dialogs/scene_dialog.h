#pragma once

#include <QDialog>

#include "core/scene/imported_scene.h"

class QCheckBox;

namespace brume {

// Asks what else of a scene is imported beside its surfaces: its cameras, its lights.
class SceneDialog : public QDialog {
  Q_OBJECT
 public:
  SceneDialog(const ImportedScene& scene, QWidget* parent);

 Q_SIGNALS:
  void requested(bool cameras, bool lights);

 private:
  QCheckBox* add_box(const QString& name, const QString& text, std::size_t count);
};

}  // namespace brume
