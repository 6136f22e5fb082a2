#pragma once

#include <QObject>
#include <QSet>
#include <functional>
#include <map>

class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

class Document;

// The rows of the nodes of imported scenes that have meshes in the outliner, below those of their
// surfaces. They are made when the row of the surface is expanded first.
class NodeRows : public QObject {
  Q_OBJECT
 public:
  // `make`: makes the item of a surface's node, without a text.
  NodeRows(const Document& document, QTreeWidget& tree,
           std::function<QTreeWidgetItem*(std::size_t surface)> make);

  void clear() { surfaces_.clear(); }  // when the rows of the tree are gone
  // `item`: the row of a surface, which may show no imported scene.
  void add_to(QTreeWidgetItem& item, std::size_t surface);
  void expand();  // as they were, once the rows are in the tree
  static std::size_t node_of(const QTreeWidgetItem& item);

 private:
  void fill(QTreeWidgetItem& item);

  const Document& document_;
  QTreeWidget& tree_;
  std::function<QTreeWidgetItem*(std::size_t surface)> make_;
  std::map<std::size_t, QTreeWidgetItem*> surfaces_;  // rows that have nodes
  QSet<QString> expanded_;                            // their texts
};

}  // namespace brume
