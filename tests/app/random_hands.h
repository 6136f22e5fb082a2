#pragma once

#include <random>

#include "app/commands/gaussians/clipboard.h"
#include "app/commands/gaussians/edit_gesture.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_cameras.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_keys.h"
#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/commands/objects/edit_output.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/euler_angles.h"
#include "brume/edits.h"
#include "brume/mesh_arrays.h"
#include "core/authoring/eraser.h"
#include "core/authoring/paintbrush.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/light_fields.h"
#include "tests/app/test_window.h"

namespace brume {

// Edits a document at random, the same for the same seed.
class RandomHands {
 public:
  RandomHands(Document& document, unsigned seed) : document_(document), random_(seed) {}

  // Does one of all that users do.
  void act() {
    using Act = void (RandomHands::*)();
    static constexpr Act acts[]{
        &RandomHands::add, &RandomHands::remove, &RandomHands::set_a_field, &RandomHands::drag,
        &RandomHands::paint, &RandomHands::erase, &RandomHands::copy, &RandomHands::choose,
        &RandomHands::choose_by_rule, &RandomHands::light, &RandomHands::emitter,
        &RandomHands::whole_medium, &RandomHands::surface, &RandomHands::object,
        &RandomHands::add_primitive, &RandomHands::camera, &RandomHands::hide_or_lock,
        &RandomHands::environment, &RandomHands::key, &RandomHands::playback, &RandomHands::cameras,
        &RandomHands::output, &RandomHands::group, &RandomHands::go_back,
        // With much to be had of it.
        &RandomHands::group, &RandomHands::group, &RandomHands::group, &RandomHands::group};
    (this->*acts[below(std::size(acts))])();
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }
  double number() { return 0.1 + static_cast<double>(below(1000)) * 0.002; }
  glm::dvec3 point() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  std::vector<GaussianId> some() {
    std::vector<GaussianId> ids;
    for (const GaussianId id : document_.medium().ids()) {
      if (below(3) == 0) ids.push_back(id);
    }
    return ids;
  }

  void add() { add_gaussian(document_, {point(), number(), number()}); }
  void remove() {
    if (below(3) == 0) delete_selection(document_, "Delete");
  }
  void set_a_field() {
    set_attribute(document_, document_.selection(),
                  gaussian_attributes[below(gaussian_attributes.size())],
                  number() - 0.2);  // some are refused
  }
  void drag() {
    const std::vector<GaussianId> ids = document_.selection();
    std::vector<Gaussian> after;
    for (const GaussianId id : ids) {
      after.push_back(document_.medium().gaussian(*document_.medium().index_of(id)));
    }
    const std::vector<Gaussian> before = after;
    const MergeId merge_id = new_merge_id();
    for (int step = 0; step < 3; ++step) {
      for (Gaussian& gaussian : after) gaussian.center += point();
      change_gaussians(document_, ids, after, "Move", merge_id);
    }
    if (below(4) == 0) change_gaussians(document_, ids, before, "Move", merge_id);
  }
  void paint() {
    EditGesture gesture(document_);
    PaintStroke stroke({.radius = number(), .density = number()}, random_());
    gesture.begin();
    for (std::size_t k = below(4); k > 0; --k) {
      gesture.apply(MediumEdit::add(document_.medium(), stroke.extend(point())), "Paint");
    }
    if (below(5) == 0) gesture.cancel();
  }
  void erase() {
    EditGesture gesture(document_);
    EraserStroke stroke(number() / 2.2);
    gesture.begin();
    for (std::size_t k = below(6); k > 0; --k) {
      const glm::dvec3 direction = glm::normalize(point());
      const EraserCone cone{{0, 0, 0}, direction, 0.4};
      gesture.apply(stroke.touch(document_.medium(), {&cone, 1},
                                 [this](GaussianId id) { return document_.is_editable(id); }),
                    "Erase");
    }
    if (below(5) == 0) gesture.cancel();
  }
  void copy() {
    switch (below(5)) {
      case 0:
        return copy_selection(document_);
      case 1:
        return cut_selection(document_);
      case 2:
        return paste_gaussians(document_, std::nullopt);
      case 3:
        return paste_gaussians(document_, point());
      default:
        return duplicate_selection(document_, point());
    }
  }
  void choose() { select_gaussians(document_, some()); }
  void choose_by_rule() {
    const auto rules = {select_all, invert_selection, grow_selection, shrink_selection};
    (*(rules.begin() + below(rules.size())))(document_);
  }
  void light() {
    const std::size_t index = below(3);
    switch (below(4)) {
      case 0:
        return add_light(document_, light_kind(static_cast<std::size_t>(below(6))),
                         {point(), point()});
      case 1:
        return delete_object(document_, {ObjectRef::Kind::light, index});
      default:
        const MergeId merge_id = new_merge_id();
        for (int step = 0; step < 2; ++step) {
          change_light(document_, index, "Change %1", merge_id, [this](Light& light) {
            light.intensity = point();
            light.on = below(2) == 0;
          });
        }
    }
  }
  void emitter() {
    switch (below(4)) {
      case 0:
        return add_emitter(document_, point(), number());
      case 1:
        return delete_object(document_, {ObjectRef::Kind::emitter, below(2)});
      case 2:
        return below(4) == 0 ? freeze_particles(document_, number()) : void();
      default:
        return change_emitter(document_, below(2), "Change %1", no_merge, [this](Emitter& emitter) {
          emitter.velocity = point();
          emitter.optics.emission = point();
          emitter.optics.albedo =
              below(2) == 0 ? std::optional(glm::dvec3(0.4 * point())) : std::nullopt;
        });
    }
  }
  void whole_medium() {
    set_homogeneous_density(document_, below(2) == 0 ? 0.0 : number(), new_merge_id());
    MediumOptics optics = document_.scene().optics;
    optics.anisotropy = below(2) == 0 ? 0.0 : 0.2;
    set_scene_part(document_, optics, "Set anisotropy");
  }
  // A light, an emitter or a surface, there or not.
  void object() {
    const ObjectRef ref{static_cast<ObjectRef::Kind>(below(3)), below(3)};
    const auto before = object_of(document_.scene(), ref);
    switch (below(4)) {
      case 0:
        return rename_object(document_, ref, below(2) == 0 ? "" : "name");
      case 1:
        return show_object(document_, ref, below(2) == 0);
      case 2:
        return lock_object(document_, ref, below(2) == 0);
      default: {
        if (!before) return;
        const MergeId merge_id = new_merge_id();
        for (int step = 0; step < 2; ++step) {
          move_object(document_, ref, *before,
                      {point(), point(), from_euler_angles(100.0 * point()), glm::dvec3(number()),
                       below(2) == 0 ? 1.0 : number()},
                      "Move %1", merge_id);
        }
      }
    }
  }
  void add_primitive() {
    if (document_.scene().surfaces.size() >= 4) return;
    Surfaces surfaces = document_.scene().surfaces;
    Surface& surface = surfaces.emplace_back();
    surface.primitive = Primitive{static_cast<Primitive::Shape>(below(4)), glm::dvec3(number())};
    surface.mesh = mesh_of(*surface.primitive);
    set_scene_part(document_, std::move(surfaces), "Add primitive");
  }
  void surface() {
    const std::size_t count = document_.scene().surfaces.size();
    if (count == 0) return;
    const std::size_t index = below(count);
    const auto change = [&](const std::function<void(Surface&)>& how) {
      change_surface(document_, index, "Change %1", no_merge, how);
    };
    switch (below(5)) {
      case 0:
        return count > 1 ? delete_object(document_, {ObjectRef::Kind::surface, index}) : void();
      case 1:
        return count < 4 ? duplicate_object(document_, {ObjectRef::Kind::surface, index}) : void();
      case 2:
        return change([&](Surface& s) {
          s.translate = point();
          s.rotate = from_euler_angles(100.0 * point());
          s.scale = number();
        });
      case 3:
        return change([](Surface& s) { s.visible = !s.visible; });
      default:
        return change([&](Surface& s) { s.material.reflectance = 0.4 * point(); });
    }
  }
  void camera() {
    Camera camera = document_.scene().camera;
    camera.eye = point() + glm::dvec3(3.0);
    set_scene_camera(document_, camera, "Store view");
  }
  void environment() {
    std::optional<Environment> environment;
    if (below(2) == 0)
      environment = {BRUME_RESOURCES "/environments/sunset.exr", {}, number(), 0.0, {}};
    set_scene_part(document_, environment, "Set environment");
  }
  void group() {
    const Groups& groups = document_.scene().groups;
    // Now and then one that is not there.
    const GroupId some = groups.empty() || below(8) == 0 ? static_cast<GroupId>(below(9))
                                                         : groups[below(groups.size())].id;
    const QString name = below(2) == 0 ? "a" : "b";
    switch (below(10)) {
      case 0:
      case 1:
        return group_selection(document_);
      case 2:
        return ungroup_selection(document_);
      case 3:
        return below(3) == 0 ? delete_group(document_, some) : dissolve_group(document_, some);
      case 4:
        return move_selection_to_group(document_, some);
      case 5:
        return select_group(document_, some);
      case 6:
        return rename_group(document_, some, name);
      case 7:
        return nest_group(document_, some, groups.empty() ? 0 : groups[below(groups.size())].id);
      default:
        return change_group(document_, some, "Change %1", no_merge, [this](Group& g) {
          g.visible = below(3) > 0;
          g.locked = below(3) == 0;
          g.density_factor = number();
          g.albedo_offset = below(2) == 0 ? glm::dvec3(0.0) : glm::dvec3(-0.1);
        });
    }
  }
  void playback() {
    std::optional<Playback> playback;
    const int first = static_cast<int>(below(5));
    if (below(3) > 0) playback = {first, first + static_cast<int>(below(9)), below(2) == 0};
    set_scene_part(document_, playback, "Set what is played");
  }
  QString a_camera() {
    const std::vector<NamedCamera>& others = document_.scene().cameras;
    const std::size_t k = below(others.size() + 1);
    return QString::fromStdString(k < others.size() ? others[k].name
                                                    : document_.scene().camera_name);
  }
  void cameras() {
    switch (below(5)) {
      case 0:
        return use_camera(document_, a_camera());
      case 1:
        return rename_camera(document_, a_camera(), QString::number(below(5)));
      case 2:
        return delete_camera(document_, a_camera());
      case 3: {
        Camera camera = document_.scene().camera;
        camera = below(2) == 0 ? orthographic(camera) : perspective(camera);
        camera.roll = number();
        return set_camera(document_, a_camera(), camera, "roll", no_merge);
      }
      default:
        add_camera(document_, {.eye = point() + glm::dvec3(3.0)});
    }
  }
  void output() {
    if (below(2) == 0) {
      return set_film(document_, {static_cast<int>(1 + below(3)), static_cast<int>(1 + below(3))});
    }
    change_output(document_, "Set output", no_merge, [this](Output& output) {
      output.paths = below(2) == 0 ? std::nullopt : std::optional(static_cast<int>(below(3)) + 1);
      output.denoise = below(2) == 0 ? Denoising::none : Denoising::solved;
      output.layers.depth = below(2) == 0;
    });
  }
  void key() {
    document_.set_time(static_cast<double>(below(4)));
    const std::vector<Track> rows = tracks(document_.scene());
    const Track& row = rows[below(rows.size())];
    const auto moment = [this] { return static_cast<double>(below(4)); };
    const std::vector times{moment(), moment()};
    std::vector<TrackKeys> keys{{row, times}};
    if (const Track& other = rows[below(rows.size())]; other != row) keys.push_back({other, times});
    switch (below(9)) {
      case 0:
        return delete_keys(document_, keys);
      case 1: {
        const std::vector<ScenePart> before = parts_of(document_.scene(), keys);
        const MergeId merge_id = new_merge_id();
        for (int step = 0; step < 2; ++step) {
          std::vector<TrackMoves> moves;
          for (const TrackKeys& track : keys) {
            moves.push_back({track.track, {{times[0], moment()}, {times[1], moment()}}});
          }
          move_keys(document_, before, moves, merge_id);
        }
        return;
      }
      case 2:
        return set_interpolation(document_, keys, static_cast<Interpolation>(below(3)));
      case 3:
        return set_tangents(document_, keys, static_cast<Tangents>(below(3)));
      case 4:
        return align_keys(document_, keys);
      case 5:
        return curve_key(row, times);
      case 6: {
        const CopiedKeys copied = copy_keys(document_.scene(), keys);
        paste_keys(document_, copied, std::span(&rows[below(rows.size())], below(2)));
        return;
      }
      default:
        return set_keys(document_, row);
    }
  }
  // Edits one of the numbers of a row, in steps of one gesture.
  void curve_key(const Track& row, const std::vector<double>& times) {
    const std::vector<Curve> curves = curves_of(document_.scene(), row);
    if (curves.empty()) return;
    const Curve& curve = curves[below(curves.size())];
    const std::vector<ScenePart> before =
        parts_of(document_.scene(), std::vector{TrackKeys{row, times}});
    const MergeId merge_id = new_merge_id();
    const bool turns = below(2) == 0;
    for (int step = 0; step < 2; ++step) {
      if (turns) {
        const auto side = static_cast<TangentSide>(below(2));
        set_tangent(document_, row, curve, {times[0], side, 9.0 * number() - 4.0, below(3) == 0},
                    merge_id);
      } else {
        const double shift = below(3);
        const std::vector<CurveKeyMove> moves{{row, curve, {times[0], times[0] + shift}, number()},
                                              {row, curve, {times[1], times[1] + shift}, number()}};
        move_curve_keys(document_, before, moves, merge_id);
      }
    }
  }
  void hide_or_lock() {
    if (below(2) == 0) {
      document_.hide(below(2) == 0 ? some() : std::vector<GaussianId>());
    } else {
      document_.lock(below(2) == 0 ? some() : std::vector<GaussianId>());
    }
  }
  void go_back() {
    for (std::size_t k = below(3); k > 0; --k) document_.undo_stack().undo();
    for (std::size_t k = below(2); k > 0; --k) document_.undo_stack().redo();
  }

  Document& document_;
  std::mt19937 random_;
};

// With an unknown key of each object that hands may change, move, copy, remove.
inline SceneDocument starting_document() {
  Scene scene = small_scene();
  static const auto triangle = to_mesh({.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                        .normals = {3, {0, 0, 1}},
                                        .triangles = {{0, 1, 2}}});
  scene.surfaces.emplace_back();
  scene.surfaces[0].mesh_file = BRUME_RESOURCES "/meshes/bunny.obj";
  scene.surfaces[0].mesh = triangle;
  scene.emitters.emplace_back();
  SceneExtras extras;
  int count = 0;
  const auto text = [&count] { return "{\"later\": " + std::to_string(++count) + "}"; };
  for (Light& light : scene.lights) extras.unknown_keys.add(light.id, "", text());
  extras.unknown_keys.add(scene.surfaces[0].id, "", text());
  extras.unknown_keys.add(scene.surfaces[0].id, "material", text());
  extras.unknown_keys.add(scene.emitters[0].id, "", text());
  for (const GaussianId id : scene.medium.ids()) extras.unknown_keys.add_of_gaussian(id, text());
  return {std::move(scene), std::move(extras)};
}

}  // namespace brume
