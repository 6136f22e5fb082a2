#pragma once

#include <QWidget>
#include <array>

#include "app/document/gaussian_attribute.h"
#include "app/widgets/optics_editor.h"

class QFormLayout;
class QLayout;

namespace brume {

class Document;
class ValueField;

// Fields of the selection's attributes: the common value, or "mixed". Edits apply to all selected
// Gaussians; rotations to the ellipsoids among them.
class GaussianForm : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianForm(Document& document, QWidget* parent = nullptr);

  static constexpr std::array attributes{
      GaussianAttribute::center_x,   GaussianAttribute::center_y,  GaussianAttribute::center_z,
      GaussianAttribute::radius,     GaussianAttribute::density,   GaussianAttribute::radius_x,
      GaussianAttribute::radius_y,   GaussianAttribute::radius_z,  GaussianAttribute::rotation_x,
      GaussianAttribute::rotation_y, GaussianAttribute::rotation_z};

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  void add_field(std::size_t k);
  void refresh();
  // As entered, while they give the rotation: other angles may give it, too.
  [[nodiscard]] glm::dvec3 angles(const Gaussian& gaussian) const;
  void rotate(GaussianAttribute field, double degrees, MergeId gesture);
  void change_optics(const OpticsEditor::Change& change, MergeId gesture);

  Document& document_;
  std::array<ValueField*, attributes.size()> fields_{};
  glm::dvec3 entered_angles_{0.0};
  QFormLayout* layout_ = nullptr;
  QLayout* rotation_ = nullptr;     // its row, shown for ellipsoids
  OpticsEditor* optics_ = nullptr;  // shows the first of the selection
  glm::dvec3 shown_albedo_{0.0};    // of the medium
};

}  // namespace brume
