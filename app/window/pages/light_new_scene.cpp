#include "app/window/pages/light_new_scene.h"

#include "app/commands/edit_lights.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/view/bounds.h"
#include "app/view/view.h"

namespace brume {

void light_new_scene(Document& document, View& view, Camera& framed) {
  const Scene& scene = document.scene();
  if (scene.environment || scene.lights != new_scene().lights) return;
  const auto sphere = bounding_sphere(scene);
  if (!sphere) return;
  const bool is_new_camera =
      KeyedCamera{scene.camera, scene.camera_keys} == KeyedCamera{new_scene().camera, {}};
  if (is_new_camera && (view.camera() == scene.camera || view.camera() == framed)) {
    view.camera_controller().frame_all();
    framed = view.camera();
    set_scene_part(document, KeyedCamera{framed, {}}, {});
  }
  const Light light = light_outside(sphere->center, sphere->radius, view.camera().eye);
  set_scene_part(document, Lights{light}, {});
}

}  // namespace brume
