#pragma once

#include <QTreeWidget>
#include <optional>

namespace brume {

class Document;
class GroupRows;

// The scene as a tree; a click requests the panel of an item, one on the eye of a surface hides or
// shows it. The keys and the context menu delete emitters, lights and surfaces, and duplicate
// surfaces. Rows of groups are GroupRows'.
class Outliner : public QTreeWidget {
  Q_OBJECT
 public:
  enum class Kind { gaussians, medium, group, emitter, light, environment, surface };
  explicit Outliner(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void asked_for(brume::Outliner::Kind kind, std::size_t index);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  // One of several emitters, lights or surfaces; or a group, whose index is its id.
  struct Object {
    Kind kind;
    std::size_t index;
  };
  static std::optional<Object> object_of(const QTreeWidgetItem* item);

  void rebuild();
  void count_gaussians();
  // Or the last of its kind, if there are fewer; of groups none.
  void set_current(const Object& object);
  void toggle_visible(const Object& object);  // of a surface
  void delete_object(const Object& object);
  void duplicate_object(const Object& object);

  Document& document_;
  GroupRows* groups_;
  QTreeWidgetItem* gaussians_ = nullptr;
};

}  // namespace brume
