#pragma once

#include <QTableView>
#include <QWidget>

namespace brume {

class Document;
class GaussianTableModel;

// The Gaussians in numbers: the selection's above, all of them below. What is selected here is
// selected everywhere.
class GaussianPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianPanel(Document& document, QWidget* parent = nullptr);

  [[nodiscard]] QTableView* table() const { return table_; }

 Q_SIGNALS:
  void refused(const QString& problem);  // why a typed value was not taken

 private:
  void select_rows();  // as the document has it
  void take_selection();

  Document& document_;
  GaussianTableModel* model_;
  QTableView* table_;
  bool syncing_ = false;
};

}  // namespace brume
