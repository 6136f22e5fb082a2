#pragma once

namespace brume {

class Document;
class View;
struct Camera;

// Does nothing once anything else than the light of File > New may light the scene. Otherwise that
// light moves outside the scene's contents, brighter by the square of the distance, and the camera
// frames them unless it is no longer the one of File > New or the view has moved. Without this,
// most meshes hold that light and that camera inside. Steps of the caller's macro.
// `framed`: the view where this last left it; undo does not move views.
void light_new_scene(Document& document, View& view, Camera& framed);

}  // namespace brume
