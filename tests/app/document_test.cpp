// The document, its commands and the table's model, without a window.

#include "app/document/document.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_keys.h"
#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/commands/scene_part_command.h"
#include "app/document/text/number_text.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

void load(Document& document, const QTemporaryDir& folder, const Scene& scene) {
  const auto file = std::filesystem::path(folder.path().toStdString()) / "scene.brume";
  save_document(scene, file);
  document.open(load_scene(file), file);
}

// Puts the centres of Gaussians elsewhere, as one move of a drag.
void move_gaussians(Document& document, const std::vector<GaussianId>& ids,
                    std::span<const glm::dvec3> centers, MergeId drag) {
  std::vector<Gaussian> after = document.gaussians(ids);
  for (std::size_t k = 0; k < ids.size(); ++k) after[k].center = centers[k];
  change_gaussians(document, ids, after, "Move " + gaussians_text(ids.size()), drag);
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void removal_takes_gaussians_from_the_selection() {
    const QTemporaryDir folder;
    Document document;
    load(document, folder, small_scene());
    add_gaussian(document, {{}, 1.0, 1.0});
    const GaussianId added = document.medium().ids().back();
    QCOMPARE(document.selection(), std::vector{added});
    const MediumEdit remove = MediumEdit::remove(document.medium(), document.selection());
    document.select({1, 2, added});
    document.apply(remove);
    QCOMPARE(document.selection(), (std::vector<GaussianId>{1, 2}));
    document.select({added, 12345});  // neither is there
    QVERIFY(document.selection().empty());
  }

  void a_gesture_is_one_step_or_none() {
    Document document;
    add_gaussian(document, {{1.0, 2.0, 3.0}, 1.0, 1.0});
    const std::vector<GaussianId> ids = document.selection();
    const glm::dvec3 start = document.medium().centers()[0];
    const auto put = [&](glm::dvec3 center, MergeId drag) {
      move_gaussians(document, ids, {&center, 1}, drag);
    };
    const MergeId first = new_merge_id();
    put({5, 5, 5}, first);
    put({6, 6, 6}, first);
    QCOMPARE(step_count(document), 2);
    put(start, first);
    QCOMPARE(step_count(document), 1);
    put({7, 7, 7}, new_merge_id());
    put({8, 8, 8}, new_merge_id());
    QCOMPARE(step_count(document), 3);
    QCOMPARE(document.undo_stack().text(2), "Move 1 Gaussian");
  }

  void a_change_to_the_same_value_is_no_step() {
    Document document;
    add_gaussian(document, {{}, 1.0, 1.0});
    document.undo_stack().undo();
    document.undo_stack().redo();
    QVERIFY(
        set_attribute(document, document.selection(), GaussianAttribute::radius, 1.0).isEmpty());
    QCOMPARE(step_count(document), 1);
  }

  void unknown_keys_follow_a_light_through_deletion_and_undo() {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "scene.brume";
    SceneDocument loaded = small_scene();
    loaded.scene.lights.assign(3, Light{});
    for (const int k : {0, 2}) {
      const std::string name = "{\"name\": \"light " + std::to_string(k) + "\"}";
      loaded.extras.unknown_keys.add(loaded.scene.lights[static_cast<std::size_t>(k)].id, "", name);
    }
    save_document(loaded, file);
    Document document;
    document.open(load_document(file), file);
    const auto saved = [&] { return document_to_json(document.document_to_save(), "/"); };
    const std::string all = saved();
    delete_object(document, {ObjectRef::Kind::light, 0});
    add_light(document, light::Point(), {{1, 2, 3}});
    const std::string fewer = saved();
    QVERIFY(fewer.find("light 0") == std::string::npos);
    QVERIFY(fewer.find("light 2") < fewer.find("[1.0, 2.0, 3.0]"));
    document.undo_stack().setIndex(0);
    QCOMPARE(saved(), all);
  }

  // Whatever the editor takes, files can hold.
  void accepted_values_round_trip() {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "edited.brume";
    Document document;
    const auto comes_back = [&] {
      document.save(file);
      return load_scene(file).medium == document.medium();
    };
    add_gaussian(document, {{}, 1.0, 1.0});
    const std::vector<GaussianId> ids = document.selection();
    for (const GaussianAttribute field : gaussian_attributes) {
      if (field == GaussianAttribute::elongation) continue;
      int taken = 0;
      for (const double value : {-1e300, -1.1e12, -1e12, -1.0, 0.0, 1e-300, 0.9e-12, 1e-12, 1e-6,
                                 0.5, 1.0, 1e12, 1.1e12, 1e20, 1e300}) {
        if (set_attribute(document, ids, field, value).isEmpty()) ++taken;
        QVERIFY2(comes_back(), qPrintable(attribute_name(field) + number_text(value)));
      }
      QVERIFY(taken >= 3);
      for (const double bad : {1.1 * attribute_domain(field).max_value, parse_number("fog")}) {
        QVERIFY(!set_attribute(document, ids, field, bad).isEmpty());
      }
    }
    const glm::dvec3 far_out(3e12, -4e15, 1.0);
    move_gaussians(document, ids, {&far_out, 1}, new_merge_id());
    QVERIFY(document.medium().centers()[0] == glm::dvec3(1e12, -1e12, 1.0));
    QVERIFY(comes_back());
    add_gaussian(document, {far_out, 1e-30, 1e30});
    QCOMPARE(document.medium().radii()[1], 1e-12);
    QCOMPARE(document.medium().densities()[1], 1e12);
    QVERIFY(comes_back());
  }

  void the_scene_camera_is_an_edit() {
    Document document;
    const Camera before = document.scene().camera;
    Camera camera = before;
    camera.eye.x += 1.0;
    set_scene_camera(document, camera, "Set scene camera to view");
    QVERIFY(document.scene().camera == camera && document.is_modified());
    document.undo_stack().undo();
    QVERIFY(document.scene().camera == before);
  }

  void snapshots_are_shared_until_something_changes() {
    Document document;
    const auto first = document.snapshot();
    QCOMPARE(document.snapshot().get(), first.get());
    add_gaussian(document, {{}, 1.0, 1.0});
    QVERIFY(document.snapshot() != first);
    QVERIFY(first->medium.empty());
  }

  void scattered_rows_wait_for_a_reload() {
    Document document;
    std::vector<Gaussian> many(1000, Gaussian{{}, 1.0, 0.1});
    document.apply(MediumEdit::add(document.medium(), many));
    GaussianTableModel model(document);
    bool has_followed = true;
    on_medium_edit(document, &model,
                   [&](const MediumEdit& edit) { has_followed = model.follow(edit); });
    std::vector<GaussianId> odd;
    for (const GaussianId id : document.medium().ids()) {
      if (id % 2 == 1) odd.push_back(id);
    }
    document.select(odd);
    set_attribute(document, odd, GaussianAttribute::density, 0.2);
    QVERIFY(has_followed);
    delete_selection(document, "Delete");
    QVERIFY(!has_followed);
    QCOMPARE(model.rowCount(), 1000);
    const int gone = *model.row(odd[3]);
    QVERIFY(!model.index(gone, 0).data().isValid());
    QVERIFY(!model.setData(model.index(gone, 0), "1", Qt::EditRole));
    model.reload();
    QCOMPARE(model.rowCount(), 500);
    QVERIFY(!model.row(odd[3]));
    document.undo_stack().undo();
    model.reload();
    QCOMPARE(model.rowCount(), 1000);
  }
};

BRUME_APP_SUITE("document", DocumentTest)
#include "document_test.moc"
