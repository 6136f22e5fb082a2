#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/panels/lists/group_rows.h"

class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

class Document;

// The rows of the scene's cameras in the outliner: the one in use has a bold name, and the icon of
// each uses it and looks through it. Cameras are known by their places: 0 is in use, k + 1 the k-th
// other.
class CameraRows : public QObject {
  Q_OBJECT
 public:
  CameraRows(Document& document, QTreeWidget& tree);

  // New rows below `cameras`; those of the tree are gone. `make` makes an item without a text.
  void add_rows(QTreeWidgetItem& cameras,
                const std::function<QTreeWidgetItem*(std::size_t place)>& make);
  // The place of a camera by its name.
  [[nodiscard]] std::optional<std::size_t> place_of(const QString& name) const;
  void use(std::size_t place);
  void look_through(std::size_t place);
  void rename(std::size_t place, const QString& name);
  void duplicate(std::size_t place);
  void remove(std::size_t place);
  void fill_menu(QMenu& menu, std::size_t place);  // of the current row

 Q_SIGNALS:
  void look_through_asked();  // the one in use
  void in_use_changed();      // by a row

 private:
  static constexpr int name_column = GroupRows::name_column;
  static constexpr int icon_column = GroupRows::eye_column;
  [[nodiscard]] QString name_of(std::size_t place) const;

  Document& document_;
  QTreeWidget& tree_;
};

}  // namespace brume
