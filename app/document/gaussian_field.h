#pragma once

#include <QString>
#include <array>

#include "core/io/number_domain.h"
#include "core/medium/gaussian.h"

namespace brume {

// The numbers of a Gaussian that a user can write, in the order they are shown.
enum class GaussianField { center_x, center_y, center_z, radius, density };

inline constexpr std::array gaussian_fields{GaussianField::center_x, GaussianField::center_y,
                                            GaussianField::center_z, GaussianField::radius,
                                            GaussianField::density};

QString field_title(GaussianField field);  // "Center X"
QString field_name(GaussianField field);   // "center x", for use inside a sentence

// What files may hold, so that everything that was edited can be loaded again.
const NumberDomain& field_domain(GaussianField field);

double field_value(const Gaussian& gaussian, GaussianField field);
void set_field_value(Gaussian& gaussian, GaussianField field, double value);

// The Gaussian with every number brought into the domain of its field.
Gaussian within_domains(const Gaussian& gaussian);

// Why `value` is outside the field's domain, in the user's words; empty if it is fine.
QString field_problem(GaussianField field, double value);

// A number as the user typed it, be it as arithmetic (see evaluate()); not a number (NaN) if the
// text is none.
double parse_number(const QString& text);
// Short, for reading; and exact, for editing.
QString number_text(double value);
QString exact_number_text(double value);

// "Gaussian" for one, "3 Gaussians" for three.
QString gaussians_text(std::size_t count);

}  // namespace brume
