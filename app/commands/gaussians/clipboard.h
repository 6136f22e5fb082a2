#pragma once

#include <QString>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

class Document;

// Gaussians as clipboard text, exchangeable with other windows and spreadsheets: a header line,
// then x y z radius density of each, where it has them its optics, and those and its shape.
// Lossless.
QString gaussians_to_text(const std::vector<Gaussian>& gaussians);
// The same, or a table as files have it (core/io/gaussians/gaussian_csv), which may lack its
// heading if its columns are those of a ball in this order. Throws InputError.
std::vector<Gaussian> gaussians_from_text(const QString& text);

void copy_selection(const Document& document);
void cut_selection(Document& document);
// Bounding radius of the clipboard's Gaussians [u]; 0 if none.
double clipboard_radius();
// Into the active group; other text and numbers outside their domain are refused. `center`: target
// center of the pasted Gaussians; nullopt: their original place.
void paste_gaussians(Document& document, std::optional<glm::dvec3> center);
void duplicate_selection(Document& document, const glm::dvec3& shift);

}  // namespace brume
