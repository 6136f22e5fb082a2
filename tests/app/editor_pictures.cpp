// Pictures of the editor for its manual: every panel, every tool, the views.
//   editor_pictures SCENE FOLDER
// Whole windows of 1280 x 800 logical pixels go to FOLDER/window, what the manual shows of them to
// FOLDER. See tools/make-editor-pictures.

#include <QAction>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <cstdio>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/application.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

class Pictures {
 public:
  Pictures(const QString& scene, const QString& folder) : folder_(folder) {
    QDir().mkpath(folder_ + "/window");
    window_.resize(1280, 800);
    window_.show();
    window_.activateWindow();
    window_.files().open_file(std::filesystem::absolute(to_path(scene)));
    until([this] { return !window_.files().loading().is_running(); });
    settle();
  }

  void make() {
    take("window");
    make_tools();
    make_panels();
    make_views();
    make_help();
    take_light_theme();
    make_coloured_panels();
  }

  [[nodiscard]] bool failed() const { return failed_; }

 private:
  Viewport& view() { return window_.viewport(); }

  bool until(const std::function<bool()>& done) {
    const bool is_done = QTest::qWaitFor(done, 600000);
    if (!is_done) failed_ = true;
    return is_done;
  }
  void settle() {
    until([this] { return view().isHidden() || view().frames().is_measured(); });
    QTest::qWait(300);  // until it is painted
  }

  void save(const QPixmap& picture, const QString& name) {
    if (!picture.save(folder_ + "/" + name + ".png")) failed_ = true;
    std::printf("%s\n", qPrintable(name));
    std::fflush(stdout);
  }
  // The whole window, and of it what the manual shows.
  void take(const QString& name, const QRect& part = {}) {
    const QPixmap all = window_.grab();
    save(all, "window/" + name);
    if (part.isNull()) {
      save(all, name);
    } else {
      const double scale = all.devicePixelRatio();
      save(all.copy(QRectF(part.topLeft() * scale, part.size() * scale).toRect()), name);
    }
  }
  QRect area(const QWidget* widget) {
    return {widget->mapTo(&window_, QPoint(0, 0)), widget->size()};
  }

  void act(const char* action) { invoke(window_, action); }
  void hover(QPoint at) { QTest::mouseMove(&view(), at); }
  void stroke(const std::vector<QPoint>& path, int pause) {
    QTest::mousePress(&view(), Qt::LeftButton, {}, path.front());
    for (const QPoint at : path) {
      move_mouse(view(), at);
      QTest::qWait(pause);
    }
  }
  void release(QPoint at) { QTest::mouseRelease(&view(), Qt::LeftButton, {}, at); }

  // The row of options, and the picture below it.
  QRect tool_part() {
    const QRect options = area(window_.findChild<QWidget*>("tool_options"));
    return {options.topLeft(), QSize(options.width(), 340)};
  }

  // Each with its cursor in the picture, doing what it does.
  void make_tools() {
    Document& document = window_.document();
    // In the fog beside the bunny's head.
    const std::vector<QPoint> path{{60, 270}, {100, 210}, {150, 240}, {200, 190}};
    const std::vector<QPoint> loop{{70, 250},  {110, 170}, {220, 160},
                                   {330, 210}, {240, 290}, {120, 300}};
    std::vector<GaussianId> some;  // there
    for (std::size_t k = 0; k < document.medium().size() && some.size() < 2; ++k) {
      const glm::dvec3& at = view().handles().position(k);
      if (at.y > 180.0 && at.y < 280.0) some.push_back(document.medium().ids()[k]);
    }
    for (const auto& entry : window_.tools().entries()) {
      act(qPrintable("tool." + entry.name));
      const QString& name = entry.name;
      const bool turns = name == "move" || name == "rotate" || name == "scale";
      if (name == "select" || turns) {
        document.select(some);
        settle();
        hover(film_position(view(), view().pivot()));
        take("tool_" + name, tool_part());
      } else {
        document.select({});
        const auto& way = name == "lasso" ? loop : path;
        stroke(way, name == "airbrush" ? 200 : 20);
        if (name == "airbrush") release(way.back());  // it sprays as long as it is held
        settle();
        hover(way.back());
        take("tool_" + name, tool_part());
        if (name != "airbrush") release(way.back());
      }
      document.undo_stack().setIndex(0);
      settle();
    }
    act("tool.select");
  }

  void make_panels() {
    Document& document = window_.document();
    document.select({document.medium().ids()[2], document.medium().ids()[3]});
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
      if (!dock->isFloating()) take_panel(*dock);  // the picture viewer is a window of its own
    }
    document.select({});
  }

  // Again those that show albedo and emission, of coloured smoke that glows, and of fire. It is the
  // last, since `auto` learns from what is shown.
  void make_coloured_panels() {
    Document& document = window_.document();
    const std::vector<GaussianId> two{document.medium().ids()[2], document.medium().ids()[3]};
    document.select(two);
    std::vector<Gaussian> glowing{document.medium().gaussian(2), document.medium().gaussian(3)};
    glowing[0].optics = {glm::dvec3(0.9, 0.4, 0.2), {2.0, 0.6, 0.1}};
    glowing[1].optics = {glm::dvec3(0.3, 0.4, 0.8), {0.2, 0.4, 1.5}};
    change_gaussians(document, two, glowing, "Set colours", no_merge);
    add_emitter(document, {0.0, 0.0, 2.0}, 6.0);
    change_emitter(document, 0, "Set colours of %1", no_merge, [](Emitter& emitter) {
      emitter.optics.emission = {9.0, 2.2, 0.1};
      emitter.emission_at_death = {1.0, 0.1, 0.0};
    });
    auto* emitters = window_.findChild<QDockWidget*>("emitters_dock");
    take_panel(*window_.findChild<QDockWidget*>("gaussians"));
    take_panel(*window_.findChild<QDockWidget*>("at_cursor"));
    emitters->raise();
    QScrollBar* bar = emitters->findChild<QScrollArea*>()->verticalScrollBar();
    QTest::qWait(100);
    bar->setValue(bar->maximum());
    take_panel(*emitters);
  }

  void take_panel(QDockWidget& dock) {
    dock.show();
    dock.raise();
    hover(QPoint(view().width() / 4, view().height() / 2));
    QTest::qWait(100);
    hover(QPoint(view().width() / 4, view().height() / 2 + 3));
    QTest::qWait(300);
    take("panel_" + dock.objectName(), area(&dock));
  }

  void make_views() {
    ViewGrid& views = window_.views();
    act("view.four");
    const auto panes = views.panes();
    panes[1]->frames().set_mode(ViewMode::optical_depth);
    panes[2]->frames().set_mode(ViewMode::cost);
    view().setFocus();
    view().frames().set_mode(ViewMode::error);
    until([&] {
      return std::ranges::all_of(panes,
                                 [](const Viewport* p) { return p->frames().is_settled(); }) &&
             view().frames().error_map() && view().frames().error_map()->done >= 0.2;
    });
    QTest::qWait(300);
    take("views", area(&views));
    view().frames().set_mode(ViewMode::final);
    act("view.four");
    settle();
  }

  void make_help() {
    act("help.keys");
    QTest::qWait(300);
    for (QWidget* top : QApplication::topLevelWidgets()) {
      if (top != &window_ && top->isVisible() && qobject_cast<QDialog*>(top)) {
        save(top->grab(), "keys");
        top->close();
      }
    }
  }

  void take_light_theme() {
    act("theme_light");
    QTest::qWait(300);
    take("theme_light");
    act("theme_dark");
  }

  MainWindow window_;
  QString folder_;
  bool failed_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: editor_pictures SCENE FOLDER\n");
    return 2;
  }
  const QTemporaryDir settings;
  prepare_application_in(settings);
  QApplication application(argc, argv);
  set_up_application(application);
  Pictures pictures(argv[1], argv[2]);
  pictures.make();
  return pictures.failed() ? 1 : 0;
}
