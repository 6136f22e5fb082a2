#pragma once

namespace brume {

// A configuration of OpenColorIO whose display "screen" has the views "plain", linear, and "half",
// of half the light.
inline constexpr const char* halving_config = R"(ocio_profile_version: 1
roles:
  scene_linear: linear
displays:
  screen:
    - !<View> {name: plain, colorspace: linear}
    - !<View> {name: half, colorspace: halved}
colorspaces:
  - !<ColorSpace>
    name: linear
  - !<ColorSpace>
    name: halved
    from_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
)";

}  // namespace brume
