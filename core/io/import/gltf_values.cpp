#include "core/io/import/gltf_values.h"

#include <limits>

namespace brume {
namespace {

constexpr double max_double = std::numeric_limits<double>::max();
constexpr NumberDomain any_number{-max_double, max_double, "a number"};

double nearest(GltfFile& file, const JsonPath& path, const NumberDomain& domain, double value) {
  if (domain.contains(value)) return value;
  const double taken = domain.nearest(value);
  file.context().warn(path, domain.refusal(value) + "; taken as " + quoted_text(taken));
  return taken;
}

}  // namespace

double nearest_number(GltfFile& file, JsonObject& object, std::string_view key,
                      const NumberDomain& domain, double fallback) {
  return nearest(file, object.path_of(key), domain, object.number(key, any_number, fallback));
}

std::vector<double> nearest_numbers(GltfFile& file, JsonObject& object, std::string_view key,
                                    const NumberDomain& domain, std::vector<double> fallback) {
  const Json* value = object.find(key);
  if (value == nullptr) return fallback;
  const JsonPath path = object.path_of(key);
  std::vector<double> numbers =
      read_numbers(file.context(), *value, path, fallback.size(), any_number);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = nearest(file, path.element(i), domain, numbers[i]);
  }
  return numbers;
}

glm::dvec3 nearest_vector(GltfFile& file, JsonObject& object, std::string_view key,
                          const NumberDomain& domain, const glm::dvec3& fallback) {
  const auto v = nearest_numbers(file, object, key, domain, {fallback.x, fallback.y, fallback.z});
  return {v[0], v[1], v[2]};
}

}  // namespace brume
