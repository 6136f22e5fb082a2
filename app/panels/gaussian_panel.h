#pragma once

#include <QLineEdit>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <glm/vec3.hpp>

namespace brume {

class Document;
class GaussianSortModel;
class GaussianTableModel;

// The inspector: attributes of the selection, histograms, and a sortable, filterable table
// synchronized with the selection.
class GaussianPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianPanel(Document& document, QWidget* parent = nullptr);

  [[nodiscard]] QTableView* table() const { return table_; }

 Q_SIGNALS:
  void refused(const QString& problem);  // why a typed value was rejected

 private:
  void add_filter(QLayout& layout);
  void select_rows();  // from the document
  void adopt_selection();
  void follow(const MediumEdit& edit);
  void reload();

  Document& document_;
  GaussianTableModel* rows_;
  GaussianSortModel* model_;
  QTableView* table_;
  bool syncing_ = false;
  QTimer reload_timer_;  // of very many rows: running while they are not those of the document
  glm::dvec3 shown_albedo_{0.0};  // of the medium
};

}  // namespace brume
