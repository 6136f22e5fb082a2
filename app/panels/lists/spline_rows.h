#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <vector>

#include "brume/painted_spline.h"

class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

class Document;

// The rows of painted splines in the outliner; that of the one being edited has a bold name.
class SplineRows : public QObject {
  Q_OBJECT
 public:
  SplineRows(Document& document, QTreeWidget& tree);

  // New rows below `medium`; those of the tree are gone. `make` makes an item without a text.
  void add_rows(QTreeWidgetItem& medium,
                const std::function<QTreeWidgetItem*(SplineId spline)>& make);
  // Whether the rows are those of the document's splines: a bent one has the same.
  [[nodiscard]] bool is_current() const;

  void edit(SplineId spline);    // its points, in the view
  void rename(SplineId spline);  // in place
  void fill_menu(QMenu& menu, SplineId spline);

 Q_SIGNALS:
  void edit_asked();  // for the tool

 private:
  [[nodiscard]] std::vector<std::pair<SplineId, std::string>> names() const;
  void update();  // which is active

  Document& document_;
  QTreeWidget& tree_;
  std::map<SplineId, QTreeWidgetItem*> items_;
  std::vector<std::pair<SplineId, std::string>> shown_;
};

}  // namespace brume
