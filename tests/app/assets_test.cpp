// The library of assets: what is saved as one, listed, filtered, and added where the mouse is.

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QStatusBar>
#include <QToolButton>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/assets/asset_panel.h"
#include "app/assets/save_asset.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_cameras.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/tool_box.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "brume/files.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/scene/cameras.h"
#include "tests/app/dock_of.h"
#include "tests/app/file_jobs.h"

using namespace brume;

namespace {

// A floor at a height of -1 and a wall behind it at z = -3, which the view looks at.
Scene room() {
  Scene scene = tiny_scene();
  const auto add = [&](const char* name, const glm::dvec3& size, const glm::dvec3& place) {
    Surface surface;
    surface.primitive = Primitive{Primitive::Shape::box, size};
    surface.mesh = mesh_of(*surface.primitive);
    surface.translate = place;
    surface.name = name;
    scene.surfaces.push_back(surface);
  };
  add("floor", {40.0, 0.2, 40.0}, {0.0, -1.1, 0.0});
  add("wall", {40.0, 20.0, 0.2}, {0.0, 5.0, -3.1});
  scene.camera.eye = {0.0, 1.0, 5.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.medium = Medium();
  scene.medium.append({{0.1, 0.2, 0.0}, 0.2, 1.0});
  scene.medium.append({{0.4, 0.2, 0.0}, 0.3, 1.0});
  return scene;
}

// The panel, which is shown for that: else it lists nothing.
AssetPanel& panel(TestWindow& window) {
  auto& found = *window->findChild<AssetPanel*>();
  if (!found.isVisible()) show_dock_of(found);
  return found;
}
QListWidget& list(TestWindow& window) {
  return *panel(window).findChild<QListWidget*>("assets");
}

// An asset is found by name; null: it is not shown.
QListWidgetItem* shown_asset(TestWindow& window, const QString& name) {
  for (QListWidgetItem* item : list(window).findItems(name, Qt::MatchExactly)) {
    if (!item->isHidden()) return item;
  }
  return nullptr;
}

std::filesystem::path asset_file(const TestWindow& window, const char* name) {
  return window.file("assets") / name;
}

bool picks(TestWindow& window) {
  return QTest::qWaitFor([&] { return window.view().surfaces().is_ready(); }, patience);
}

// Lets an asset fall into the view, by what the list drags.
void drop_asset(TestWindow& window, const QString& name, QPoint position) {
  QListWidgetItem* item = shown_asset(window, name);
  QVERIFY(item);
  const std::unique_ptr<QMimeData> data(
      list(window).model()->mimeData({list(window).indexFromItem(item)}));
  const QPoint place = window.view().mapTo(&*window, position);
  QVERIFY(drop_at(window, place, *data));
  QCOMPARE(wait(window), "");
}

void select_all(TestWindow& window) {
  const auto ids = window.scene().medium.ids();
  select_gaussians(window.document(), {ids.begin(), ids.end()});
}

void save_selected_fog(TestWindow& window, const char* name) {
  select_all(window);
  panel(window).save_chosen(AssetKind::fog, asset_file(window, name));
}

}  // namespace

class AssetsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_list_that_shows_none_says_why() {
    TestWindow window(room());
    const auto shows_text = [&] {
      const QImage picture = list(window).viewport()->grab().toImage();
      for (int x = 0; x < picture.width(); ++x) {
        for (int y = 0; y < picture.height(); ++y) {
          if (picture.pixel(x, y) != picture.pixel(0, 0)) return true;
        }
      }
      return false;
    };
    QCOMPARE(list(window).count(), 0);
    QVERIFY(shows_text());
    save_selected_fog(window, "steam.fog.brume");
    QTRY_VERIFY(shown_asset(window, "steam"));
    panel(window).findChild<QLineEdit*>("asset_filter")->setText("no such name");
    QVERIFY(!shown_asset(window, "steam"));
    QVERIFY(shows_text());
  }

  void fog_that_is_saved_lands_on_the_floor_under_the_mouse_as_a_group() {
    TestWindow window(room());
    save_selected_fog(window, "puff.fog.brume");
    QTRY_VERIFY(shown_asset(window, "puff"));
    // Icons of kinds have no background, thumbnails do.
    QTRY_COMPARE(
        shown_asset(window, "puff")->icon().pixmap(84, 56).toImage().pixelColor(2, 2).alpha(), 255);
    QVERIFY(picks(window));
    const Scene before = window.scene();
    const int steps = step_count(window.document());
    const glm::dvec3 place(1.0, -1.0, 1.0);
    drop_asset(window, "puff", film_position(window.view(), place));
    QCOMPARE(step_count(window.document()), steps + 1);
    QCOMPARE(last_step(window.document()), "Add puff");
    const auto added = gaussians_after(window.document(), 2);
    QCOMPARE(added.size(), 2u);
    // The lower of both stands on the floor, their middle is where the mouse was.
    QVERIFY(std::abs(added[1].center.y - added[1].radius + 1.0) < 0.05);
    QVERIFY(std::abs(added[0].center.x + 0.2 - place.x) < 0.1);
    QVERIFY(glm::distance(added[1].center - added[0].center, {0.3, 0.0, 0.0}) < 1e-12);
    QCOMPARE(window.scene().groups.size(), 1u);
    QCOMPARE(QString::fromStdString(window.scene().groups[0].name), "puff");
    QVERIFY(is_undone(window.document(), before));
  }

  void what_lands_on_a_wall_stands_before_it() {
    TestWindow window(room());
    save_selected_fog(window, "puff.fog.brume");
    QTRY_VERIFY(shown_asset(window, "puff"));
    QVERIFY(picks(window));
    drop_asset(window, "puff", film_position(window.view(), {0.0, 1.0, -3.0}));
    const auto added = gaussians_after(window.document(), 2);
    QCOMPARE(added.size(), 2u);
    QVERIFY(std::abs(added[1].center.z - added[1].radius + 3.0) < 0.05);
  }

  void a_mesh_lands_where_it_is_dropped_and_the_view_stays() {
    TestWindow window(room());
    std::filesystem::create_directories(window.file("assets"));
    std::ofstream(asset_file(window, "wedge.obj"))
        << "v 10 10 0\nv 11 10 0\nv 10 11 0.5\nf 1 2 3\n";
    window->document().save(window.file("scene.brume"));
    QTRY_VERIFY(shown_asset(window, "wedge"));
    QVERIFY(picks(window));
    const Camera camera = window.view().camera();
    const glm::dvec3 place(-1.0, -1.0, 0.5);
    drop_asset(window, "wedge", film_position(window.view(), place));
    QCOMPARE(step_count(window.document()), 1);
    QCOMPARE(window.scene().surfaces.size(), 3u);
    const MeshBox box = world_box(window.scene().surfaces[2]);
    QVERIFY(std::abs(box.low.y + 1.0) < 0.02);
    QVERIFY(std::abs(0.5 * (box.low.x + box.high.x) - place.x) < 0.05);
    QVERIFY(window.view().camera() == camera);
    // Its place can be adjusted as the last operation.
    QVERIFY(window.document().last_operation().operation());
  }

  void lights_cameras_and_brushes_are_saved_and_come_back() {
    TestWindow window(room());
    Document& document = window.document();
    document.set_object(ObjectRef{ObjectRef::Kind::light, 0});
    QVERIFY(panel(window).chosen_kind() == AssetKind::light);
    panel(window).save_chosen(AssetKind::light, asset_file(window, "key.light.brume"));
    panel(window).save_chosen(AssetKind::camera, asset_file(window, "wide.camera.brume"));
    document.set_object(std::nullopt);
    QVERIFY(panel(window).chosen_kind() == AssetKind::camera);
    window->tools().activate("paintbrush");
    QVERIFY(panel(window).chosen_kind() == AssetKind::brush);
    auto& brush = dynamic_cast<PaintbrushTool&>(window->tools().tool());
    BrushPreset preset = brush.preset();
    preset.spacing = 0.25;
    brush.apply_preset(preset);
    panel(window).save_chosen(AssetKind::brush, asset_file(window, "fine.brush.json"));
    preset.spacing = 1.0;
    brush.apply_preset(preset);
    window->tools().activate("select");
    QTRY_VERIFY(shown_asset(window, "fine"));
    QVERIFY(shown_asset(window, "key"));
    QVERIFY(shown_asset(window, "wide"));
    QVERIFY(picks(window));

    // A light hangs before what is under the mouse.
    const std::size_t lights = window.scene().lights.size();
    const glm::dvec3 place(1.0, -1.0, 1.0);
    drop_asset(window, "key", film_position(window.view(), place));
    QCOMPARE(window.scene().lights.size(), lights + 1);
    const Light& light = window.scene().lights.back();
    QVERIFY(light.position.y > -1.0);
    QVERIFY(glm::distance(light.position, place) < 1.0);
    QVERIFY(light.intensity == window.scene().lights.front().intensity);

    // A camera looks at what is under the mouse, as from where it looked before, and is used.
    drop_asset(window, "wide", film_position(window.view(), place));
    QCOMPARE(window.scene().camera_name, "wide");
    QVERIFY(glm::distance(window.scene().camera.target, place) < 0.05);
    QCOMPARE(camera_names(window.scene()).size(), 2);
    QCOMPARE(step_count(document), 2);

    // Enter and a double click add, too.
    Q_EMIT list(window).itemActivated(shown_asset(window, "fine"));
    QCOMPARE(window->tools().entries()[window->tools().active()].name, "paintbrush");
    QCOMPARE(brush.preset().spacing, 0.25);
    QCOMPARE(step_count(document), 2);
  }

  void the_list_shows_what_the_filter_and_the_kind_say() {
    TestWindow window(room());
    save_selected_fog(window, "puff.fog.brume");
    panel(window).save_chosen(AssetKind::camera, asset_file(window, "wide.camera.brume"));
    QTRY_VERIFY(shown_asset(window, "wide"));
    type(window, "asset_filter", "PU");
    QVERIFY(shown_asset(window, "puff"));
    QVERIFY(!shown_asset(window, "wide"));
    window->findChild<QLineEdit*>("asset_filter")->clear();
    auto& kinds = *window->findChild<QComboBox*>("asset_kinds");
    kinds.setCurrentIndex(kinds.findText("Cameras"));
    QVERIFY(!shown_asset(window, "puff"));
    QVERIFY(shown_asset(window, "wide"));
    kinds.setCurrentIndex(0);
    // Files that come and go do so in the list.
    std::filesystem::remove(asset_file(window, "puff.fog.brume"));
    QTRY_VERIFY(!shown_asset(window, "puff"));
    // Those beside another scene are others.
    window->document().create();
    QTRY_VERIFY(!shown_asset(window, "wide"));
  }

  void the_menu_of_saving_has_what_is_chosen() {
    TestWindow window(room());
    auto& menu = *window->findChild<QMenu*>("asset_save_menu");
    const auto entries = [&menu] {
      Q_EMIT menu.aboutToShow();
      QStringList texts;
      for (const QAction* action : menu.actions()) texts << action->text();
      return texts;
    };
    QCOMPARE(entries(), QStringList{"Camera “Camera”…"});
    window.document().set_object(ObjectRef{ObjectRef::Kind::surface, 1});
    QCOMPARE(entries(), QStringList({"Surface “wall”…", "Camera “Camera”…"}));
    select_all(window);
    group_selection(window.document(), "steam");
    window->tools().activate("airbrush");
    QVERIFY(entries().contains("Selected Fog “steam”…"));
    QVERIFY(entries().contains("Brush “Airbrush”…"));
  }

  void a_second_asset_that_is_refused_does_not_move_the_first() {
    TestWindow window(room());
    save_selected_fog(window, "puff.fog.brume");
    QVERIFY(picks(window));
    const glm::dvec3 place(1.0, -1.0, 1.0);
    View& view = window.view();
    const std::filesystem::path file = asset_file(window, "puff.fog.brume");
    window->file_jobs().add_asset(file, view, film_position(window.view(), place));
    window->file_jobs().add_asset(file, view, film_position(window.view(), {-2.0, -1.0, 0.0}));
    QCOMPARE(wait(window), "");
    const auto added = gaussians_after(window.document(), 2);
    QCOMPARE(added.size(), 2u);
    QVERIFY(std::abs(added[0].center.x + 0.2 - place.x) < 0.1);
  }

  void fog_is_not_added_where_its_group_has_no_room() {
    Scene scene = room();
    for (std::size_t k = 1; k <= limits::groups; ++k) {
      scene.groups.push_back({.id = static_cast<GroupId>(k), .name = std::to_string(k)});
    }
    TestWindow window(scene);
    save_selected_fog(window, "puff.fog.brume");
    QTRY_VERIFY(shown_asset(window, "puff"));
    const Scene before = window.scene();
    QSignalSpy refused(&window.document(), &Document::refused);
    Q_EMIT list(window).itemActivated(shown_asset(window, "puff"));
    QCOMPARE(wait(window), "");
    QCOMPARE(refused.size(), 1);
    QVERIFY(window.scene() == before);
  }

  void fog_of_a_group_in_another_is_saved_as_both_make_it() {
    Scene scene = room();
    scene.groups = {{.id = 1, .name = "inner", .parent = 2, .density_factor = 2.0},
                    {.id = 2, .name = "outer", .density_factor = 3.0, .density_offset = 0.5}};
    scene.medium = Medium();
    scene.medium.append({.center = {0.1, 0.2, 0.0}, .radius = 0.2, .density = 1.0, .group = 1});
    TestWindow window(scene);
    save_selected_fog(window, "puff.fog.brume");
    const Scene saved = load_scene(asset_file(window, "puff.fog.brume"));
    QCOMPARE(saved.groups.size(), 1u);
    QCOMPARE(saved.groups[0].parent, GroupId{0});
    QCOMPARE(saved.groups[0].density_factor, 6.0);
    QCOMPARE(saved.groups[0].density_offset, 0.5);
  }

  void a_brush_replaces_any_file_and_leaves_permissions() {
    TestWindow window(room());
    std::filesystem::create_directories(window.file("assets"));
    const std::filesystem::path file = asset_file(window, "fine.brush.json");
    std::ofstream(file) << "no brush";
    const auto permissions = [](const std::filesystem::path& path) {
      return std::filesystem::status(path).permissions();
    };
    const auto of_folder = permissions(window.file("assets"));
    const auto of_file = permissions(file);
    window->tools().activate("airbrush");
    panel(window).save_chosen(AssetKind::brush, file);
    QVERIFY(permissions(window.file("assets")) == of_folder);
    QVERIFY(permissions(file) == of_file);
    window->tools().activate("select");
    use_brush(window->tools(), file);
    QCOMPARE(window->tools().entries()[window->tools().active()].name, "airbrush");
  }

  void an_emitter_is_not_saved_as_something_else() {
    Scene scene = room();
    scene.emitters.emplace_back();
    TestWindow window(scene);
    select_all(window);
    window.document().set_object(ObjectRef{ObjectRef::Kind::emitter, 0});
    QVERIFY(!panel(window).chosen_kind());
    invoke(window, "asset.save");
    QVERIFY(window->statusBar()->currentMessage().contains("emitter"));
  }

  void names_get_the_end_of_their_kind() {
    QVERIFY(asset_file("mist v1.2", AssetKind::fog) == "mist v1.2.fog.brume");
    QVERIFY(asset_file("mist.fog.brume", AssetKind::fog) == "mist.fog.brume");
    QVERIFY(asset_file("mist.fog.brume", AssetKind::light) == "mist.fog.brume.light.brume");
  }

  void a_broken_asset_says_so_and_adds_nothing() {
    TestWindow window(room());
    save_selected_fog(window, "puff.fog.brume");
    QTRY_VERIFY(shown_asset(window, "puff"));
    std::ofstream(asset_file(window, "puff.fog.brume")) << "no scene";
    Q_EMIT list(window).itemActivated(shown_asset(window, "puff"));
    QVERIFY(wait(window).contains("puff.fog.brume"));
    QCOMPARE(window.scene().medium.size(), 2u);
  }
};

BRUME_APP_SUITE("assets", AssetsTest)
#include "assets_test.moc"
