#include "app/commands/gaussians/clipboard.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/text/number_text.h"
#include "brume/error.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/gaussians/gaussian_csv.h"
#include "core/math/max_component.h"
#include "core/number_domain.h"

namespace brume {
namespace {

const QString heading = "x\ty\tz\tradius\tdensity";

glm::dvec3 center_of(const std::vector<Gaussian>& gaussians) {
  glm::dvec3 low = gaussians.front().center;
  glm::dvec3 high = low;
  for (const Gaussian& gaussian : gaussians) {
    low = glm::min(low, gaussian.center);
    high = glm::max(high, gaussian.center);
  }
  return 0.5 * (low + high);
}

// Exact, where the columns of files round radii.
std::array<double, 7> stretch_and_rotation(const GaussianShape& shape) {
  const glm::dvec3& s = shape.stretch;
  const glm::dquat& q = shape.rotation;
  return {s.x, s.y, s.z, q.w, q.x, q.y, q.z};
}

std::optional<GaussianShape> shape_of(const std::array<double, 7>& values) {
  const GaussianShape shape{{values[0], values[1], values[2]},
                            {values[3], values[4], values[5], values[6]}};
  for (int k = 0; k < 3; ++k) {
    if (!domain::stretch.contains(shape.stretch[k])) return std::nullopt;
  }
  const bool is_unit = std::abs(glm::length(shape.rotation) - 1.0) < 1e-12;
  if (!is_unit || max_component(shape.stretch) != 1.0) return std::nullopt;
  return shape;
}

}  // namespace

QString gaussians_to_text(const std::vector<Gaussian>& gaussians) {
  QString text = heading + '\n';
  for (const Gaussian& gaussian : gaussians) {
    QStringList numbers;
    const auto add = [&numbers](double value) { numbers << exact_number_text(value); };
    for (std::size_t k = 0; k < ball_attributes; ++k) {
      add(attribute_value(gaussian, gaussian_attributes[k]));
    }
    const bool is_ball = gaussian.is_ball();
    if (!is_ball || gaussian.optics != GaussianOptics()) {
      std::ranges::for_each(gaussian_columns::optics_values(gaussian.optics), add);
    }
    if (!is_ball) std::ranges::for_each(stretch_and_rotation(gaussian.shape), add);
    text += numbers.join('\t') + '\n';
  }
  return text;
}

namespace {

// Reads what gaussians_to_text() makes; nullopt for other text.
std::optional<std::vector<Gaussian>> copied_gaussians(const QString& text) {
  QStringList lines = text.split(QRegularExpression("[\r\n]+"), Qt::SkipEmptyParts);
  if (lines.isEmpty() || lines.takeFirst() != heading) return std::nullopt;
  std::vector<Gaussian> gaussians;
  for (const QString& line : lines) {
    const QStringList numbers = line.split('\t');
    std::vector<double> values;
    for (const QString& number : numbers) values.push_back(parse_number(number));
    std::array<double, gaussian_columns::optics_names.size()> optics{};
    std::array<double, 7> shape{};
    constexpr std::size_t with_optics = ball_attributes + optics.size();
    constexpr std::size_t with_shape = with_optics + shape.size();
    if (values.size() != ball_attributes && values.size() != with_optics &&
        values.size() != with_shape) {
      return std::nullopt;
    }
    Gaussian& gaussian = gaussians.emplace_back();
    for (std::size_t k = 0; k < ball_attributes; ++k) {
      if (!attribute_problem(gaussian_attributes[k], values[k]).isEmpty()) return std::nullopt;
      set_attribute_value(gaussian, gaussian_attributes[k], values[k]);
    }
    if (values.size() == ball_attributes) continue;
    std::copy_n(values.begin() + ball_attributes, optics.size(), optics.begin());
    bool is_allowed = true;
    gaussian.optics = gaussian_columns::optics_of(
        optics, [&](std::size_t, const std::string&) { is_allowed = false; });
    if (!is_allowed) return std::nullopt;
    if (values.size() == with_optics) continue;
    std::copy_n(values.begin() + with_optics, shape.size(), shape.begin());
    const auto allowed = shape_of(shape);
    if (!allowed) return std::nullopt;
    gaussian.shape = *allowed;
  }
  return gaussians;
}

// The heading that text lacks if it begins with a row of numbers; else empty.
QString missing_heading(const QString& text) {
  const QString first = text.trimmed().section(QRegularExpression("[\r\n]"), 0, 0);
  QChar separator = ' ';
  for (const QChar sign : {'\t', ';', ','}) {
    if (separator == ' ' && first.contains(sign)) separator = sign;
  }
  const QStringList cells = first.split(separator, Qt::SkipEmptyParts);
  const bool are_numbers = std::ranges::none_of(
      cells, [](const QString& cell) { return std::isnan(parse_number(cell)); });
  if (cells.isEmpty() || !are_numbers) return {};
  return QString(heading).replace('\t', separator) + '\n';
}

}  // namespace

std::vector<Gaussian> gaussians_from_text(const QString& text) {
  if (const auto copied = copied_gaussians(text)) return *copied;
  const QString added = missing_heading(text);
  return parse_gaussians_csv(added.isEmpty() ? "clipboard" : "clipboard below an added heading",
                             (added + text).toStdString());
}

void copy_selection(const Document& document) {
  if (document.selection().empty()) return;
  QGuiApplication::clipboard()->setText(
      gaussians_to_text(document.gaussians(document.selection())));
}

void cut_selection(Document& document) {
  copy_selection(document);
  delete_selection(document, undo_text("Cut"));
}

double clipboard_radius() {
  std::vector<Gaussian> gaussians;
  try {
    gaussians = gaussians_from_text(QGuiApplication::clipboard()->text());
  } catch (const InputError&) {  // told when it is pasted
  }
  if (gaussians.empty()) return 0.0;
  const glm::dvec3 middle = center_of(gaussians);
  double radius = 0.0;
  for (const Gaussian& gaussian : gaussians) {
    radius = std::max(radius, glm::distance(gaussian.center, middle) + gaussian.radius);
  }
  return radius;
}

void paste_gaussians(Document& document, std::optional<glm::dvec3> middle) {
  std::vector<Gaussian> gaussians;
  try {
    gaussians = gaussians_from_text(QGuiApplication::clipboard()->text());
  } catch (const InputError& error) {
    Q_EMIT document.refused(undo_text("Nothing to paste: %1").arg(error.what()));
    return;
  }
  if (gaussians.empty()) return;
  if (const QString problem = adding_problem(document); !problem.isEmpty()) {
    Q_EMIT document.refused(problem);
    return;
  }
  for (Gaussian& gaussian : gaussians) gaussian.group = group_of_new(document);
  if (middle) {
    const glm::dvec3 shift = *middle - center_of(gaussians);
    for (Gaussian& gaussian : gaussians) gaussian.center += shift;
  }
  add_gaussians(document, gaussians, undo_text("Paste"));
}

void duplicate_selection(Document& document, const glm::dvec3& shift) {
  std::vector<Gaussian> gaussians = document.gaussians(document.selection());
  for (Gaussian& gaussian : gaussians) gaussian.center += shift;
  add_gaussians(document, gaussians, undo_text("Duplicate"));
}

}  // namespace brume
