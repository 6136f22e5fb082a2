#!/usr/bin/env bash
# Installs the library somewhere, moves it, builds the examples against it out of the tree, and runs
# them.
#   check_library.sh SOURCE BUILD
set -euo pipefail

source=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for component in library development; do
  cmake --install "$build" --prefix "$folder/made" --component $component > "$folder/log"
done
mv "$folder/made" "$folder/prefix"

# It shows nothing but its own.
library=$(find "$folder/prefix" -name 'libbrume.so')
foreign=$(nm -D --defined-only --demangle "$library" |
  grep -vE ' [A-Z] (brume::|(typeinfo|typeinfo name|vtable|guard variable) for brume::)' || true)
[ -z "$foreign" ] || { echo "symbols that are not Brume's:" && head <<< "$foreign" && exit 1; }

cp -r "$source/examples" "$folder/examples"
cmake -S "$folder/examples" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_PREFIX_PATH="$folder/prefix" > "$folder/log" || { cat "$folder/log" && exit 1; }
cmake --build "$folder/build" > "$folder/log" || { cat "$folder/log" && exit 1; }
long=$(wc -l "$source"/examples/*.cpp | awk '$2 != "total" && $1 > 30')
[ -z "$long" ] || { echo "longer than 30 lines: $long" && exit 1; }

cd "$folder"
build/build_medium ring.brume
build/render ring.brume ring.png
build/measure ring.brume
build/fit torus.ply
build/animate "$source/resources/scenes/stage.brume" . 2
if build/render nothing.brume nothing.png 2> error; then exit 1; fi
grep -q '^nothing.brume: ' error
for made in ring.brume ring.png torus.ply frame_0.png frame_1.png; do
  [ -s "$made" ] || { echo "$made is missing" && exit 1; }
done
if cmp -s frame_0.png frame_1.png; then echo "the animation stands still" && exit 1; fi
