#!/usr/bin/env bash
# The floors of the house, by their includes: arrows point down only (CONTRIBUTING.md).
set -euo pipefail
cd "$(dirname "$0")/.."

failed=0
# refuse WHAT PATTERN FOLDERS...: no file of the folders may include what matches.
refuse() {
  local what=$1 pattern=$2
  shift 2
  if grep -rnE "^ *# *include *[<\"]($pattern)" "$@" --include='*.h' --include='*.cpp'; then
    echo "$*: must not include $what"
    failed=1
  fi
}
refuse "Qt or VTK" 'Q[A-Z]|Qt[A-Z]|vtk[A-Z]' core render tools
refuse "OpenGL" 'epoxy/|GL/|EGL/' core tools
refuse "a floor above itself" 'render/|app/|tools/' core
refuse "a floor above itself" 'app/|tools/' render
refuse "the editor" 'app/' tools
refuse "the command line" 'tools/' app
exit "$failed"
