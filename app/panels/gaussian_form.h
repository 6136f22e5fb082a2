#pragma once

#include <QWidget>
#include <array>

#include "app/document/gaussian_attribute.h"
#include "app/widgets/optics_editor.h"

namespace brume {

class Document;
class ValueField;

// Fields of the selection's attributes: the common value, or "mixed". Edits apply to all selected
// Gaussians.
class GaussianForm : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianForm(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  void refresh();
  void change_optics(const OpticsEditor::Change& change, MergeId gesture);

  Document& document_;
  std::array<ValueField*, shape_attributes> fields_{};
  OpticsEditor* optics_ = nullptr;  // shows the first of the selection
  glm::dvec3 shown_albedo_{0.0};    // of the medium
};

}  // namespace brume
