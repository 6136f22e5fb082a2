#!/usr/bin/env bash
# The desktop's own programs accept the files of resources/desktop, and know scenes by them: by
# name and by content, and nothing else.
set -euo pipefail
cd "$(dirname "$0")/../resources"

desktop-file-validate desktop/brume-editor.desktop
appstreamcli validate --no-net desktop/brume.metainfo.xml

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_DATA_HOME=$folder
mkdir -p "$folder/mime/packages"
cp desktop/brume.xml "$folder/mime/packages"
update-mime-database "$folder/mime"
cp scenes/stage.brume "$folder/without_extension"
echo '{"version":1,"format":"brume-scene"}' > "$folder/of_another_program"
echo '{"format": "other"}' > "$folder/other"

scene=application/x-brume-scene
for file in scenes/*.brume "$folder"/*; do
  [ -f "$file" ] || continue
  type=$(gio info -a standard::content-type "$file" | sed -n 's/.*content-type: //p')
  case $file in
    */other) [ "$type" != $scene ] ;;
    *) [ "$type" = $scene ] ;;
  esac || { echo "$file: found to be $type"; exit 1; }
done
