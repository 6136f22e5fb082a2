// Pictures of the editor for its manual: every panel, every tool, the views.
//   editor_pictures SET SCENE FOLDER
//   editor_pictures film SET FOLDER
// Whole windows show SET and go to FOLDER/window, tools and panels show SCENE; what the manual
// shows of them goes to FOLDER. The second form makes the frames of a film. See
// tools/make-editor-pictures.

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTabWidget>
#include <QTreeWidget>

#include "app/assets/asset_panel.h"
#include "app/assets/save_asset.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/private_files.h"
#include "app/document/time/timeline.h"
#include "app/export/render_queue.h"
#include "app/panels/forms/plate_panel.h"
#include "app/pictures/picture_viewer.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "tests/app/driven_window.h"
#include "tests/app/editor_film.h"

using namespace brume;

namespace {

constexpr QSize window_size(1280, 800);
constexpr QSize high_size(1280, 1300);  // for panels, whose rows all are to be seen
constexpr int max_panel_height = 640;

class Pictures : public DrivenWindow {
 public:
  Pictures(const QString& set, QString scene, const QString& folder)
      : DrivenWindow(set, window_size, folder), scene_(std::move(scene)) {
    QDir().mkpath(folder + "/window");
  }

  void make() {
    take_window();
    make_viewer();
    allow_error(two_percent);
    open(scene_);
    make_tools();
    make_help();
    make_views();
    make_plate();
    window_.resize(high_size);
    settle();
    make_panels();
    make_output_tabs();
    make_coloured_panels();
  }

 private:
  // The window at rest in both themes, and parts of it.
  void take_window() {
    take("window");
    take("view_header", area(view().findChild<QWidget*>("view_header")));
    act("theme_light");
    QTest::qWait(300);
    take("theme_light");
    act("theme_dark");
    QTest::qWait(300);
    constexpr int width = 320;  // of what is said of the picture
    const QRect bar = area(window_.statusBar());
    take("status", bar.adjusted(bar.width() - width, 0, 0, 0));
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

  void stroke(const std::vector<QPoint>& path, int pause) {
    press(path.front());
    for (const QPoint place : path) {
      move(place);
      QTest::qWait(pause);
    }
  }

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
    const std::vector<QPoint> beside{{600, 240}, {600, 235}};  // the forms that emitters bring
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
        const auto& way = name == "lasso" ? loop : name == "emitter" ? beside : path;
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
    make_assets();
    make_keys();
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
      if (!dock->isFloating()) take_panel(*dock);  // the picture viewer is a window of its own
    }
    document.select({});
    window_.findChild<QDockWidget*>("curves_dock")->hide();
  }

  // The panel Assets lists meshes, a volume and fog, with their thumbnails.
  void make_assets() {
    const QString folder = to_qstring(make_private_folder(user_asset_folder()));
    const QString resources = BRUME_RESOURCES;
    for (const char* file : {"/meshes/bunny.obj", "/meshes/teapot.obj", "/scenes/spruce.ply",
                             "/scenes/candle_wax.ply", "/volumes/smoke_0025.vdb"}) {
      if (!QFile::copy(resources + file, folder + '/' + QString(file).section('/', -1))) {
        failed_ = true;
      }
    }
    auto& panel = *window_.findChild<AssetPanel*>();
    panel.save_chosen(AssetKind::fog, to_path(folder + "/wisp.fog.brume"));
    window_.findChild<QDockWidget*>("assets_dock")->show();
    window_.findChild<QDockWidget*>("assets_dock")->raise();
    const auto* list = panel.findChild<QListWidget*>("assets");
    until([list] { return list->count() >= 6; });
    QTest::qWait(8000);  // until the thumbnails are there
  }

  // Keyframes of two lights. The click chooses the values of the second one for the curves.
  void make_keys() {
    Document& document = window_.document();
    for (const int frame : {0, 24, 60}) {
      window_.timeline().set_frame(frame);
      document.set_active_light(1);
      set_key(document, "Light 1 position");
      enter(window_, "light_intensity", QString::number(40 + 2 * frame));
      set_key(document, "Light 2 intensity");
    }
    window_.timeline().set_frame(12);
    auto* sheet = window_.findChild<QWidget*>("keys");
    QTest::qWait(300);
    QTest::mouseClick(sheet, Qt::LeftButton, {}, QPoint(60, 80));
  }

  // Again those that show albedo and emission, of coloured smoke that glows, and of fire.
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

  // The panel is as high as its rows, if there is room.
  void take_panel(QDockWidget& dock) {
    dock.show();
    dock.raise();
    const auto* scroll = qobject_cast<QScrollArea*>(dock.widget());
    const int height = scroll ? scroll->widget()->sizeHint().height() + 30 : 260;
    window_.resizeDocks({&dock}, {std::min(height, max_panel_height)}, Qt::Vertical);
    hover(QPoint(view().width() / 4, view().height() / 2));
    QTest::qWait(100);
    hover(QPoint(view().width() / 4, view().height() / 2 + 3));
    QTest::qWait(300);
    take("panel_" + dock.objectName(), area(&dock));
  }

  // The queue with a render that is done and one that is being rendered.
  void make_output_tabs() {
    auto* dock = window_.findChild<QDockWidget*>("output_dock");
    auto* tabs = window_.findChild<QTabWidget*>("output_tabs");
    enter(window_, "film_width", "96");
    enter(window_, "film_height", "64");
    enter(window_, "output_first", "0");
    enter(window_, "output_last", "3");
    auto* file = window_.findChild<QLineEdit*>("output_file");
    const auto& queue = *window_.findChild<RenderQueue*>();
    for (const char* name : {"/morning.png", "/evening.png"}) {
      file->setText(QDir(folder_).absoluteFilePath("frames" + QString(name)));
      file->setModified(true);
      QTest::keyClick(file, Qt::Key_Return);
      act("render.animation");
      QTest::qWait(200);
    }
    until([&queue] { return queue.items().front().state == RenderQueue::State::done; });
    until([&queue] { return queue.items().back().rendered > 0; });
    dock->raise();
    tabs->setCurrentIndex(2);
    QTest::qWait(300);
    take("panel_queue", area(dock));
    until([&queue] { return queue.unfinished() == 0; });
    tabs->setCurrentIndex(0);
  }

  // The picture of the set, and one with a light turned off, left and right of a line.
  void make_viewer() {
    act("render.keep_view");
    window_.document().set_object(ObjectRef{ObjectRef::Kind::light, 2});
    act("select.hide");
    settle();
    act("render.keep_view");
    window_.document().undo_stack().undo();
    window_.document().set_object(std::nullopt);
    act("render.viewer");
    auto& viewer = *window_.findChild<PictureViewer*>();
    viewer.resize(900, 560);
    viewer.findChild<QComboBox*>("picture_mode")->setCurrentIndex(1);
    QTest::qWait(500);
    save(viewer.grab(), "viewer");
    act("render.viewer");
    settle();
  }

  // A photographed picture behind the fog.
  void make_plate() {
    view().camera_controller().look_through_scene_camera();
    auto& plates = *window_.findChild<PlatePanel*>();
    plates.set_picture(to_path(QString(BRUME_RESOURCES) + "/manual/pictures/glow_none.png"));
    auto* behind = window_.findChild<QCheckBox*>("plate_behind");
    until([behind] { return behind->isEnabled(); });
    behind->click();
    settle();
    take("plate", area(&window_.views()));
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

  QString scene_;
};

}  // namespace

int main(int argc, char** argv) {
  const bool is_film = argc == 4 && std::string_view(argv[1]) == "film";
  if (argc != 4) {
    std::fprintf(
        stderr,
        "usage: editor_pictures SET SCENE FOLDER\n       editor_pictures film SET FOLDER\n");
    return 2;
  }
  const QTemporaryDir settings;
  prepare_application_in(settings);
  QApplication application(argc, argv);
  set_up_application(application);
  if (is_film) return make_editor_film(argv[2], argv[3]) ? 0 : 1;
  Pictures pictures(argv[1], argv[2], argv[3]);
  pictures.make();
  return pictures.failed() ? 1 : 0;
}
