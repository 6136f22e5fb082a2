#!/usr/bin/env bash
# The layers, by their includes: arrows point down only (CONTRIBUTING.md).
set -euo pipefail
cd "$(dirname "$0")/.."

failed=0
# refuse WHAT PATTERN FOLDERS...: no file of the folders may include what matches, be it by way of
# "../". Folders that are missing or cannot be read fail too: else nothing would be checked.
refuse() {
  local what=$1 pattern=$2 status=0
  shift 2
  grep -rnE "^\s*#\s*include\s*[<\"](.*\.\./)?($pattern)" "$@" \
    --include='*.h' --include='*.hpp' --include='*.cpp' || status=$?
  case $status in
    0) echo "$*: must not include $what"; failed=1 ;;
    1) ;;
    *) echo "$*: cannot be checked"; failed=1 ;;
  esac
}
refuse "Qt or VTK" 'Q[A-Z]|Qt[A-Z]|vtk[A-Z]' core render tools
refuse "OpenGL" 'epoxy/|GL/|EGL/' core tools
refuse "a layer above itself" 'render/|app/|tools/' core
refuse "a layer above itself" 'app/|tools/' render
refuse "the editor" 'app/' tools
refuse "the command line" 'tools/' app
refuse "a relative path" '\.\./' core render app tools

# Within a layer: files, and what else of the layer they may include beside their own folder. Each
# row names only rows above it, so there are no circles.
values='render/frame.h render/settings.h render/stage.h'
surfaces='render/geometry/ render/simd/ render/visibility/ render/lighting/ render/shading/'
while IFS=: read -r files allowed; do
  [[ $files ]] || continue
  layer=${files%%/*} folder=${files%/*}
  pattern=$(tr -s ' ' '|' <<<"${allowed# }${allowed:+ }$folder/[^/]*\$")
  found=$(compgen -G "$files" >/dev/null && grep -HoE '^\s*#\s*include\s*"[^"]+' $files |
    sed -nE "s/^([^:]+):[^\"]*\"($layer\/.*)/\1 includes \2/p" |
    awk -v pattern="^($pattern)" '$3 !~ pattern' || true)
  if [[ $found ]]; then
    echo "$found"
    echo "$files: may include of $layer only:$allowed"
    failed=1
  fi
done <<ROWS
core/*.[hc]*:
core/math/*.[hc]*:
core/medium/*.[hc]*:core/[a-z_]+.h
core/scene/*.[hc]*:core/[a-z_]+.h core/math/ core/medium/
core/transport/*.[hc]*:core/math/ core/medium/ core/scene/
core/authoring/*.[hc]*:core/[a-z_]+.h core/math/ core/medium/ core/scene/ core/transport/
core/volume/*.[hc]*:core/[a-z_]+.h core/medium/
core/io/*.[hc]*:core/[a-z_]+.h core/scene/
core/io/mesh/*.[hc]*:core/[a-z_]+.h core/scene/ core/io/[a-z_]+.h
core/io/image/*.[hc]*:core/[a-z_]+.h core/scene/ core/io/[a-z_]+.h
core/io/volume/*.[hc]*:core/[a-z_]+.h core/volume/ core/io/[a-z_]+.h
core/io/gaussians/*.[hc]*:core/[a-z_]+.h core/medium/ core/scene/ core/io/[a-z_]+.h
core/io/scene/json_*.[hc]*:core/[a-z_]+.h core/io/[a-z_]+.h
core/io/import/*.[hc]*:core/[a-z_]+.h core/scene/ core/io/[a-z_]+.h core/io/image/ core/io/scene/json_reader.h
core/io/scene/*.[hc]*:core/[a-z_]+.h core/medium/ core/scene/ core/io/
core/fit/*.[hc]*:core/[a-z_]+.h core/medium/ core/scene/ core/transport/ core/volume/ core/io/volume/
render/util/*.[hc]*:
render/geometry/*.[hc]*:
render/stage.*:
render/frame.*:render/stage.h
render/settings.*:render/frame.h
render/display/*.[hc]*:$values
render/simd/*.[hc]*:$values render/geometry/
render/visibility/*.[hc]*:render/util/ render/geometry/ render/simd/
render/transfer/*.[hc]*:render/util/ render/simd/ render/visibility/
render/render_plan.*:$values render/transfer/
render/lighting/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/
render/shading/*.[hc]*:$values render/render_plan.h render/util/ render/transfer/ $surfaces
render/prepare/*.[hc]*:$values render/render_plan.h render/util/ render/transfer/ $surfaces
render/reference/*.[hc]*:$values render/render_plan.h render/util/ $surfaces render/prepare/
render/paths/*.[hc]*:$values render/util/ render/geometry/ render/simd/ render/visibility/ render/reference/ render/prepare/light_limits.h
render/samples/*.[hc]*:$values render/frame_renderer.h render/util/ render/prepare/albedo.h render/paths/path_random.h
render/cpu/*.[hc]*:$values render/render_plan.h render/util/ $surfaces render/prepare/ render/samples/ render/paths/
render/layers/*.[hc]*:$values render/frame_renderer.h render/util/ render/samples/ $surfaces
render/gl/*.[hc]*:$values render/display/ render/render_plan.h render/util/ $surfaces render/prepare/
render/output/*.[hc]*:$values render/display/
render/deep/*.[hc]*:$values render/render_plan.h render/util/ render/transfer/ $surfaces render/prepare/ render/cpu/ render/output/
render/quality/*.[hc]*:$values render/frame_renderer.h render/util/ render/geometry/ render/prepare/ render/reference/ render/visibility/ render/render_plan.h render/paths/
app/document/*.[hc]*:
app/commands/*.[hc]*:app/document/
app/widgets/*.[hc]*:app/document/ app/commands/
app/jobs/*.[hc]*:app/widgets/
app/pictures/*.[hc]*:app/document/ app/widgets/ app/jobs/
app/files/*.[hc]*:app/document/ app/widgets/ app/jobs/
app/export/*.[hc]*:app/document/ app/widgets/ app/jobs/ app/files/ app/pictures/
app/import/*.[hc]*:app/document/ app/commands/ app/widgets/ app/jobs/ app/files/
app/view/*.[hc]*:app/document/ app/widgets/ app/jobs/
app/frames/*.[hc]*:app/document/ app/widgets/ app/jobs/ app/view/
app/tools/*.[hc]*:app/document/ app/commands/ app/widgets/ app/view/
app/panels/*.[hc]*:app/document/ app/commands/ app/widgets/ app/jobs/ app/files/ app/view/ app/frames/
app/viewport/*.[hc]*:app/document/ app/widgets/ app/view/ app/frames/
tools/bench/scenes/*.[hc]*:tools/make_scenes/
tools/bench/measure/*.[hc]*:tools/bench/scenes/
tools/bench/errors/*.[hc]*:tools/make_scenes/ tools/bench/scenes/ tools/bench/measure/
tools/bench/report/*.[hc]*:tools/bench/measure/ tools/bench/errors/
ROWS
exit "$failed"
