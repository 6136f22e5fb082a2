#pragma once

#include <string>

#include "brume/camera.h"
#include "brume/primitive.h"
#include "core/number_domain.h"

namespace brume {

// Checks of single values that a program made, named by their place. Throw DomainError.
void check_value(const std::string& place, double value, const NumberDomain& domain);
void check_film(const std::string& place, const Film& film);
void check_size(const std::string& place, const Primitive& primitive);

}  // namespace brume
