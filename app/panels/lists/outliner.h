#pragma once

#include <QTreeWidget>
#include <optional>

#include "app/document/object_ref.h"
#include "brume/painted_spline.h"

namespace brume {

class CameraRows;
class Document;
class GroupRows;
class NodeRows;
class SplineRows;

// The scene as a tree; a click requests the panel of an item. Lights, emitters and surfaces have an
// eye that hides and shows them (a light is turned on and off), a lock, and names to edit; the keys
// and the context menu delete and duplicate them. Rows of groups are GroupRows',
// those of splines SplineRows', those of nodes of imported scenes NodeRows', those of cameras
// CameraRows'.
class Outliner : public QTreeWidget {
  Q_OBJECT
 public:
  enum class Kind {
    gaussians,
    medium,
    group,
    spline,
    emitter,
    light,
    environment,
    surface,
    node,
    camera
  };
  explicit Outliner(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void asked_for(brume::Outliner::Kind kind, std::size_t index);
  void look_through_asked();  // the camera in use

 public Q_SLOTS:
  void show_camera_in_use();  // its row and its panel
  void rename_current();      // edits the name in place

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
  // Rows of groups are dragged onto others, that of the Gaussians takes the selected ones.
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override;
  bool dropMimeData(QTreeWidgetItem* onto, int index, const QMimeData* dragged,
                    Qt::DropAction action) override;
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }

 private:
  static std::optional<ObjectRef> object_of(const QTreeWidgetItem* item);
  static std::optional<GroupId> group_of(const QTreeWidgetItem* item);
  static std::optional<SplineId> spline_of(const QTreeWidgetItem* item);
  static std::optional<std::size_t> camera_of(const QTreeWidgetItem* item);  // its place
  QTreeWidgetItem* new_object_item(const ObjectRef& ref);

  void rebuild();
  void count_gaussians();
  // Or the last of its kind, if there are fewer.
  void set_current(const ObjectRef& ref);
  void set_current(Kind kind, std::size_t index);
  void follow_object();  // the document's
  void click(const QTreeWidgetItem* item, int column);
  void rename(const QTreeWidgetItem* item, const QString& name);

  Document& document_;
  GroupRows* groups_;
  SplineRows* splines_;
  NodeRows* nodes_;
  CameraRows* cameras_;
  QTreeWidgetItem* gaussians_ = nullptr;
  bool is_stale_ = false;  // rows are made anew once the editor of a name has closed
};

}  // namespace brume
