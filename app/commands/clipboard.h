#pragma once

#include <QString>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

class Document;

// Gaussians as text, which is what lies on the clipboard, so that they go from window to window and
// into tables: a line of names, then x y z radius density of each, with all digits.
QString gaussians_to_text(const std::vector<Gaussian>& gaussians);
// None if it is not such a text, or if a number is outside its domain.
std::vector<Gaussian> gaussians_from_text(const QString& text);

void copy_selection(const Document& document);
void cut_selection(Document& document);
// Of a ball around what would be pasted [u]; 0 if that is nothing.
double clipboard_radius();
// `middle` is where the middle of the pasted ones goes; nullopt: to where they were.
void paste_gaussians(Document& document, std::optional<glm::dvec3> middle);
void duplicate_selection(Document& document, const glm::dvec3& shift);

}  // namespace brume
