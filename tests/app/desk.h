#pragma once

#include <QTemporaryDir>
#include <QWidget>

#include "app/document/document.h"
#include "app/document/time/timeline.h"
#include "app/tools/tool_box.h"
#include "app/view/surface_picker.h"
#include "app/view/view.h"
#include "app/view/view_input.h"
#include "tests/app/test_window.h"

namespace brume {

// A view with the mouse of the editor that shows no pictures.
class DeskView : public QWidget, public View {
  Q_OBJECT
 public:
  DeskView(Document& document, SurfacePicker& surfaces, QWidget* parent);

  void set_tool(Tool* tool);
  void finish_input() { input_.flush_moves(); }
  void show_band(const QRect& /*rectangle*/) override {}

 Q_SIGNALS:
  void pointed_at(QPointF position);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;

 private:
  ViewInput input_;
};

// A scene from a file on a desk of all panels and tools, without the window and its pictures: what
// panels and tools do is tested here in a tenth of the time. Keys are those of tools and of undo.
// Each desk saves in the end what it has, which has to come back from the file; undoes everything,
// which has to give the scene as it was opened; and redoes it.
class Desk : public QWidget, public ViewMouse {
  Q_OBJECT
 public:
  explicit Desk(const Scene& scene = small_scene());
  ~Desk() override;

  [[nodiscard]] std::filesystem::path file(const char* name) const;
  // Takes a file of this desk's folder as the scene.
  void open(const char* name);

  Document& document() { return document_; }
  const Scene& scene() { return document_.scene(); }
  Timeline& timeline() { return timeline_; }
  ToolBox& tools() { return *tools_; }
  DeskView& view() { return *view_; }
  // Waits until surfaces can be picked.
  bool picks();

  using ViewMouse::move;
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

 private:
  void follow_time();
  void verify_saved();
  void verify_undone();
  QWidget* new_column(const QList<QWidget*>& panels);

  QTemporaryDir folder_;
  Document document_;
  Scene opened_;
  std::string opened_bytes_;
  Timeline timeline_{nullptr};
  SurfacePicker surfaces_{document_};
  DeskView* view_;
  ToolBox* tools_;
};

}  // namespace brume
