// Scenes of other programs: imported with their cameras and lights, shown, read again.

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QToolButton>
#include <fstream>

#include "app/commands/objects/edit_objects.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/import/dialogs/scene_dialog.h"
#include "app/import/imported_reload.h"
#include "app/import/scene_import.h"
#include "app/panels/lists/outliner.h"
#include "app/window/pages/message_bar.h"
#include "brume/mesh_arrays.h"
#include "core/scene/imported_scene.h"
#include "tests/app/file_jobs.h"
#include "tests/core/io/import/gltf_builder.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

// Two squares, a camera and two lights.
GltfBuilder room() {
  GltfBuilder builder;
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 683}}, {{"type", "directional"}, {"intensity", 68.3}}};
  const auto light = [](int index) {
    return GltfBuilder::Json{{"KHR_lights_punctual", {{"light", index}}}};
  };
  builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}}}}};
  builder.json["nodes"] = {{{"name", "floor"}, {"mesh", 0}},
                           {{"name", "wall"}, {"mesh", 0}, {"translation", {0, 0, -1}}},
                           {{"name", "Camera"}, {"camera", 0}, {"translation", {0, 0, 4}}},
                           {{"name", "lamp"}, {"extensions", light(0)}, {"translation", {0, 1, 1}}},
                           {{"name", "sun"}, {"extensions", light(1)}}};
  builder.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
  return builder;
}

// Answers the dialog with a click on its button.
void answer(const QWidget& window, bool cameras, bool lights) {
  auto* dialog = window.findChild<SceneDialog*>();
  QVERIFY(dialog && dialog->isVisible());
  for (const auto& [name, wanted] :
       {std::pair("import_cameras", cameras), std::pair("import_lights", lights)}) {
    auto* box = dialog->findChild<QCheckBox*>(name);
    QVERIFY(box->isEnabled() && box->isChecked());
    if (!wanted) QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QCOMPARE(box->isChecked(), wanted);
  }
  click(*dialog, "import");
}

}  // namespace

class SceneImportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_dropped_scene_brings_its_cameras_and_lights_as_one_step() {
    FileDesk desk(new_scene());
    Document& document = desk.document();
    const Scene before = document.scene();
    write_text(desk.file("room.glb"), room().binary());
    drop(desk, {desk.file("room.glb")});
    QCOMPARE(wait(desk), "");
    QVERIFY(document.scene() == before);  // until the question is answered
    answer(desk, true, true);
    const Scene& scene = document.scene();
    QCOMPARE(scene.surfaces.size(), 1u);
    QCOMPARE(scene.surfaces[0].imported->parts.size(), 2u);
    QCOMPARE(scene.surfaces[0].mesh_file, desk.file("room.glb"));
    // They take the place of the light of a new scene.
    QCOMPARE(scene.lights.size(), 2u);
    QCOMPARE(scene.lights[0].name, std::string("lamp"));
    QCOMPARE(scene.lights[0].intensity, glm::dvec3(1.0));
    QVERIFY(scene.lights[1].as<light::Directional>());
    // So does its camera.
    QVERIFY(scene.cameras.empty());
    QCOMPARE(scene.camera.eye, glm::dvec3(0, 0, 4));
    QCOMPARE(scene.camera_name, std::string("Camera"));
    QVERIFY(document.object() == ObjectRef(ObjectRef::Kind::surface, 0));
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Import room.glb");
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    QVERIFY(!document.is_modified());
  }

  void a_camera_of_its_own_stays_in_use() {
    FileDesk desk;
    const Camera before = desk.scene().camera;
    write_text(desk.file("room.glb"), room().binary());
    drop(desk, {desk.file("room.glb")});
    QCOMPARE(wait(desk), "");
    answer(desk, true, false);
    QVERIFY(desk.scene().camera == before);
    QCOMPARE(desk.scene().cameras.size(), 1u);
    QCOMPARE(desk.scene().cameras[0].camera.eye, glm::dvec3(0, 0, 4));
    QVERIFY(desk.scene().cameras[0].name != desk.scene().camera_name);
  }

  void nodes_have_rows_and_choose_their_material_to_edit() {
    FileDesk desk;
    Document& document = desk.document();
    GltfBuilder builder = room();
    builder.json["materials"] = {{{"name", "wood"}}, {{"name", "brick"}}};
    builder.json["meshes"].push_back(builder.json["meshes"][0]);
    for (const int k : {0, 1}) builder.json["meshes"][k]["primitives"][0]["material"] = k;
    builder.json["nodes"][0]["children"] = {1};
    builder.json["nodes"][1]["mesh"] = 1;
    builder.json["scenes"][0]["nodes"] = {0};
    write_text(desk.file("room.glb"), builder.binary());
    drop(desk, {desk.file("room.glb")});
    QCOMPARE(wait(desk), "");

    auto* tree = desk.findChild<Outliner*>();
    const auto row = [tree](const QString& name) {
      return tree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive).value(0);
    };
    QVERIFY(row("room.glb") && !row("wall"));
    row("room.glb")->setExpanded(true);
    QCOMPARE(row("wall")->parent(), row("floor"));
    QCOMPARE(row("room.glb")->childCount(), 1);  // the camera has no mesh
    QCOMPARE(row("floor")->parent(), row("room.glb"));
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, cell_position(*tree, row("wall")));
    QVERIFY(document.object() == ObjectRef(ObjectRef::Kind::surface, 0, 1));
    auto* materials = desk.findChild<QComboBox*>("surface_material");
    QCOMPARE(materials->currentText(), "brick");

    enter(desk, "roughness", "0.25");
    QCOMPARE(last_step(document), "Set roughness of brick of room.glb");
    const Surface& surface = desk.scene().surfaces[0];
    QCOMPARE(surface.materials.size(), 1u);
    QCOMPARE(surface.materials[0].metallic_roughness.roughness, 0.25);
    const Surfaces shown = document.visible_snapshot()->surfaces;
    QCOMPARE(shown[0].material.metallic_roughness.roughness, 1.0);
    QCOMPARE(shown[1].material.metallic_roughness.roughness, 0.25);
    QVERIFY(row("wall") && row("wall") == tree->currentItem());  // of the new rows

    QTest::keyClick(tree, Qt::Key_Delete);
    QCOMPARE(desk.scene().surfaces.size(), 1u);
    // The file's other nodes stay as they are, too.
    const Surfaces before = desk.scene().surfaces;
    for (const int column : {1, 2}) {
      QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                        cell_position(*tree, row("wall"), column));
    }
    duplicate_object(document, *document.object());
    show_object(document, *document.object(), false);
    lock_object(document, *document.object(), true);
    QVERIFY(desk.scene().surfaces == before);
    QVERIFY(document.object() == ObjectRef(ObjectRef::Kind::surface, 0, 1));
    materials->setCurrentIndex(0);
    Q_EMIT materials->activated(0);
    choose(desk, "material_type", static_cast<int>(Material::Type::diffuse));
    QVERIFY(document.visible_snapshot()->surfaces[0].material.type == Material::Type::diffuse);
    click(desk, "restore_material");
    QCOMPARE(last_step(document), "Restore wood of room.glb");
    QCOMPARE(desk.scene().surfaces[0].materials.size(), 1u);
    QVERIFY(!desk.findChild<QToolButton*>("restore_material")->isEnabled());
  }

  void what_is_not_wanted_stays_out() {
    FileDesk desk;
    const Scene before = desk.scene();
    write_text(desk.file("room.glb"), room().binary());
    desk.import().import_file(desk.file("room.glb"));
    QCOMPARE(wait(desk), "");
    answer(desk, false, false);
    QCOMPARE(desk.scene().surfaces.size(), 1u);
    QVERIFY(desk.scene().lights == before.lights);
    QVERIFY(desk.scene().cameras == before.cameras);
  }

  void surfaces_alone_need_no_question() {
    FileDesk desk;
    write_text(desk.file("square.glb"), GltfBuilder().binary());
    drop(desk, {desk.file("square.glb")});
    QCOMPARE(wait(desk), "");
    QVERIFY(!desk.findChild<SceneDialog*>());
    QCOMPARE(desk.scene().surfaces.size(), 1u);
  }

  void an_obj_is_a_scene_if_it_has_materials() {
    FileDesk desk;
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    write_text(desk.file("plain.obj"), triangle);
    write_text(desk.file("red.mtl"), "newmtl red\nKd 1 0 0\n");
    write_text(desk.file("red.obj"), "mtllib red.mtl\nusemtl red\n" + triangle);
    for (const char* name : {"plain.obj", "red.obj"}) {
      drop(desk, {desk.file(name)});
      QCOMPARE(wait(desk), "");
    }
    const Scene& scene = desk.scene();
    QCOMPARE(scene.surfaces.size(), 2u);
    QVERIFY(!scene.surfaces[0].imported);
    QVERIFY(scene.surfaces[1].imported);
    const auto& part = scene.surfaces[1].imported->parts.at(0);
    QCOMPARE(part.material.metallic_roughness.base_color, glm::dvec3(1, 0, 0));
  }

  void damaged_and_empty_scenes_are_reported() {
    FileDesk desk;
    write_text(desk.file("bad.glb"), "glTF");
    desk.import().import_file(desk.file("bad.glb"));
    QVERIFY(wait(desk).contains("bad.glb"));
    GltfBuilder empty;
    empty.json["nodes"][0].erase("mesh");
    write_text(desk.file("empty.glb"), empty.binary());
    desk.import().import_file(desk.file("empty.glb"));
    QVERIFY(wait(desk).contains("neither meshes nor cameras nor lights"));
    QVERIFY(desk.scene().surfaces.empty());
  }

  void missing_textures_are_a_note() {
    TestWindow window;
    GltfBuilder builder;
    builder.json["images"] = {{{"uri", "gone.png"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    builder.primitive()["material"] = 0;
    write_text(window.file("a.glb"), builder.binary());
    window->file_jobs().import().import_file(window.file("a.glb"));
    QCOMPARE(wait(window), "");
    QCOMPARE(window.scene().surfaces.size(), 1u);
    auto* bar = window->findChild<MessageBar*>();
    QVERIFY(bar->message().contains("gone.png is missing"));
  }

  void a_changed_file_is_read_again_when_the_window_is_activated() {
    TestWindow window;
    Document& document = window->document();
    const fs::path file = window.file("square.glb");
    write_text(file, GltfBuilder().binary());
    window->file_jobs().import().import_file(file);
    QCOMPARE(wait(window), "");
    change_object_place(window);
    const Scene imported = document.scene();
    auto* reload = window->findChild<ImportedReload*>();
    reload->check();  // nothing has changed
    QTest::qWait(1);

    GltfBuilder larger;
    larger.json["nodes"][0]["scale"] = {3, 3, 3};
    write_text(file, larger.binary());
    fs::last_write_time(file, imported.surfaces[0].imported->changed + std::chrono::seconds(2));
    QEvent activation(QEvent::ActivationChange);
    QTRY_VERIFY2(
        [&] {
          QApplication::sendEvent(&*window, &activation);
          return document.scene().surfaces[0].imported != imported.surfaces[0].imported;
        }(),
        "read again");
    QCOMPARE(box_of(*document.scene().surfaces[0].mesh).high, glm::dvec3(3, 3, 0));
    QCOMPARE(document.scene().surfaces[0].translate, imported.surfaces[0].translate);
    QCOMPARE(last_step(document), "Reload square.glb");
    document.undo_stack().undo();
    QVERIFY(document.scene() == imported);
  }

  void a_change_that_cannot_be_read_is_reported_once_and_changes_nothing() {
    FileDesk desk;
    const fs::path file = desk.file("square.glb");
    write_text(file, GltfBuilder().binary());
    desk.import().import_file(file);
    QCOMPARE(wait(desk), "");
    const Scene imported = desk.scene();
    write_text(file, "glTF");
    fs::last_write_time(file, imported.surfaces[0].imported->changed + std::chrono::seconds(2));
    ImportedReload reload(desk.document(), &desk);
    QSignalSpy failures(&reload, &ImportedReload::failed);
    QTRY_VERIFY((reload.check(), failures.count() > 0));
    QVERIFY(desk.scene() == imported);
    for (int k = 0; k < 3; ++k) {
      reload.check();
      QTest::qWait(20);
    }
    QCOMPARE(failures.count(), 1);
    write_text(file, GltfBuilder().binary());  // which the desk reads in the end
  }

 private:
  // Moves the first surface, so that a reload has something to keep.
  static void change_object_place(TestWindow& window) {
    Scene scene = window.scene();
    Surfaces surfaces = scene.surfaces;
    surfaces[0].translate = {1, 2, 3};
    set_scene_part(window->document(), std::move(surfaces), "Move");
  }
};

BRUME_APP_SUITE("scene_import", SceneImportTest)
#include "scene_import_test.moc"
