#!/usr/bin/env bash
# Numbers of the shaders have names. Those that C++ has too are generated (render/gl/shader_source
# and shader_structs); those of one shader are a `const` at the beginning of a line. Only the small
# numbers of plain formulas are left.
set -euo pipefail
cd "$(dirname "$0")/.."

plain='0\.0|0\.5|1\.0|2\.0|3\.0|4\.0'
failed=0
for file in render/gl/shaders/*.glsl; do
  found=$(sed -E 's://.*::; s:^const (float|double|int|uint) .*::' "$file" |
    grep -noP '(?<![\w.])(\d+\.\d*|\.\d+|\d+(?=[eE]))([eE][-+]?\d+)?' | grep -vE ":($plain)$" || true)
  if [[ $found ]]; then
    echo "$file: numbers without a name, by line:"
    echo "$found"
    failed=1
  fi
done
exit "$failed"
