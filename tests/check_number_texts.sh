#!/usr/bin/env bash
# Numbers that the editor shows are formatted by app/document/text/number_text only, so that they look
# alike everywhere: nothing else gives Qt a format of a floating-point number.
set -euo pipefail
cd "$(dirname "$0")/.."

found=$(grep -rnE "'[efgEG]', |, '[efgEG]'|setNum\(" app \
  --include='*.cpp' --include='*.h' | grep -v '^app/document/text/number_text.cpp:' || true)
if [[ $found ]]; then
  echo "numbers formatted elsewhere than in app/document/text/number_text:"
  echo "$found"
  exit 1
fi
