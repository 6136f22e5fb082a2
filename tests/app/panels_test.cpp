// The panels that edit environment, medium and materials, and the outliner.

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/panels/forms/environment_panel.h"
#include "app/panels/forms/light_panel.h"
#include "app/panels/forms/material_panel.h"
#include "app/panels/forms/metallic_roughness_form.h"
#include "app/viewport/viewport.h"
#include "app/widgets/color_button.h"
#include "app/widgets/value_field.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/lights/photometry.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

class PanelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_medium_as_a_whole() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    enter(desk, "homogeneous_density", "0.05");
    QCOMPARE(document.medium().homogeneous_density(), 0.05);
    enter(desk, "albedo_y", "0.7");
    QCOMPARE(document.scene().optics.albedo, glm::dvec3(1.0, 0.7, 1.0));
    enter(desk, "anisotropy", "0.5");
    enter(desk, "noise_amplitude", "0.4");
    enter(desk, "noise_seed", "9");
    QCOMPARE(document.scene().optics.noise.seed, std::int64_t{9});
    enter(desk, "anisotropy", "0.5");  // as it is
    enter(desk, "anisotropy", "2");    // refused
    QCOMPARE(step_count(document), 5);
    const Scene after = document.scene();
    QVERIFY(is_undone(document, before));
    QCOMPARE(value(desk, "albedo_y"), "1");
    document.undo_stack().setIndex(5);
    QVERIFY(document.scene() == after);
  }

  void fog_reaches_as_far_as_the_view_or_an_extent() {
    Desk desk;
    Document& document = desk.document();
    const auto extent = [&] { return document.scene().optics.extent; };
    QVERIFY(!desk.findChild<ValueField*>("extent")->isEnabled());
    click(desk, "endless_fog");
    QVERIFY(extent() && *extent() > 0.0);
    enter(desk, "extent", "12");
    QCOMPARE(extent(), std::optional(12.0));
    enter(desk, "extent", "0");  // refused
    QCOMPARE(extent(), std::optional(12.0));
    click(desk, "endless_fog");
    QVERIFY(!extent());
    QCOMPARE(step_count(document), 3);
  }

  void an_environment_is_loaded_rotated_and_removed() {
    Desk desk;
    Document& document = desk.document();
    auto* intensity = desk.findChild<ValueField*>("environment_intensity");
    QVERIFY(!intensity->isEnabled());
    auto* picture = desk.findChild<QLabel*>("environment_picture");
    QVERIFY(picture->pixmap().isNull());
    desk.findChild<EnvironmentPanel*>()->load(BRUME_RESOURCES "/environments/sunset.exr");
    QVERIFY(picture->text().contains("sunset.exr"));  // it is read in the background
    QTRY_VERIFY(document.scene().environment);
    QVERIFY(intensity->isEnabled());
    const QImage straight = picture->pixmap().toImage();
    QVERIFY(!straight.isNull());
    enter(desk, "environment_rotation", "90");
    enter(desk, "environment_intensity", "0.5");
    QCOMPARE(document.scene().environment->rotation, 90.0);
    QVERIFY(picture->pixmap().toImage() != straight);
    const QString file = QString(BRUME_RESOURCES "/environments/missing.exr");
    QSignalSpy refused(desk.findChild<EnvironmentPanel*>(), &EnvironmentPanel::refused);
    desk.findChild<EnvironmentPanel*>()->load(file);
    QTRY_COMPARE(refused.count(), 1);
    QCOMPARE(step_count(document), 3);
    QVERIFY(!picture->pixmap().isNull());
    click(desk, "remove_environment");
    QVERIFY(!document.scene().environment);
    document.undo_stack().undo();
    QCOMPARE(document.scene().environment->intensity, 0.5);
  }

  void materials() {
    Desk desk;
    Document& document = desk.document();
    document.open(load_scene(BRUME_RESOURCES "/scenes/bunny_fog.brume"), {});
    const Scene before = document.scene();
    auto* type = desk.findChild<QComboBox*>("material_type");
    auto* surfaces = desk.findChild<QComboBox*>("surface");
    QCOMPARE(static_cast<std::size_t>(surfaces->count()), before.surfaces.size());
    const int index = surfaces->count() - 1;
    surfaces->setCurrentIndex(index);
    auto* reflectance = desk.findChild<ColorButton*>("reflectance");
    QVERIFY(reflectance->isEnabled());
    QCOMPARE(reflectance->icon().pixmap(34, 16).toImage().pixel(5, 5),
             to_color(before.surfaces.back().material.reflectance).rgb());
    const auto material = [&] {
      return document.scene().surfaces[static_cast<std::size_t>(index)].material;
    };
    type->setCurrentIndex(1);
    Q_EMIT type->activated(1);
    QVERIFY(material().type == Material::Type::phong);
    QCOMPARE(surfaces->currentIndex(), index);
    enter(desk, "exponent", "40");
    QCOMPARE(material().exponent, 40.0);
    Q_EMIT desk.findChild<ColorButton*>("specular")->edited({0.5, 0.25, 0.125}, no_merge);
    QCOMPARE(material().specular, glm::dvec3(0.5, 0.25, 0.125));
    auto* transfer = desk.findChild<QComboBox*>("transfer");
    QCOMPARE(transfer->currentIndex(), 0);
    transfer->setCurrentIndex(2);
    Q_EMIT transfer->activated(2);
    QVERIFY(document.scene().surfaces.back().transfer == Surface::Transfer::interreflection);
    QVERIFY(document.scene().surfaces.front().transfer == Surface::Transfer::none);
    QCOMPARE(step_count(document), 4);
    document.undo_stack().setIndex(0);
    QCOMPARE(transfer->currentIndex(), 0);
    QVERIFY(document.scene() == before);
  }

  void copies() {
    Desk desk;
    Document& document = desk.document();
    document.open(load_scene(BRUME_RESOURCES "/scenes/spruces.brume"), {});
    desk.findChild<MaterialPanel*>()->show_surface(1);
    auto* copies = desk.findChild<QComboBox*>("copies");
    QCOMPARE(copies->currentData().toString(), "hill");
    const auto scatter = [&] { return document.scene().surfaces[1].copies->scatter; };
    enter(desk, "scatter_density", "0.01");
    enter(desk, "scatter_turn", "45");
    QCOMPARE(scatter().density, 0.01);
    QCOMPARE(scatter().max_turn, 45.0);
    QVERIFY(document.visible_snapshot()->surfaces[1].placed_copies != nullptr);
    // They stay on a surface that gets another name.
    rename_object(document, {ObjectRef::Kind::surface, 0}, "ground");
    QCOMPARE(scatter().over, std::string("ground"));
    Q_EMIT copies->activated(0);
    QVERIFY(!document.scene().surfaces[1].copies);
    QVERIFY(!desk.findChild<QWidget*>("scatter_density")->isEnabled());
    Q_EMIT copies->activated(1);
    QCOMPARE(scatter().over, std::string("ground"));
    QCOMPARE(step_count(document), 5);
  }

  void metallic_roughness() {
    Desk desk;
    Document& document = desk.document();
    document.open(load_scene(BRUME_RESOURCES "/scenes/bunny_fog.brume"), {});
    const Scene before = document.scene();
    const auto material = [&]() -> const MetallicRoughness& {
      return document.scene().surfaces[0].material.metallic_roughness;
    };
    desk.findChild<MaterialPanel*>()->show_surface(0);
    auto* form = desk.findChild<MetallicRoughnessForm*>();
    QVERIFY(form->isHidden());
    auto* type = desk.findChild<QComboBox*>("material_type");
    type->setCurrentIndex(3);
    Q_EMIT type->activated(3);
    QVERIFY(document.scene().surfaces[0].material.type == Material::Type::metallic_roughness);
    QVERIFY(!form->isHidden());
    QCOMPARE(material().base_color, before.surfaces[0].material.reflectance);
    enter(desk, "roughness", "0.25");
    enter(desk, "metallic", "0.75");
    enter(desk, "emissive_y", "3");
    QCOMPARE(material().roughness, 0.25);
    QCOMPARE(material().metallic, 0.75);
    QCOMPARE(material().emissive, glm::dvec3(0.0, 3.0, 0.0));
    Q_EMIT desk.findChild<ColorButton*>("base_color")->edited({0.5, 0.25, 0.125}, no_merge);
    QCOMPARE(material().base_color, glm::dvec3(0.5, 0.25, 0.125));

    auto* alpha = desk.findChild<QComboBox*>("alpha");
    alpha->setCurrentIndex(2);
    Q_EMIT alpha->activated(2);
    QVERIFY(material().alpha == AlphaMode::blend);
    enter(desk, "opacity", "0.5");
    QCOMPARE(material().opacity, 0.5);

    const std::filesystem::path file = desk.file("wood.png");
    std::ofstream(file, std::ios::binary) << encode_png(1, 1, std::vector<std::uint8_t>(3, 200));
    form->load_texture(&MetallicRoughness::base_color_texture, file);
    QTRY_VERIFY(material().base_color_texture.content);
    auto* choose = desk.findChild<QPushButton*>("base_color_texture");
    QCOMPARE(choose->text(), "wood.png");
    QCOMPARE(step_count(document), 8);
    click(desk, "base_color_texture_remove");
    QVERIFY(material().base_color_texture == TextureReference{});
    document.undo_stack().undo();
    QVERIFY(material().base_color_texture.content);
    QVERIFY(is_undone(document, before));
    QVERIFY(form->isHidden());
  }

  void a_measured_material_is_read_in_the_background() {
    Desk desk;
    Document& document = desk.document();
    document.open(load_scene(BRUME_RESOURCES "/scenes/bunny_fog.brume"), {});
    auto* panel = desk.findChild<MaterialPanel*>();
    const std::filesystem::path file = desk.file("grey.binary");
    {
      // 90 x 90 x 180 of three colours, 0.5 / pi each (see MERL's scale factors).
      std::ofstream merl(file, std::ios::binary);
      const std::int32_t size[]{90, 90, 180};
      merl.write(reinterpret_cast<const char*>(size), sizeof size);
      const std::vector<double> plane(90 * 90 * 180, 200.0);
      for (int c = 0; c < 3; ++c) {
        merl.write(reinterpret_cast<const char*>(plane.data()),
                   static_cast<std::streamsize>(plane.size() * sizeof(double)));
      }
    }
    panel->show_surface(1);
    panel->load_measured(file);
    panel->show_surface(0);  // the one that was shown is meant
    QTRY_VERIFY(document.scene().surfaces[1].material.measured);
    QVERIFY(document.scene().surfaces[1].material.type == Material::Type::measured);
    QVERIFY(!document.scene().surfaces[0].material.measured);
    QCOMPARE(step_count(document), 1);
    // Another scene is not given it.
    document.undo_stack().undo();
    panel->load_measured(file);
    document.create();
    QTest::qWait(500);
    QCOMPARE(step_count(document), 0);
  }

  void the_outliner_leads_to_the_panels() {
    TestWindow window;
    auto* tree = window->findChild<QTreeWidget*>("outliner_tree");
    click(window, "add_light");
    QCOMPARE(tree->topLevelItem(0)->child(0)->text(0), "5 Gaussians");
    QTreeWidgetItem* second = tree->topLevelItem(1)->child(1);
    window->document().set_active_light(0);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(second).center());
    QCOMPARE(window->document().active_light(), 1u);
    QTRY_VERIFY(window->findChild<ValueField*>("light_intensity")->isVisible());
    window->document().undo_stack().undo();
    QCOMPARE(tree->topLevelItem(1)->childCount(), 1);
    QCOMPARE(window->document().active_light(), 0u);
  }
};

BRUME_APP_SUITE("panels", PanelsTest)
#include "panels_test.moc"
