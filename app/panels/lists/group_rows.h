#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "brume/gaussian.h"

class QMenu;
class QMimeData;
class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

class Document;

// The rows of groups in the outliner: colour and name, which the active one has bold, the number of
// its Gaussians, an eye and a lock; last, the Gaussians in no group, as group 0.
class GroupRows : public QObject {
  Q_OBJECT
 public:
  GroupRows(Document& document, QTreeWidget& tree);

  // New rows below `medium`; those of the tree are gone. `make` makes an item without a text.
  void add_rows(QTreeWidgetItem& medium,
                const std::function<QTreeWidgetItem*(GroupId group)>& make);
  void expand();  // as they were, once the rows are in the tree
  void update();  // numbers, and which is active

  // A click on a name selects, one on the eye or lock toggles it.
  void click(GroupId group, int column);
  void rename(GroupId group);  // in place
  void fill_menu(QMenu& menu, GroupId group);

  // The dragged group, or else the selected Gaussians; null: nothing.
  [[nodiscard]] QMimeData* mime_data(std::optional<GroupId> group) const;
  static QStringList mime_types();
  // Moves what was dragged into a group, 0 out of all; false if that cannot be.
  bool drop(const QMimeData& data, GroupId onto);

  static constexpr int name_column = 0;
  static constexpr int eye_column = 1;
  static constexpr int lock_column = 2;

 private:
  void show_state(QTreeWidgetItem& item, GroupId group);
  void toggle_visible(GroupId group);
  void toggle_locked(GroupId group);

  Document& document_;
  QTreeWidget& tree_;
  std::map<GroupId, QTreeWidgetItem*> items_;
  std::set<GroupId> collapsed_;
};

}  // namespace brume
