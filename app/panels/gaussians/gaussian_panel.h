#pragma once

#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

class Document;
class FilterBar;
class GaussianTableModel;

// The inspector: attributes of the selection, histograms, and a sortable, filterable table
// synchronized with the selection.
class GaussianPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianPanel(Document& document, QWidget* parent = nullptr);

  [[nodiscard]] QTableView* table() const { return table_; }

 protected:
  // All that the table's keys select are its rows.
  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void refused(const QString& problem);  // why a typed value was rejected

 private:
  void add_column_menu();  // of the header: which are shown
  void select_rows();      // from the document
  void adopt_selection();
  void follow(const MediumEdit& edit);
  void reload();
  std::vector<GaussianId> shown();  // that can be selected; says so where none can
  void group_shown();
  void remember_place();  // before the model is reset, which leaves none
  void restore_place();

  Document& document_;
  GaussianTableModel* model_;
  QTableView* table_;
  FilterBar* filter_;
  bool syncing_ = false;
  std::optional<GaussianId> current_;  // while the model is reset
  int current_column_ = 0;
  bool is_typed_ = false;  // whether its editor is open
  int scrolled_ = 0;
  QTimer reload_timer_;  // of very many rows: running while they are not those of the document
  glm::dvec3 shown_albedo_{0.0};  // of the medium
};

}  // namespace brume
