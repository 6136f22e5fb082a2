// Time and error of methods on a scene, for light that is scattered once: measure SCENE.brume
#include <brume/files.h>
#include <brume/render.h>

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const brume::Scene scene = brume::load_scene(argv[1]);
  brume::SceneRenderer renderer;
  brume::RenderRequest request{.film = brume::Film{160, 120},
                               .error = brume::ErrorMeasurement::full,
                               .scattering = brume::Scattering::single};
  using Method = brume::AirlightMethod;
  for (const Method method : {Method::paper, Method::sliced, Method::auto_}) {
    request.airlight = method;
    const brume::Frame frame = *renderer.render(scene, request);
    std::cout << frame.statistics.airlight << ": " << frame.statistics.frame_milliseconds << " ms, "
              << 100.0 * frame.error->rel_rmse << "% (" << 100.0 * frame.error->low << " to "
              << 100.0 * frame.error->high << ")\n";
  }
}
