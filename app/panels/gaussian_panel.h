#pragma once

#include <QLineEdit>
#include <QTableView>
#include <QWidget>

namespace brume {

class Document;
class GaussianSortModel;
class GaussianTableModel;

// The Gaussians in numbers: the selection's above, then how radius and density are spread, and the
// table of all of them, or of those that a filter lets pass, in the order of any column. What is
// selected here is selected everywhere.
class GaussianPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianPanel(Document& document, QWidget* parent = nullptr);

  [[nodiscard]] QTableView* table() const { return table_; }

 Q_SIGNALS:
  void refused(const QString& problem);  // why a typed value was not taken

 private:
  void add_filter(QLayout& layout);
  void select_rows();  // as the document has it
  void take_selection();

  Document& document_;
  GaussianTableModel* rows_;
  GaussianSortModel* model_;
  QTableView* table_;
  bool syncing_ = false;
};

}  // namespace brume
