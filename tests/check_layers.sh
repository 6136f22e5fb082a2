#!/usr/bin/env bash
# The layers, by their includes: arrows point down only (CONTRIBUTING.md).
set -euo pipefail
cd "$(dirname "$0")/.."

# Folders that are missing or cannot be read fail: else nothing would be checked.
includes=$(grep -rnE '^\s*#\s*include\s*[<"]' include core render app tools \
  --include='*.h' --include='*.hpp' --include='*.cpp' --include='*.inl') || {
  echo "include, core, render, app, tools: cannot be checked"
  exit 1
}

panels='app/document/ app/commands/ app/widgets/ app/jobs/ app/files/ app/view/ app/frames/'
import='app/document/ app/commands/ app/widgets/ app/jobs/ app/files/'
view='app/document/ app/widgets/ app/jobs/'
tools='app/document/ app/commands/ app/widgets/ app/view/'
values='render/settings.h render/motion.h'
light='render/optical_depth/ render/lights/ render/grid/ render/slices/ render/scattering/'
surfaces="render/geometry/ render/simd/ render/visibility/ $light render/shading/"

# First rows of "what it is: pattern: layers of which no file may include it", be it by way of "../".
# Then, within a layer: files, and what else of the layer they may include beside their own folder;
# each row names only rows above it, so there are no circles.
awk '
  function fail(text) { print text; failed = 1 }
  FNR == NR {
    count = FNR
    split($0, part, ":")
    line[count] = $0
    file[count] = part[1]
    quoted[count] = $0 ~ /^[^<"]*"/
    sub(/^[^<"]*[<"]/, "")
    sub(/[>"].*/, "")
    target[count] = $0
    next
  }
  { split($0, row, ":") }
  row[3] {
    pattern = "^(.*\\.\\./)?(" row[2] ")"
    layers = "^(" row[3] ")/"
    gsub(/ /, "|", layers)
    for (i = 1; i <= count; i++) {
      if (file[i] ~ layers && target[i] ~ pattern) fail(line[i] ": must not include " row[1])
    }
    next
  }
  {
    files = "^" row[1] "$"
    gsub(/\./, "\\.", files)
    gsub(/\*/, "[^/]*", files)
    layer = folder = row[1]
    sub(/\/.*/, "/", layer)
    sub(/[^\/]*$/, "", folder)
    allowed = row[2]
    gsub(/ /, "|", allowed)
    allowed = "^(" allowed (allowed ? "|" : "") folder "[^/]*$)"
    for (i = 1; i <= count; i++) {
      if (!quoted[i] || file[i] !~ files || index(target[i], layer) != 1) continue
      if (target[i] !~ allowed) fail(line[i] ": may include of " layer " only: " row[2])
    }
  }
  END { exit failed }
' <(echo "$includes") - <<ROWS
Qt or VTK:Q[A-Z]|Qt[A-Z]|vtk[A-Z]:include core render tools
OpenGL:epoxy/|GL/|EGL/:include core tools
what is not public:core/|render/|app/|tools/|nlohmann/:include
frames:brume/(frame|methods|render|stage)[.]h:core
scenes:brume/(scene|lights|surface|at_time|camera|keys)[.]h:core/math core/medium core/volume
a layer above itself:render/|app/|tools/:core
a layer above itself:app/|tools/:render
the editor:app/:tools
the command line:tools/:app
a relative path:\.\./:include core render app tools
core/*.[hc]*:
core/math/*.[hc]*:
core/medium/*.[hc]*:core/[a-z_]+.h
core/scene/fields/*.[hc]*:core/[a-z_]+.h
core/scene/materials/*.[hc]*:core/[a-z_]+.h core/math/
core/scene/atmosphere/*.[hc]*:core/[a-z_]+.h core/math/
core/scene/lights/*.[hc]*:core/[a-z_]+.h core/math/ core/scene/placement.h core/scene/materials/ core/scene/atmosphere/
core/scene/animation/*.[hc]*:core/[a-z_]+.h core/math/ core/medium/ core/scene/fields/ core/scene/lights/sky.h core/scene/group_effects.h core/scene/imported_scene.h
core/scene/*.[hc]*:core/[a-z_]+.h core/math/ core/medium/ core/scene/fields/ core/scene/lights/sky.h core/scene/animation/animation.h
core/transport/*.[hc]*:core/math/ core/medium/ core/scene/
core/authoring/*.[hc]*:core/[a-z_]+.h core/math/ core/medium/ core/scene/ core/transport/
core/volume/*.[hc]*:core/[a-z_]+.h core/medium/
core/io/disk/*.[hc]*:core/[a-z_]+.h
core/io/*.[hc]*:core/[a-z_]+.h core/scene/ core/io/disk/
core/io/mesh/*.[hc]*:core/[a-z_]+.h core/math/ core/scene/ core/io/[a-z_]+.h core/io/disk/
core/io/image/*.[hc]*:core/[a-z_]+.h core/scene/ core/io/[a-z_]+.h core/io/disk/
core/io/volume/*.[hc]*:core/[a-z_]+.h core/volume/ core/io/[a-z_]+.h core/io/disk/
core/io/scene/json_*.[hc]*:core/[a-z_]+.h core/io/[a-z_]+.h core/io/disk/
core/io/import/*.[hc]*:core/[a-z_]+.h core/scene/ core/io/[a-z_]+.h core/io/disk/ core/io/image/ core/io/scene/json_reader.h
core/io/gaussians/*.[hc]*:core/[a-z_]+.h core/medium/ core/scene/ core/io/[a-z_]+.h core/io/disk/ core/io/import/ core/io/scene/json_reader.h
core/io/scene/*.[hc]*:core/[a-z_]+.h core/medium/ core/scene/ core/io/
core/files/*.[hc]*:core/[a-z_]+.h core/io/ core/volume/
core/fit/*.[hc]*:core/[a-z_]+.h core/medium/ core/scene/ core/transport/ core/volume/ core/io/volume/
render/formulas/*.[hci]*:
render/util/*.[hc]*:
render/geometry/*.[hc]*:
render/stage.*:
render/frame.*:
render/settings.*:
render/display/*.[hc]*:$values
render/simd/*.[hc]*:$values render/geometry/ render/formulas/
render/visibility/*.[hc]*:render/util/ render/geometry/ render/simd/ render/formulas/
render/transfer/*.[hc]*:render/util/ render/geometry/ render/simd/ render/visibility/
render/render_plan.*:$values render/transfer/
render/optical_depth/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/
render/lights/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/ render/optical_depth/
render/grid/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/
render/slices/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/ render/optical_depth/ render/grid/ordinates.h
render/scattering/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/ $light
render/shading/*.[hc]*:$values render/render_plan.h render/util/ render/transfer/ $surfaces
render/prepare/*.[hc]*:$values render/render_plan.h render/util/ render/transfer/ $surfaces
render/reference/*.[hc]*:$values render/render_plan.h render/util/ $surfaces render/prepare/
render/paths/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/ render/reference/ render/prepare/light_limits.h
render/samples/*.[hc]*:$values render/frame_renderer.h render/util/ render/prepare/albedo.h render/paths/path_random.h
render/cpu/*.[hc]*:$values render/render_plan.h render/util/ $surfaces render/prepare/ render/reference/ render/samples/ render/paths/
render/layers/*.[hc]*:$values render/frame_renderer.h render/render_plan.h render/util/ render/samples/ $surfaces
render/gl/*.[hc]*:$values render/display/ render/formulas/ render/render_plan.h render/util/ $surfaces render/prepare/
render/output/*.[hc]*:$values render/display/
render/deep/*.[hc]*:$values render/frame_renderer.h render/render_plan.h render/util/ render/transfer/ $surfaces render/prepare/ render/samples/ render/cpu/ render/output/
render/splats/*.[hc]*:$values render/display/ render/render_plan.h render/util/ render/transfer/ $surfaces render/prepare/ render/cpu/
render/quality/*.[hc]*:$values render/frame_renderer.h render/util/ render/geometry/ render/samples/ render/prepare/ render/reference/ render/visibility/ render/render_plan.h render/paths/
app/document/text/*.[hc]*:
app/document/*.[hc]*:app/document/text/
app/document/time/*.[hc]*:app/document/[a-z_]+.h app/document/text/
app/commands/*.[hc]*:app/document/
app/commands/gaussians/*.[hc]*:app/document/ app/commands/[a-z_]+.h
app/commands/objects/*.[hc]*:app/document/ app/commands/[a-z_]+.h app/commands/gaussians/
app/widgets/*.[hc]*:app/document/ app/commands/
app/jobs/*.[hc]*:app/widgets/
app/pictures/*.[hc]*:app/document/ app/widgets/ app/jobs/
app/files/*.[hc]*:app/document/ app/widgets/ app/jobs/
app/export/*.[hc]*:app/document/ app/widgets/ app/jobs/ app/files/ app/pictures/
app/import/add_imported.[hc]*:$import
app/import/frame_run.[hc]*:$import
app/import/volume_fit.[hc]*:$import
app/import/dialogs/*.[hc]*:$import app/import/frame_run.h app/import/volume_fit.h
app/import/*.[hc]*:$import app/import/dialogs/
app/view/surface_picker.[hc]*:$view
app/view/drawing/*.[hc]*:$view
app/view/camera/*.[hc]*:$view app/view/surface_picker.h app/view/drawing/
app/view/*.[hc]*:$view app/view/drawing/ app/view/camera/
app/frames/*.[hc]*:app/document/ app/widgets/ app/jobs/ app/view/
app/tools/option_widgets.[hc]*:$tools
app/tools/stroke_path.[hc]*:$tools
app/tools/brushes/*.[hc]*:$tools app/tools/option_widgets.h app/tools/stroke_path.h
app/tools/selection/*.[hc]*:$tools app/tools/option_widgets.h app/tools/stroke_path.h
app/tools/*.[hc]*:$tools app/tools/brushes/ app/tools/selection/
app/assets/*.[hc]*:app/document/ app/commands/ app/widgets/ app/jobs/ app/files/ app/import/ app/view/ app/tools/
app/panels/forms/*.[hc]*:$panels
app/panels/gaussians/*.[hc]*:$panels
app/panels/time/*.[hc]*:$panels
app/panels/lists/*.[hc]*:$panels
app/panels/plots/*.[hc]*:$panels
app/viewport/*.[hc]*:app/document/ app/widgets/ app/view/ app/frames/
tools/bench/scenes/*.[hc]*:
tools/bench/measure/*.[hc]*:tools/bench/scenes/
tools/bench/errors/*.[hc]*:tools/bench/scenes/ tools/bench/measure/
tools/bench/report/*.[hc]*:tools/bench/measure/ tools/bench/errors/
ROWS
