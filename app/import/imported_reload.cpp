#include "app/import/imported_reload.h"

#include <exception>
#include <set>

#include "app/document/document.h"
#include "app/document/text/words.h"
#include "app/import/add_imported.h"
#include "core/io/import/imported_scene_file.h"

namespace brume {

ImportedReload::ImportedReload(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&job_, &BackgroundJob::failed, this, &ImportedReload::failed);
}

void ImportedReload::check() {
  using Shared = std::shared_ptr<const ImportedScene>;
  std::set<Shared> scenes;
  for (const Surface& surface : document_.scene().surfaces) {
    if (surface.imported) scenes.insert(surface.imported);
  }
  if (scenes.empty() || job_.is_running()) return;
  job_.start([this, scenes, known = failed_](const Job& job) -> BackgroundJob::Apply {
    for (const Shared& scene : scenes) {
      const std::filesystem::path& file = scene->files.front();
      const auto changed = latest_change(scene->files);
      const auto failure = known.find(file);
      if (changed == scene->changed) continue;
      if (failure != known.end() && failure->second == changed) continue;
      std::vector<std::string> warnings;
      QString problem;
      Shared again;
      try {
        again = read_imported_scene(file, warnings, job.stop);
      } catch (const std::exception& error) {  // it is perhaps being written
        problem = QString::fromUtf8(error.what());
      }
      job_.deliver(job, [this, scene, again, changed, problem, warnings] {
        const QString why = again ? replace_imported(document_, *scene, again) : problem;
        if (!why.isEmpty()) {
          failed_[scene->files.front()] = changed;
          Q_EMIT failed(why);
        }
        if (!warnings.empty()) Q_EMIT warned(lines_of(warnings));
      });
    }
    return {};
  });
}

}  // namespace brume
