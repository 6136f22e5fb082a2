#!/usr/bin/env bash
# Installs the programs into a folder, moves it, and uses them from there: all that they need comes
# along, and nothing refers to where they were built.
#   check_installation.sh CMAKE BUILD_FOLDER BUILD_TYPE
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" --install "$2" --prefix "$folder/first" --component programs > /dev/null
mv "$folder/first" "$folder/moved here"
cd "$folder/moved here"

for scene in share/brume/{scenes,templates}/*.brume; do
  bin/brume info "$scene" > /dev/null
done
bin/brume render share/brume/scenes/bunny_fog.brume -o "$folder/frame.png" --size 64x48 --scattering single
test -s "$folder/frame.png"
# Read by brume-scene-reader.
bin/brume info share/brume/meshes/teapot.obj > /dev/null
# A thumbnail, as a file manager asks for it.
command=$(sed -n 's/^Exec=//p' share/thumbnailers/brume.thumbnailer)
read -ra words <<< "$command"
words=("${words[@]/#%i/share/brume/templates/room.brume}")
words=("${words[@]/#%o/$folder/thumbnail.png}")
PATH=$PWD/bin:$PATH "${words[@]/#%s/128}"
test -s "$folder/thumbnail.png"

# What is compiled to be debugged names its sources.
only_text=-I
if [ "$3" = Release ]; then only_text=; fi
if grep -rlF $only_text "$2" .; then
  echo "these refer to the build folder"
  exit 1
fi
