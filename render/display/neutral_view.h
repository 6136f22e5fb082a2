#pragma once

namespace brume {

// Constants of Khronos PBR Neutral (Khronos Group, 2024): colours below `start` are unchanged,
// brighter ones are compressed towards white, so that lit fog keeps the hue of its lights.
namespace highlight {
constexpr float start = 0.8f - 0.04f;
constexpr float desaturation = 0.15f;
// Subtracted from all channels; depends on the minimum channel where that is below `knee`.
constexpr float offset = 0.04f;
constexpr float knee = 0.08f;
constexpr float slope = 6.25f;
}  // namespace highlight

// Radiance is clamped to this first: exposure must not overflow to infinity.
constexpr float brightest_shown = 1e6f;

}  // namespace brume
