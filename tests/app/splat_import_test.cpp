// Splats that come in from files, as their dialog says.

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <fstream>

#include "app/document/paths.h"
#include "app/import/dialogs/scene_dialog.h"
#include "app/import/dialogs/splat_dialog.h"
#include "app/import/scene_import.h"
#include "app/window/pages/message_bar.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/scene/imported_scene.h"
#include "tests/app/file_jobs.h"
#include "tests/app/two_splats.h"
#include "tests/core/io/gaussians/splat_gltf_builder.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

const std::vector<Gaussian> two_of_a_table{{{0, 1, 0}, 0.5, 0.1}, {{0, 2, 0}, 0.7, 0.2}};

// Answers "longest radius" and y down.
void answer_splats(SplatDialog& dialog) {
  dialog.findChild<QComboBox*>("splat_opacity")->setCurrentText("Longest radius");
  dialog.findChild<QComboBox*>("splat_up")->setCurrentIndex(1);
  click(dialog, "import");
}

}  // namespace

class SplatImportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void splats_become_ellipsoids_as_the_dialog_says() {
    for (const char* name : {"splats.ply", "splats.glb"}) {
      FileDesk desk;
      Document& document = desk.document();
      const Scene before = document.scene();
      std::vector<Gaussian> written = write_two_splats(desk.file(name), {1.0, 2.0, 3.0});
      for (Gaussian& g : written) g.optics.albedo = glm::dvec3(1.0, 0.5, 0.1);
      write_splats(desk.file(name), written, {.along = OpacityAlong::longest});
      drop(desk, {desk.file(name)});
      QCOMPARE(wait(desk), "");
      auto* dialog = shown<SplatDialog>(desk);
      QVERIFY(dialog);
      QCOMPARE(dialog->findChild<QComboBox*>("splat_opacity")->currentText(), "Mean radius");
      QTest::mouseClick(dialog->findChild<QCheckBox*>("splat_albedos"), Qt::LeftButton,
                        Qt::NoModifier, {5, 10});
      answer_splats(*dialog);
      QCOMPARE(wait(desk), "");
      QCOMPARE(document.medium().size(), before.medium.size() + 2);
      for (std::size_t k = 0; k < 2; ++k) {
        const Gaussian g = document.medium().gaussian(before.medium.size() + k);
        QVERIFY(is_half_turned(g, written[k]));
        QVERIFY(glm::length(g.optics.albedo.value() - glm::dvec3(1.0, 0.5, 0.1)) < 1e-6);
      }
      document.undo_stack().undo();
      QVERIFY(document.scene() == before);
    }
  }

  void several_files_of_splats_are_asked_about_once() {
    FileDesk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    const auto first = write_two_splats(desk.file("a.ply"), {1.0, 2.0, 3.0});
    const auto last = write_two_splats(desk.file("c.glb"), {4.0, 5.0, 6.0});
    write_gaussians(desk.file("b.csv"), two_of_a_table);
    drop(desk, {desk.file("a.ply"), desk.file("b.csv"), desk.file("c.glb")});
    QCOMPARE(wait(desk), "");
    QCOMPARE(desk.findChildren<SplatDialog*>().size(), 1);
    auto* dialog = shown<SplatDialog>(desk);
    QCOMPARE(dialog->windowTitle(), "Import 3 files");
    QVERIFY(document.scene() == before);
    answer_splats(*dialog);
    QCOMPARE(wait(desk), "");
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Import 3 files");
    const auto imported = [&](std::size_t k) {
      return document.medium().gaussian(before.medium.size() + k);
    };
    QCOMPARE(document.medium().size(), before.medium.size() + 6);
    for (std::size_t k = 0; k < 2; ++k) {
      QVERIFY(is_half_turned(imported(k), first[k]));
      QVERIFY(imported(2 + k) == two_of_a_table[k]);
      QVERIFY(is_half_turned(imported(4 + k), last[k]));
    }
  }

  void a_sequence_of_splats_is_written_as_gaussians() {
    FileDesk desk;
    std::vector<std::vector<Gaussian>> written;
    for (const char* name : {"s_1.ply", "s_2.ply"}) {
      const double x = written.size();
      written.push_back(write_two_splats(desk.file(name), {x, 2.0, 3.0}));
    }
    // Both ways to import one.
    for (const bool by_dropping : {true, false}) {
      const fs::path folder = desk.file(by_dropping ? "dropped" : "chosen");
      if (by_dropping) {
        drop(desk, {desk.file("s_1.ply"), desk.file("s_2.ply")});
      } else {
        desk.import().import_sequence(desk.file("s_2.ply"));
      }
      QCOMPARE(wait(desk), "");
      auto* dialog = shown<SplatDialog>(desk);
      QVERIFY(dialog);
      QCOMPARE(dialog->windowTitle(), "Import s_%d.ply");
      dialog->findChild<QLineEdit*>("sequence_folder")->setText(to_qstring(folder));
      answer_splats(*dialog);
      QCOMPARE(wait(desk), "");
      const MediumSequence& sequence = desk.scene().sequences.back();
      QCOMPARE(sequence.file, folder / "s_%d.ply");
      QCOMPARE(sequence.frames->size(), 2u);
      for (std::size_t frame = 0; frame < 2; ++frame) {
        for (std::size_t k = 0; k < 2; ++k) {
          const Gaussian& found = sequence.frames->frame(frame)->gaussians.at(k);
          QVERIFY(is_half_turned(found, written[frame][k]));
        }
      }
      QCOMPARE(QDir(to_qstring(folder)).entryList(QDir::Files).size(), 2);
    }
    // Over the files themselves it is not.
    desk.import().import_splats(frames_around(desk.file("s_1.ply")), {},
                                desk.file("dropped") / "..");
    QVERIFY(wait(desk).contains("another folder"));
    QVERIFY(has_splats(desk.file("s_1.ply")));
    QCOMPARE(step_count(desk.document()), 2);
  }

  void bad_splats_of_a_sequence_are_told() {
    TestWindow window;
    for (const char* name : {"s_1.ply", "s_2.ply"}) {
      std::ofstream(window.file(name))
          << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nproperty float opacity\nproperty float scale_0\nend_header\n"
             "0 0 0 0 -1\n0 0 0 nan -1\n1 0 0 0 -1\n";
    }
    window->file_jobs().import().import_splats(frames_around(window.file("s_1.ply")), {},
                                               window.file("imported"));
    QCOMPARE(wait(window), "");
    const QString told = window->findChild<MessageBar*>()->message();
    for (const char* name : {"s_1.ply: 1 of 3 splats", "s_2.ply: 1 of 3 splats"}) {
      QVERIFY2(told.contains(name), qPrintable(told));
    }
  }

  void splats_that_cannot_be_read_are_reported() {
    FileDesk desk;
    SplatGltfBuilder compressed;
    compressed.extension()["extensions"]["KHR_gaussian_splatting_compression_spz_2"]["bufferView"] =
        0;
    std::ofstream(desk.file("spz.glb"), std::ios::binary) << compressed.binary();
    write_splats(desk.file("empty.gltf"), {});
    for (const auto& [name, problem] :
         {std::pair("spz.glb", "not compressed"), std::pair("empty.gltf", "medium is empty")}) {
      drop(desk, {desk.file(name)});
      const QString found = wait(desk);
      QVERIFY2(found.contains(problem), qPrintable(found));
      drop(desk, {desk.file(name), desk.file(name)});
      QVERIFY(wait(desk).contains(problem));
    }
    QVERIFY(!desk.findChild<SplatDialog*>());
    QCOMPARE(step_count(desk.document()), 0);
  }

  void splats_come_with_what_else_their_gltf_has() {
    SplatGltfBuilder builder;
    const std::size_t corners = builder.add({0, 0, 0, 1, 0, 0, 1, 1, 0}, "VEC3");
    builder.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", corners}}}}}}});
    builder.json["nodes"].push_back({{"name", "triangle"}, {"mesh", 1}});
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}}}}};
    builder.json["nodes"].push_back({{"name", "Camera"}, {"camera", 0}});
    builder.json["scenes"][0]["nodes"] = {0, 1, 2};
    FileDesk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    std::ofstream(desk.file("both.glb"), std::ios::binary) << builder.binary();
    drop(desk, {desk.file("both.glb")});
    QCOMPARE(wait(desk), "");
    auto* dialog = shown<SplatDialog>(desk);
    QVERIFY(dialog);
    click(*dialog, "import");
    QCOMPARE(wait(desk), "");
    auto* parts = shown<SceneDialog>(desk);
    QVERIFY(parts);
    click(*parts, "import");
    QCOMPARE(document.medium().size(), before.medium.size() + 2);
    QCOMPARE(document.scene().surfaces.size(), before.surfaces.size() + 1);
    QCOMPARE(document.scene().surfaces.back().imported->parts.size(), 1u);
    QCOMPARE(document.scene().cameras.size(), before.cameras.size() + 1);
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Import both.glb");
  }

  void the_file_dialog_offers_splats_of_gltf_as_gaussians() {
    FileDesk desk;
    QStringList filters;
    QTimer::singleShot(0, [&filters] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog) filters = dialog->nameFilters();
      if (dialog) dialog->reject();
    });
    desk.import().ask();
    const QStringList gaussians = filters.filter("Gaussians (");
    QCOMPARE(gaussians.size(), 1);
    for (const char* pattern : {"*.csv", "*.ply", "*.gltf", "*.glb"}) {
      QVERIFY(gaussians[0].contains(pattern));
    }
  }
};

BRUME_APP_SUITE("splat_import", SplatImportTest)
#include "splat_import_test.moc"
