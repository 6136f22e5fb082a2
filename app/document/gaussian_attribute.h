#pragma once

#include <QString>
#include <array>

#include "brume/gaussian.h"
#include "core/number_domain.h"

namespace brume {

// The attributes of a Gaussian that are numbers, in display order. Its albedo is the luminance; a
// new one is grey. Its emission is that of the brightest channel; it keeps its colour. Its radius
// is the greatest; a new one scales all. Its rotation is in Euler angles [degrees], of a ball 0.
// Its elongation, the greatest radius over the smallest, cannot be set.
enum class GaussianAttribute {
  center_x,
  center_y,
  center_z,
  radius,
  density,
  albedo,
  emission,
  radius_x,
  radius_y,
  radius_z,
  rotation_x,
  rotation_y,
  rotation_z,
  elongation
};

inline constexpr std::array gaussian_attributes{
    GaussianAttribute::center_x,   GaussianAttribute::center_y,   GaussianAttribute::center_z,
    GaussianAttribute::radius,     GaussianAttribute::density,    GaussianAttribute::albedo,
    GaussianAttribute::emission,   GaussianAttribute::radius_x,   GaussianAttribute::radius_y,
    GaussianAttribute::radius_z,   GaussianAttribute::rotation_x, GaussianAttribute::rotation_y,
    GaussianAttribute::rotation_z, GaussianAttribute::elongation};
// The first of them, which are all of a ball without optics of its own.
inline constexpr std::size_t ball_attributes = 5;

// Whether it is one of the last, of which all balls have the same, or all those of one radius.
bool is_of_shape(GaussianAttribute field);

QString attribute_title(GaussianAttribute field);   // "Centre X"
QString attribute_name(GaussianAttribute field);    // "centre x", for use inside a sentence
const char* attribute_id(GaussianAttribute field);  // "center_x", in every language

// The domain in files, so everything edited can be loaded again.
const NumberDomain& attribute_domain(GaussianAttribute field);

// Without an albedo of its own it has that of Document::effective_gaussian().
double attribute_value(const Gaussian& gaussian, GaussianAttribute field);
void set_attribute_value(Gaussian& gaussian, GaussianAttribute field, double value);

// The brightest channel; and the colour, whose brightest channel is 1, white if it is black.
double emission_strength(const glm::dvec3& emission);
glm::dvec3 emission_color(const glm::dvec3& emission);

// The mean extinction over the density, the scattering: channels count by their luminance. A
// channel of the albedo below 0.01 counts as 0.01, or black ones would decide alone.
double extinction_over_density(const glm::dvec3& albedo);

// Clamps all attributes to their domains, and the smallest radius to that of lengths.
Gaussian within_domains(const Gaussian& gaussian);

// Message for a value outside the domain; empty if valid.
QString attribute_problem(GaussianAttribute field, double value);

// Parses a number or arithmetic expression (see evaluate()); NaN otherwise.
double parse_number(const QString& text);

// "1 Gaussian" for one, "3 Gaussians" for three.
QString gaussians_text(std::size_t count);

}  // namespace brume
