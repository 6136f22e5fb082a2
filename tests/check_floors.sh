#!/usr/bin/env bash
# The floors of the house, by their includes: arrows point down only (CONTRIBUTING.md).
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
refuse "a floor above itself" 'render/|app/|tools/' core
refuse "a floor above itself" 'app/|tools/' render
refuse "the editor" 'app/' tools
refuse "the command line" 'tools/' app
exit "$failed"
