#include "render/layers/surface_layers.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/scene/camera_rays.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/placement.h"
#include "render/layers/cryptomatte.h"
#include "render/layers/layer_channels.h"
#include "render/samples/pixel_filter.h"
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"

namespace brume {
namespace {

std::string own_name(const Surface& surface) {
  if (!surface.name.empty()) return surface.name;
  if (!surface.primitive) return surface.mesh_file.filename().string();
  constexpr std::array shapes{"Plane", "Box", "Sphere", "Cylinder"};
  return shapes.at(static_cast<std::size_t>(surface.primitive->shape));
}

// The name, numbered where something else has it already: "Box (2)".
std::string unique_name(const std::string& name, std::map<std::string, int>& counts) {
  const int count = ++counts[name];
  return count == 1 ? name : name + " (" + std::to_string(count) + ")";
}

glm::vec3 albedo_of(const SurfacePoint& point) {
  const Material& material = point.surface->material;
  if (point.ggx) return glm::vec3(point.ggx->diffuse + point.ggx->f0);
  return material.type == Material::Type::measured ? glm::vec3(0.0f)
                                                   : glm::vec3(material.reflectance);
}

// The object of a list that has this id; in lists without ids that in the same place, else itself.
template <class T>
const T* in_next(const T& object, std::size_t index, const std::vector<T>& next) {
  const auto same = std::ranges::find_if(
      next, [&](const T& other) { return object.id != 0 && other.id == object.id; });
  if (same != next.end()) return &*same;
  return object.id == 0 && index < next.size() ? &next[index] : &object;
}

// Where the points of a frame are a frame later.
class MotionVectors {
 public:
  MotionVectors(const Scene& now, const Scene& next, const Camera& camera, const Film& film)
      : now_(now), rays_(camera, film) {
    for (std::size_t i = 0; i < now.surfaces.size(); ++i) {
      next_.push_back(in_next(now.surfaces[i], i, next.surfaces));
    }
    for (std::size_t i = 0; i < now.lights.size(); ++i) {
      next_lights_.push_back(in_next(now.lights[i], i, next.lights));
    }
  }

  // The place of a point of a surface in the next frame.
  [[nodiscard]] glm::dvec3 moved(const SurfaceHit& hit, const glm::dvec3& point) const {
    const auto surface = static_cast<std::size_t>(hit.surface);
    const Surface& next = *next_[surface];
    if (hit.copy >= placement_count(next)) return point;
    return placement_of(next, hit.copy)
        .point_to_world(placement_of(now_.surfaces[surface], hit.copy).point_to_mesh(point));
  }
  // The same of a light.
  [[nodiscard]] glm::dvec3 moved(const LightShape& shape, const glm::dvec3& point) const {
    const Light& next = *next_lights_[shape.light];
    const auto area = area_of(next);
    return area && area->index() == shape.area.index()
               ? moved_on_shape(shape.area, shape.center, *area, next.position, point)
               : point;
  }
  // To the right and up from a position on the whole film; 0 for what comes to be behind the
  // camera.
  [[nodiscard]] glm::vec2 on_film(const glm::dvec3& point, const glm::dvec2& start) const {
    const glm::dvec3 place = rays_.project_on_whole(point);
    if (!(place.z > 0.0)) return glm::vec2(0.0f);
    return {place.x - start.x, start.y - place.y};
  }
  // A point that the ray through a position on the whole film passes, unless it moves.
  [[nodiscard]] glm::dvec3 start(const glm::dvec2& position) const {
    return rays_.eye() + rays_.whole_offset(position);
  }

 private:
  const Scene& now_;
  CameraRays rays_;
  std::vector<const Surface*> next_;
  std::vector<const Light*> next_lights_;
};

// The layers as one ray per pixel sees them, through panes that are less than half opaque.
class PointLayers {
 public:
  PointLayers(const Scene& scene, const RayCaster& ray_caster, const LightShapes& light_shapes,
              const OutputLayers& layers, const MotionVectors* motion, ImageLayers& image)
      : scene_(scene), ray_caster_(ray_caster), light_shapes_(light_shapes), motion_(motion) {
    if (layers.normal) normal_.emplace(image, "normal", "XYZ");
    if (layers.albedo) albedo_.emplace(image, "albedo");
    if (layers.position) position_.emplace(image, "position", "XYZ");
    if (!motion) return;
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    u_ = &image.channels["forward.u"];
    v_ = &image.channels["forward.v"];
    u_->assign(pixels, 0.0f);
    v_->assign(pixels, 0.0f);
  }

  void set(std::size_t pixel, const glm::dvec2& place, const glm::dvec3& eye,
           const glm::dvec3& direction, const SurfaceHit& hit) const {
    if (!hit) {
      if (motion_) set_motion(pixel, motion_->on_film(motion_->start(place) + direction, place));
      return;
    }
    if (hit.is_light()) {
      set_light(pixel, place, eye + hit.distance * direction, direction, light_shapes_.of(hit));
      return;
    }
    const SurfacePoint point = ray_caster_.point(hit, eye, direction, scene_.surfaces);
    if (normal_) normal_->set(pixel, glm::vec3(point.normal));
    if (albedo_) albedo_->set(pixel, albedo_of(point));
    if (position_) position_->set(pixel, glm::vec3(point.position));
    if (!motion_) return;
    set_motion(pixel, motion_->on_film(motion_->moved(hit, point.position), place));
  }

 private:
  // Lights reflect nothing.
  void set_light(std::size_t pixel, const glm::dvec2& place, const glm::dvec3& point,
                 const glm::dvec3& direction, const LightShape& shape) const {
    if (normal_) normal_->set(pixel, glm::vec3(shape_normal(shape, point, direction)));
    if (position_) position_->set(pixel, glm::vec3(point));
    if (motion_) set_motion(pixel, motion_->on_film(motion_->moved(shape, point), place));
  }
  void set_motion(std::size_t pixel, const glm::vec2& motion) const {
    (*u_)[pixel] = motion.x;
    (*v_)[pixel] = motion.y;
  }

  const Scene& scene_;
  const RayCaster& ray_caster_;
  const LightShapes& light_shapes_;
  const MotionVectors* motion_;
  std::optional<LayerChannels> normal_, albedo_, position_;
  std::vector<float>*u_ = nullptr, *v_ = nullptr;
};

// First hits of the rays of a film's rows.
class RowHits {
 public:
  RowHits(const RayCaster& ray_caster, const LightShapes& light_shapes, const CameraRays& rays,
          int width)
      : ray_caster_(ray_caster),
        light_shapes_(light_shapes),
        rays_(rays),
        // Whole packets of rays of the whole film: whether a ray hits an edge may depend on those
        // beside it.
        first_(rays.first_pixel().x / together * together),
        directions_(static_cast<std::size_t>(
            std::min((rays.first_pixel().x + width + together - 1) / together * together,
                     rays.whole_size().x) -
            first_)),
        offsets_(rays.is_parallel() ? directions_.size() : 0),
        hits_(directions_.size()) {}

  // Finds the hits of a row, shifted from the pixels' centers.
  void find(int y, const glm::dvec2& shift) {
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const glm::ivec2 pixel(first_ + static_cast<int>(i), rays_.first_pixel().y + y);
      directions_[i] = rays_.whole_direction(glm::dvec2(pixel) + 0.5 + shift);
      if (!offsets_.empty()) offsets_[i] = rays_.whole_offset(glm::dvec2(pixel) + 0.5 + shift);
    }
    ray_caster_.first_hits(rays_, directions_, offsets_, hits_);
    light_shapes_.meet(rays_.eye(), directions_, offsets_, hits_);
  }
  [[nodiscard]] const glm::dvec3& direction(int x) const { return directions_[index(x)]; }
  // The first that is more than half opaque.
  [[nodiscard]] SurfaceHit solid_hit(int x) const {
    SurfaceHit hit = hits_[index(x)];
    while (hit && ray_caster_.has_panes() && !(ray_caster_.pane(hit, 0.0).opaque > 0.5)) {
      hit = behind(x, hit);
    }
    return hit;
  }
  // Calls visit(hit, its share of the view) for all that a ray sees.
  void each_seen(int x, auto&& visit) const {
    double share = 1.0;
    for (SurfaceHit hit = hits_[index(x)]; hit && share > min_share;) {
      const double opaque = ray_caster_.has_panes() ? ray_caster_.pane(hit, 0.0).opaque : 1.0;
      visit(hit, static_cast<float>(share * opaque));
      share *= 1.0 - opaque;
      if (share > min_share) hit = behind(x, hit);
    }
  }

 private:
  static constexpr int together = 64;
  static constexpr double min_share = 1e-3;  // of what is looked for behind panes
  [[nodiscard]] SurfaceHit behind(int x, const SurfaceHit& hit) const {
    const glm::dvec3 offset = offsets_.empty() ? glm::dvec3(0.0) : offsets_[index(x)];
    const glm::dvec3 start = rays_.eye() + offset;
    SurfaceHit next = ray_caster_.next_hit(start, directions_[index(x)], hit);
    light_shapes_.meet(start, directions_[index(x)], next);
    return next;
  }
  [[nodiscard]] std::size_t index(int x) const {
    return static_cast<std::size_t>(rays_.first_pixel().x + x - first_);
  }

  const RayCaster& ray_caster_;
  const LightShapes& light_shapes_;
  const CameraRays& rays_;
  int first_;  // pixel on the whole film
  std::vector<glm::dvec3> directions_;
  std::vector<glm::dvec3> offsets_;  // of parallel rays
  std::vector<SurfaceHit> hits_;
};

}  // namespace

Mattes object_mattes(const std::vector<Surface>& surfaces, std::span<const Light> lights) {
  Mattes mattes;
  std::map<std::string, int> counts;
  std::map<std::pair<ObjectId, std::string>, std::uint32_t> nodes;
  for (const Surface& surface : surfaces) {
    const std::string name = own_name(surface);
    const auto index = static_cast<std::uint32_t>(mattes.names.size());
    const auto [node, is_new] = nodes.try_emplace({surface.id, name}, index);
    if (!is_new && surface.id != 0) {
      mattes.of_surface.push_back(node->second);
      continue;
    }
    mattes.of_surface.push_back(index);
    mattes.names.push_back(unique_name(name, counts));
  }
  for (const Light& light : lights) {
    if (!is_seen(light)) continue;
    mattes.of_light.push_back(static_cast<std::uint32_t>(mattes.names.size()));
    const std::string name = light.name.empty() ? kind_info(light).title : light.name;
    mattes.names.push_back(unique_name(name, counts));
  }
  return mattes;
}

Mattes material_mattes(const std::vector<Surface>& surfaces) {
  constexpr std::array types{"diffuse", "phong", "measured", "metallic_roughness"};
  Mattes mattes;
  std::map<std::string, int> counts;
  std::vector<const Material*> known;
  for (const Surface& surface : surfaces) {
    const Material& material = surface.material;
    const auto same =
        std::ranges::find_if(known, [&](const Material* other) { return *other == material; });
    mattes.of_surface.push_back(static_cast<std::uint32_t>(same - known.begin()));
    if (same != known.end()) continue;
    known.push_back(&material);
    const std::string type = types.at(static_cast<std::size_t>(material.type));
    mattes.names.push_back(unique_name(
        material.name.empty() ? type + " " + std::to_string(known.size()) : material.name, counts));
  }
  return mattes;
}

void add_surface_layers(const Scene& scene, const Camera& camera, const Film& film,
                        const OutputLayers& layers, const Scene* next, const Camera& next_camera,
                        const Job& job, ImageLayers& image) {
  image.width = film.width;
  image.height = film.height;
  const auto width = static_cast<std::size_t>(film.width);
  const auto height = static_cast<std::size_t>(film.height);
  const std::shared_ptr<const RayCaster> shared = shared_ray_caster(scene.surfaces);
  const RayCaster& ray_caster = *shared;
  const LightShapes light_shapes(scene.lights);
  const CameraRays rays(camera, film);
  std::optional<MotionVectors> motion;
  if (layers.motion && next) motion.emplace(scene, *next, next_camera, film);
  const PointLayers points(scene, ray_caster, light_shapes, layers, motion ? &*motion : nullptr,
                           image);
  const Mattes objects = object_mattes(scene.surfaces, scene.lights);
  const Mattes materials = material_mattes(scene.surfaces);
  CoverageFilm object_coverage(layers.objects ? width * height : 0, objects.names);
  CoverageFilm material_coverage(layers.materials ? width * height : 0, materials.names);
  const bool has_mattes = layers.objects || layers.materials;
  const std::vector<glm::dvec2> samples = pixel_samples(matte_samples);
  const float weight = 1.0f / static_cast<float>(samples.size());
  job.parallel_for(height, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    RowHits hits(ray_caster, light_shapes, rays, film.width);
    hits.find(y, glm::dvec2(0.0));
    for (int x = 0; x < film.width; ++x) {
      const glm::dvec2 place = glm::dvec2(rays.first_pixel() + glm::ivec2(x, y)) + 0.5;
      points.set(row * width + static_cast<std::size_t>(x), place,
                 rays.eye() + rays.whole_offset(place), hits.direction(x), hits.solid_hit(x));
    }
    for (std::size_t k = 0; k < samples.size() && has_mattes; ++k) {
      hits.find(y, samples[k]);
      for (int x = 0; x < film.width; ++x) {
        const std::size_t pixel = row * width + static_cast<std::size_t>(x);
        hits.each_seen(x, [&](const SurfaceHit& hit, float share) {
          const float seen = share * weight;
          if (layers.objects) object_coverage.add(pixel, objects.of(hit), seen);
          if (layers.materials && !hit.is_light()) {
            material_coverage.add(pixel, materials.of(hit), seen);
          }
        });
      }
    }
  });
  if (layers.objects) object_coverage.write("CryptoObject", image);
  if (layers.materials) material_coverage.write("CryptoMaterial", image);
}

}  // namespace brume
