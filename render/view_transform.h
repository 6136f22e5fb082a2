#pragma once

namespace brume {

// The numbers of Khronos PBR Neutral (Khronos Group, 2024): colours below `start` are kept,
// brighter ones are compressed towards white, so that hues of lit fog stay what the lights are.
namespace highlight {
constexpr float start = 0.8f - 0.04f;
constexpr float desaturation = 0.15f;
// What is taken off all channels, of the least one where that is below `knee`.
constexpr float offset = 0.04f;
constexpr float knee = 0.08f;
constexpr float slope = 6.25f;
}  // namespace highlight

// Radiance is clamped to it first: an exposure must not turn a bright light into infinity.
constexpr float brightest_shown = 1e6f;

}  // namespace brume
