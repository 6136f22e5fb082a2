#include "tests/app/desk.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QTabletEvent>

#include "app/document/paths.h"
#include "app/panels/forms/camera_panel.h"
#include "app/panels/forms/emitter_panel.h"
#include "app/panels/forms/group_panel.h"
#include "app/panels/forms/light_panel.h"
#include "app/panels/forms/material_panel.h"
#include "app/panels/forms/medium_panel.h"
#include "app/panels/forms/output_panel.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/panels/lists/outliner.h"
#include "app/panels/plots/contribution_panel.h"
#include "app/panels/time/curve_panel.h"
#include "app/panels/time/timeline_bar.h"
#include "app/tools/tool_bars.h"
#include "app/view/tool.h"
#include "app/widgets/keys.h"
#include "brume/error.h"
#include "core/io/scene/scene_file.h"

namespace brume {

DeskView::DeskView(Document& document, SurfacePicker& surfaces, QWidget* parent)
    : QWidget(parent), View(document, surfaces, Projection::perspective, *this), input_(*this) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setFixedSize(640, 480);
  connect(&input_, &ViewInput::pointed_at, this, &DeskView::pointed_at);
  on_change(document, Change::scene, this, [this] {
    input_.end_gesture();
    camera_controller().reset();
  });
}

void DeskView::set_tool(Tool* tool) {
  input_.set_tool(tool);
  shown_handles().show_centers(!tool || tool->shows_handles());
}

void DeskView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  shown_handles().project();
}

void DeskView::mousePressEvent(QMouseEvent* event) {
  input_.press(*event);
}

void DeskView::mouseMoveEvent(QMouseEvent* event) {
  input_.move(event->position());
}

void DeskView::mouseReleaseEvent(QMouseEvent* event) {
  input_.release(*event);
}

void DeskView::tabletEvent(QTabletEvent* event) {
  input_.set_pen(event->type() != QEvent::TabletRelease, event->pressure());
  event->ignore();
}

Desk::Desk(const Scene& scene)
    : view_(new DeskView(document_, surfaces_, this)),
      tools_(new ToolBox(
          document_, *view_, [this](Tool* tool) { view_->set_tool(tool); }, this)) {
  use_mouse_in(*view_, *view_);
  auto* contributions = new ContributionPanel(document_, this);
  connect(view_, &DeskView::pointed_at, contributions,
          [this, contributions](QPointF position) { contributions->inspect(*view_, position); });
  const auto camera = [this] { return view_->camera(); };
  auto* timeline_bar = new TimelineBar(timeline_, document_, camera, this);
  timeline_bar->setMinimumWidth(1000);  // some pixels for each frame
  auto* curves = new CurvePanel(timeline_, document_, this);
  auto* output = new OutputPanel(
      document_, timeline_, [] { return 0.0; }, new QAction(this), new QAction(this), this);
  auto* row = new QHBoxLayout(this);
  row->addWidget(new_column(
      {new ToolBar(*tools_, this), new ToolOptions(*tools_, this), view_, timeline_bar, curves}));
  row->addWidget(new_column(
      {new Outliner(document_, this), new GaussianPanel(document_, this), contributions}));
  row->addWidget(new_column({new LightPanel(
      document_, [this]() -> const View& { return *view_; }, this)}));
  row->addWidget(new_column(
      {new MediumPanel(document_, Scattering::single, this), new MaterialPanel(document_, this)}));
  row->addWidget(new_column({new EmitterPanel(document_, this), new GroupPanel(document_, this)}));
  row->addWidget(new_column({new CameraPanel(document_, camera, this), output}));
  for (QAction* action : {document_.undo_stack().createUndoAction(this, tr("&Undo")),
                          document_.undo_stack().createRedoAction(this, tr("&Redo"))}) {
    action->setShortcuts(keys_of(actions().isEmpty() ? "edit.undo" : "edit.redo"));
    addAction(action);
  }
  follow_time();
  save_document(scene, file("scene.brume"));
  open("scene.brume");
  show();
  activateWindow();
  if (!QTest::qWaitForWindowActive(this, patience)) qFatal("the desk did not come up");
}

Desk::~Desk() {
  timeline_.set_frame(0);
  verify_undone();
  verify_saved();
  document_.disconnect();
  document_.undo_stack().disconnect();
  delete tools_;
  qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

void Desk::verify_saved() {
  const std::filesystem::path saved = file("end.brume");
  try {
    document_.save(saved);
    QCOMPARE(document_to_json(load_document(saved), "/"), bytes_of(document_));
  } catch (const InputError& error) {
    QFAIL(error.what());
  }
}

void Desk::verify_undone() {
  const int end = document_.undo_stack().index();
  const std::string after = bytes_of(document_);
  QVERIFY2(is_undone(document_, opened_), "undoing everything gives another scene");
  QCOMPARE(bytes_of(document_), opened_bytes_);
  document_.undo_stack().setIndex(end);
  QCOMPARE(bytes_of(document_), after);
}

QWidget* Desk::new_column(const QList<QWidget*>& panels) {
  auto* column = new QWidget(this);
  auto* layout = new QVBoxLayout(column);
  for (QWidget* panel : panels) layout->addWidget(panel);
  return column;
}

void Desk::follow_time() {
  connect(&timeline_, &Timeline::frame_changed, this, [this] {
    const bool looks_through_camera = view_->camera() == document_.scene().camera;
    view_->set_time(timeline_.time());
    document_.set_time(timeline_.time());
    if (looks_through_camera) view_->camera_controller().set_camera(document_.scene().camera);
  });
  on_change(document_, Change::scene, &timeline_, [this] {
    opened_ = document_.scene();
    opened_bytes_ = bytes_of(document_);
    timeline_.set_frame(0);
    timeline_.follow(document_.scene());
  });
  on_change(document_, Change::part, &timeline_, [this] { timeline_.follow(document_.scene()); });
}

std::filesystem::path Desk::file(const char* name) const {
  return to_path(folder_.filePath(name));
}

void Desk::open(const char* name) {
  document_.open(load_document(file(name)), file(name));
}

bool Desk::picks() {
  return QTest::qWaitFor([this] { return surfaces_.is_ready(); }, patience);
}

void Desk::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  view_->setFocus();
  QTest::keyClick(view_, key, modifiers);
}

}  // namespace brume
