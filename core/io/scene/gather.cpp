#include "core/io/scene/gather.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <vector>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/disk/temporary_files.h"
#include "core/io/frame_pattern.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

struct Stopped {};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// The deepest folder that holds both a folder and a file; both absolute.
fs::path common_folder(const fs::path& folder, const fs::path& file) {
  const auto [end, unused] =
      std::mismatch(folder.begin(), folder.end(), file.begin(), std::prev(file.end()));
  fs::path common;
  for (auto part = folder.begin(); part != end; ++part) common /= *part;
  return common;
}

// The copies of one scene's files.
class FileCopies {
 public:
  FileCopies(fs::path folder, const std::stop_token& stop)
      : folder_(std::move(folder)), stop_(stop) {}

  // Makes `file` its copy.
  void add(fs::path& file) {
    if (file.empty()) return;
    const auto [copy, is_new] = copies_.try_emplace(file);
    if (is_new) {
      copy->second = folder_ / free_name(file.stem().string(), file.extension().string());
      make(file, copy->second);
    }
    file = copy->second;
  }

  // The same for all files of an imported scene: in a folder of its own those that refer to each
  // other by relative paths stand to each other as they did, and others beside the scene, where its
  // reader looks for them.
  void add(Surface& surface) {
    const auto [copy, is_new] = copies_.try_emplace(surface.mesh_file);
    if (is_new) {
      const ImportedScene& scene = *surface.imported;
      const auto is_beside = [&scene](const fs::path& file) {
        return std::ranges::count(scene.absolute_files, file) > 0;
      };
      fs::path root = scene.files.front().parent_path();
      for (const fs::path& file : scene.files) {
        if (!is_beside(file)) root = common_folder(root, file);
      }
      const fs::path folder = folder_ / free_name(surface.mesh_file.stem().string(), "");
      copy->second = folder / surface.mesh_file.lexically_relative(root);
      std::map<fs::path, fs::path> files;  // by copy
      for (const fs::path& file : scene.files) {
        const fs::path to = is_beside(file) ? copy->second.parent_path() / file.filename()
                                            : folder / file.lexically_relative(root);
        const auto [other, is_free] = files.try_emplace(to, file);
        if (!is_free) refuse_two_of_a_name(surface.mesh_file, file, other->second);
        make(file, to);
      }
    }
    surface.mesh_file = copy->second;
  }

  // The same for all files of a sequence, which get a folder of their own.
  void add(MediumSequence& sequence) {
    const auto files = FramePattern::parse(sequence.file.string());
    if (!files) throw InputError(sequence.file, "", "is not a sequence");
    const fs::path folder = folder_ / free_name("sequence", "");
    const fs::path copy = folder / sequence.file.filename();
    const auto copies = FramePattern::parse(copy.string());
    if (!copies) throw InputError(copy, "", "is not a valid sequence name");
    fs::create_directories(folder);
    for (int frame = sequence.first; frame <= sequence.last; ++frame) {
      make(files->file_of(frame), copies->file_of(frame));
    }
    sequence.file = copy;
  }

 private:
  std::string free_name(const std::string& stem, const std::string& extension) {
    std::string name = stem + extension;
    for (int k = 2; !names_.insert(lower_case(name)).second; ++k) {
      name = stem + "_" + std::to_string(k) + extension;
    }
    return name;
  }

  [[noreturn]] static void refuse_two_of_a_name(const fs::path& scene, const fs::path& file,
                                                const fs::path& other) {
    throw InputError(scene, "",
                     "refers to " + file.string() + " and to " + other.string() +
                         ", which have one name; allowed: other names where a path is absolute");
  }

  void make(const fs::path& file, const fs::path& copy) {
    std::error_code error;
    fs::create_directories(copy.parent_path(), error);
    if (error) throw InputError(copy, "", "cannot be created: " + error.message());
    regular_file_size(file);
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file, "", std::string("cannot be opened: ") + std::strerror(errno));
    write_atomically(copy, [&](std::ostream& out) {
      std::vector<char> bytes(std::size_t{1} << 20);
      do {
        if (stop_.stop_requested()) throw Stopped();
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.write(bytes.data(), in.gcount());
      } while (in);
    });
    if (in.bad()) throw InputError(file, "", "cannot be read");
  }

  fs::path folder_;
  const std::stop_token& stop_;
  std::map<fs::path, fs::path> copies_;
  std::set<std::string> names_;  // in lower case
};

// A new folder beside `folder`, which goes unless it is renamed.
class TemporaryTarget {
 public:
  explicit TemporaryTarget(const fs::path& folder)
      : staging_(folder.has_parent_path() ? folder.parent_path() : fs::path("."), folder) {}

  [[nodiscard]] const fs::path& path() const { return staging_.path(); }

  // All of it is on the disk before it has its name.
  void become(const fs::path& folder) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path())) {
      if (entry.is_directory()) flush_folder(entry.path());
    }
    flush_folder(path());
    fs::rename(path(), folder, error);
    if (error) throw InputError(folder, "", "cannot be created: " + error.message());
    flush_folder(path().parent_path());
  }

 private:
  StagingFolder staging_;
};

// A name without a slash at its end.
fs::path cleaned(const fs::path& folder) {
  const fs::path normal = folder.lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

void write_copies(const SceneDocument& document, const fs::path& folder, const std::string& name,
                  const std::stop_token& stop) {
  FileCopies copies(folder / "files", stop);
  SceneDocument gathered = document;
  visit_files(gathered.scene, [&copies](auto& reference) { copies.add(reference); });
  if (refers_to_medium_file(document)) {
    auto loaded = std::make_shared<MediumFile>(*document.extras.medium_file);
    copies.add(loaded->file);
    gathered.extras.medium_file = std::move(loaded);
  }
  fs::path& output = gathered.scene.output.file;
  if (!output.empty()) output = folder / output.filename();
  save_document(gathered, folder / (name + ".brume"));
}

}  // namespace

bool gather_scene(const SceneDocument& document, const fs::path& to, const std::string& name,
                  const std::stop_token& stop) {
  const fs::path folder = cleaned(to);
  std::error_code error;
  if (fs::exists(folder, error) &&
      !(fs::is_directory(folder, error) && fs::is_empty(folder, error))) {
    throw InputError(folder, "", "already exists; allowed: a new or an empty folder");
  }
  try {
    TemporaryTarget target(folder);
    try {
      write_copies(document, target.path(), name, stop);
    } catch (const InputError& mistake) {  // which may name the temporary folder
      throw InputError(folder, "", std::string("cannot be created: ") + mistake.what());
    }
    target.become(folder);
  } catch (const Stopped&) {
    return false;
  }
  return true;
}

}  // namespace brume
