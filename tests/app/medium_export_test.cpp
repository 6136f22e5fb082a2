// Exports other than frames.

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "app/commands/gaussians/edit_groups.h"
#include "app/export/medium_dialog.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/ply.h"
#include "core/io/scene/scene_file.h"
#include "core/io/volume/volume_file.h"
#include "tests/app/file_jobs.h"
#include "tests/app/question.h"
#include "tests/app/two_splats.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;
using Ids = std::vector<GaussianId>;

// Does what File > Export Medium does.
MediumDialog* open_export(FileDesk& desk) {
  // One that was accepted is still to be deleted.
  for (MediumDialog* old : desk.findChildren<MediumDialog*>()) {
    if (!old->isVisible()) delete old;
  }
  auto* dialog = new MediumDialog(desk.document(), desk.timeline(), 0.0, &desk);
  QObject::connect(dialog, &MediumDialog::requested, &desk, [&desk](const MediumExport& what) {
    desk.job().start(export_medium(what), "Exporting");
  });
  dialog->show();
  return dialog;
}

}  // namespace

class MediumExportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_medium_exports_as_a_volume() {
    FileDesk desk;
    auto* dialog = open_export(desk);
    auto* button = dialog->findChild<QPushButton*>("export_medium");
    auto* memory = dialog->findChild<QLabel*>("medium_memory");
    dialog->findChild<QLineEdit*>("medium_file")->setText(to_qstring(desk.file("m.vdb")));
    QVERIFY2(memory->text().endsWith("MB"), qPrintable(memory->text()));
    dialog->findChild<QLineEdit*>("medium_voxel")->setText("0.0001");
    QVERIFY(memory->text().contains("More than 2 GB"));
    QVERIFY(!button->isEnabled());
    dialog->findChild<QLineEdit*>("medium_voxel")->setText("0.2");
    dialog->findChild<QCheckBox*>("medium_is_range")->setChecked(true);
    dialog->findChild<QSpinBox*>("medium_first")->setValue(4);
    auto* last = dialog->findChild<QSpinBox*>("medium_last");
    last->setFocus();
    last->selectAll();
    QTest::keyClicks(last, "-5");
    QVERIFY(!button->isEnabled());
    QVERIFY(memory->text().startsWith("Last frame must be a whole number"));
    last->selectAll();
    QTest::keyClicks(last, "5");
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(wait(desk), "");
    QCOMPARE(volume_grids(desk.file("m_0005.vdb")).at(0).name, std::string("density"));
    QVERIFY(fs::exists(desk.file("m_0004.vdb")));
  }

  void exported_volumes_have_the_colours_of_gaussians() {
    FileDesk desk;
    const Gaussian g{{0, 0, 0}, 0.5, 1.0, {glm::dvec3(0.5, 0.25, 1.0), glm::dvec3(1.0, 2.0, 3.0)}};
    write_gaussians(desk.file("g.csv"), std::vector{g});
    drop(desk, {desk.file("g.csv")});
    QCOMPARE(wait(desk), "");
    auto* dialog = open_export(desk);
    const fs::path file = desk.file("m.vdb");
    dialog->findChild<QLineEdit*>("medium_file")->setText(to_qstring(file));
    dialog->findChild<QLineEdit*>("medium_voxel")->setText("0.2");
    click(*dialog, "export_medium");
    QCOMPARE(wait(desk), "");
    std::vector<std::string> names;
    for (const VolumeGridInfo& grid : volume_grids(file)) names.push_back(grid.name);
    QCOMPARE(names, (std::vector<std::string>{"density", "albedo", "emission"}));
  }

  void the_medium_exports_as_splats() {
    FileDesk desk;
    const std::vector<Gaussian> written = write_two_splats(desk.file("a.ply"), {1.0, 2.0, 3.0});
    write_gaussians(desk.file("g.ply"), written);
    desk.document().create();
    drop(desk, {desk.file("g.ply")});
    QCOMPARE(wait(desk), "");
    const auto expect_longest = [&](const fs::path& file, bool is_half_turned_about_z) {
      const auto found = read_gaussians(file, nullptr, limits::gaussians, {OpacityAlong::longest});
      QCOMPARE(found.size(), 2u);
      for (std::size_t k = 0; k < 2; ++k) {
        Gaussian expected = written[k];
        if (!is_half_turned_about_z) turn_half(expected);
        QVERIFY(is_half_turned(found[k], expected));
      }
    };
    auto* format = open_export(desk)->findChild<QComboBox*>("medium_format");
    const auto export_as = [&](const QString& title, const QString& extension) {
      auto* dialog = shown<MediumDialog>(desk);
      if (!dialog) dialog = open_export(desk);
      format = dialog->findChild<QComboBox*>("medium_format");
      auto* file = dialog->findChild<QLineEdit*>("medium_file");
      file->setText(to_qstring(desk.file("fog.vdb")));
      format->setCurrentIndex(format->findText(title + " (", Qt::MatchStartsWith));
      if (!extension.isEmpty()) file->setText(to_qstring(desk.file("fog")) + extension);
      dialog->findChild<QComboBox*>("medium_opacity")->setCurrentText("Longest radius");
      dialog->findChild<QComboBox*>("medium_up")->setCurrentIndex(1);
      const fs::path chosen = to_path(file->text());
      click(*dialog, "export_medium");
      return chosen;
    };
    const fs::path ply = export_as("Gaussian splats", "");
    QCOMPARE(wait(desk), "");
    QCOMPARE(ply, desk.file("fog.ply"));
    QVERIFY(has_splats(ply));
    expect_longest(ply, true);
    const fs::path glb = export_as("Gaussian splats", ".glb");
    QCOMPARE(wait(desk), "");
    QVERIFY(has_splats(glb));
    expect_longest(glb, false);  // its y is up
    // The extension that is typed chooses the format, too.
    auto* dialog = open_export(desk);
    format = dialog->findChild<QComboBox*>("medium_format");
    auto* file = dialog->findChild<QLineEdit*>("medium_file");
    for (const auto& [extension, title] :
         {std::pair(".gltf", "Gaussian splats"), std::pair(".html", "Web page"),
          std::pair(".csv", "Gaussians"), std::pair(".ply", "Gaussians"),
          std::pair(".usda", "USD stage"), std::pair(".vdb", "Volume")}) {
      file->setText(to_qstring(desk.file("fog")) + extension);
      QVERIFY2(format->currentText().startsWith(QString(title) + " ("), extension);
    }
    for (const auto& [title, row] :
         {std::pair("Volume", "medium_voxel"), std::pair("USD stage", "medium_voxel"),
          std::pair("USD stage", "medium_opacity"), std::pair("Gaussian splats", "medium_up"),
          std::pair("Lit splats", "medium_up"), std::pair("Web page", "medium_exposure"),
          std::pair("Lit splats", "medium_exposure")}) {
      format->setCurrentIndex(format->findText(QString(title) + " (", Qt::MatchStartsWith));
      QVERIFY2(dialog->findChild<QWidget*>(row)->isVisible(), row);
    }
    for (const char* row : {"medium_voxel", "medium_up", "medium_exposure"}) {
      file->setText(to_qstring(desk.file("fog.glb")));
      QVERIFY2(!dialog->findChild<QWidget*>(row)->isVisible(), row);
    }
    file->setText(to_qstring(desk.file("fog.txt")));
    QVERIFY(!dialog->findChild<QPushButton*>("export_medium")->isEnabled());
  }

  void a_selection_or_a_group_is_exported_alone() {
    FileDesk desk;
    Document& document = desk.document();
    const auto what_of = [](MediumDialog& dialog) {
      return dialog.findChild<QComboBox*>("medium_what");
    };
    QVERIFY(!what_of(*open_export(desk))->isVisible());  // there is nothing to choose
    shown<MediumDialog>(desk)->reject();
    document.select({2, 3});
    group_selection(document);
    document.select({3});
    group_selection(document);  // in the first
    document.select({1, 5});
    const auto exported = [&](const QString& what) {
      auto* dialog = open_export(desk);
      what_of(*dialog)->setCurrentText(what);
      dialog->findChild<QLineEdit*>("medium_file")->setText(to_qstring(desk.file("g.csv")));
      click(*dialog, "export_medium");
      std::vector<double> radii;
      if (!wait(desk).isEmpty()) return radii;
      for (const Gaussian& g : read_gaussians(desk.file("g.csv"))) radii.push_back(g.radius);
      fs::remove(desk.file("g.csv"));
      return radii;
    };
    const auto radii_of = [&](std::initializer_list<std::size_t> indices) {
      std::vector<double> radii;
      for (const std::size_t i : indices) radii.push_back(document.medium().radii()[i]);
      return radii;
    };
    QCOMPARE(exported("Selected 2 Gaussians"), radii_of({0, 4}));
    QCOMPARE(exported("Group"), radii_of({1, 2}));
    QCOMPARE(exported("Group 2"), radii_of({2}));
    QCOMPARE(exported("All Gaussians"), radii_of({0, 1, 2, 3, 4}));
  }

  void lit_splats_and_pages_are_exported_as_displayed() {
    FileDesk desk;
    const auto export_to = [&](const QString& title, const char* exposure,
                               const char* what = "All") {
      auto* dialog = open_export(desk);
      auto* box = dialog->findChild<QComboBox*>("medium_what");
      box->setCurrentIndex(box->findText(what, Qt::MatchStartsWith));
      auto* format = dialog->findChild<QComboBox*>("medium_format");
      auto* file = dialog->findChild<QLineEdit*>("medium_file");
      file->setText(to_qstring(desk.file(exposure)) + ".vdb");
      format->setCurrentIndex(format->findText(title + " (", Qt::MatchStartsWith));
      dialog->findChild<QLineEdit*>("medium_exposure")->setText(exposure);
      const fs::path chosen = to_path(file->text());
      click(*dialog, "export_medium");
      return chosen;
    };
    const fs::path dark = export_to("Lit splats", "-2");
    QCOMPARE(wait(desk), "");
    const fs::path bright = export_to("Lit splats", "1");
    QCOMPARE(wait(desk), "");
    const auto sum_of = [](const fs::path& file, const char* name) {
      const std::string bytes = read_bytes(file);
      const PlyFile ply(file, bytes);
      const PlyFile::Element& vertices = *ply.element("vertex");
      const auto column = vertices.property(name);
      double sum = 0.0;
      ply.for_each_row([&](const PlyFile::Element&, std::uint64_t, const PlyFile::Row& row) {
        sum += row.scalars.at(column.value());
      });
      return sum;
    };
    QVERIFY(sum_of(dark, "f_rest_44") != 0.0);
    QVERIFY(sum_of(dark, "f_dc_0") < sum_of(bright, "f_dc_0"));
    // One of two is as bright as among both.
    const auto count_of = [](const fs::path& file) {
      return PlyFile(file, read_bytes(file)).element("vertex")->count;
    };
    QCOMPARE(count_of(bright), desk.document().medium().size());
    const double whole = sum_of(bright, "f_dc_0");
    double parts = 0.0;
    for (const Ids& ids : {Ids{1, 2}, Ids{3, 4, 5}}) {
      desk.document().select(ids);
      fs::remove(bright);
      export_to("Lit splats", "1", "Selected");
      QCOMPARE(wait(desk), "");
      QCOMPARE(count_of(bright), ids.size());
      parts += sum_of(bright, "f_dc_0");
    }
    QVERIFY(std::abs(parts - whole) < 1e-5 * std::abs(whole));  // of numbers with 7 digits
    const fs::path page = export_to("Web page", "0");
    QCOMPARE(wait(desk), "");
    QVERIFY(read_bytes(page).find("data:application/octet-stream") != std::string::npos);
    open_export(desk)->findChild<QLineEdit*>("medium_exposure")->clear();
    auto* format = shown<MediumDialog>(desk)->findChild<QComboBox*>("medium_format");
    format->setCurrentIndex(format->findText("Web page (", Qt::MatchStartsWith));
    QVERIFY(!shown<MediumDialog>(desk)->findChild<QPushButton*>("export_medium")->isEnabled());
    shown<MediumDialog>(desk)->reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

    // A cancelled export writes nothing.
    const fs::path cancelled = export_to("Lit splats", "3");
    desk.job().cancel();
    QCOMPARE(wait(desk), "");
    QVERIFY(!fs::exists(cancelled));
  }

  void a_stage_has_its_fog_as_splats_and_volumes() {
    FileDesk desk;
    auto* dialog = open_export(desk);
    dialog->findChild<QLineEdit*>("medium_file")->setText(to_qstring(desk.file("s.usda")));
    dialog->findChild<QLineEdit*>("medium_voxel")->setText("0.2");
    dialog->findChild<QCheckBox*>("medium_is_range")->setChecked(true);
    dialog->findChild<QSpinBox*>("medium_first")->setValue(4);
    dialog->findChild<QSpinBox*>("medium_last")->setValue(5);
    click(*dialog, "export_medium");
    QCOMPARE(wait(desk), "");
    const std::string stage = read_bytes(desk.file("s.usda"));
    QVERIFY(stage.find("ParticleField3DGaussianSplat") != std::string::npos);
    QVERIFY(stage.find("startTimeCode = 4") != std::string::npos);
    for (const char* name : {"s_fog_0004.vdb", "s_fog_0005.vdb"}) {
      QVERIFY(stage.find(name) != std::string::npos);
      QCOMPARE(volume_grids(desk.file(name)).at(0).name, std::string("density"));
    }
    // Neither the stage nor its volumes are replaced unasked.
    fs::remove(desk.file("s.usda"));
    dialog = open_export(desk);
    dialog->findChild<QLineEdit*>("medium_file")->setText(to_qstring(desk.file("s.usda")));
    dialog->findChild<QCheckBox*>("medium_is_range")->setChecked(true);
    dialog->findChild<QSpinBox*>("medium_first")->setValue(5);
    dialog->findChild<QSpinBox*>("medium_last")->setValue(5);
    QString question;
    answer(QMessageBox::Cancel, &question);
    click(*dialog, "export_medium");
    QVERIFY2(question.contains("s_fog_0005.vdb"), qPrintable(question));
    QVERIFY(!fs::exists(desk.file("s.usda")));
  }

  void the_menu_offers_the_exposure_of_the_view() {
    TestWindow window;
    for (const char* name : {"Exposure Up", "Export Me"}) trigger(window, name);
    auto* dialog = shown<MediumDialog>(window);
    QVERIFY(dialog);
    QCOMPARE(dialog->findChild<QLineEdit*>("medium_exposure")->text(), "0.5");
  }

  void gathered_scenes_open_elsewhere() {
    TestWindow window;
    drop(window, {BRUME_RESOURCES "/meshes/bunny.obj"});
    QCOMPARE(wait(window), "");
    window->file_jobs().gather_to(window.file("gathered"));
    QCOMPARE(wait(window), "");
    const Scene scene = load_scene(window.file("gathered") / "scene.brume");
    QCOMPARE(scene.surfaces.size(), 1u);
    QVERIFY(fs::exists(window.file("gathered") / "files/bunny.obj"));
    QVERIFY(window->document().is_modified());  // what is being edited is not what was written
    window->file_jobs().gather_to(window.file("gathered"));
    QVERIFY(wait(window).contains("already exists"));
  }
};

BRUME_APP_SUITE("medium_export", MediumExportTest)
#include "medium_export_test.moc"
