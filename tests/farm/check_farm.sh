#!/usr/bin/env bash
# A real Slurm of two nodes on this machine renders a sequence, while a node and a task are killed;
# frames are those of one process, byte for byte. Exit code 77: skipped, and why.
#   check_farm.sh BRUME SCENE
set -euo pipefail

. "$(dirname -- "${BASH_SOURCE[0]}")/../../tools/slurm-cluster.sh"

brume=$1 scene=$2
folder=$(mktemp -d)
mkdir "$folder"/{farm,one}
trap 'stop_slurm; rm -rf "$folder"' EXIT
if ! start_slurm "$folder" > "$folder/reason"; then
  echo "skipped: $(cat "$folder/reason")"
  exit 77
fi

options=(--frames 0-39 --fps 10 --size 480x360 --airlight sliced --scattering single --backend cpu)
"$brume" render "$scene" "${options[@]}" -o "$folder/one/f_%04d.exr" > /dev/null
"$brume" submit slurm "$scene" "${options[@]}" -o "$folder/farm/f_%04d.exr" --chunk 5 --watch \
  > "$folder/result" 2> "$folder/errors" &
submission=$!

# Until there are so many frames, or it has ended.
wait_for() {
  while kill -0 $submission 2> /dev/null &&
    [ "$(find "$folder/farm" -name 'f_*.exr' | wc -l)" -lt "$1" ]; do
    sleep 0.2
  done
}
wait_for 3
# The same again is refused while it runs.
if "$brume" submit slurm "$scene" "${options[@]}" -o "$folder/farm/f_%04d.exr" 2> "$folder/again"; then
  echo "two jobs make the same files" && exit 1
fi
grep -q 'is not finished' "$folder/again" || { cat "$folder/again" "$folder/errors" && exit 1; }
kill_task() {
  for _ in $(seq 100); do
    if pkill -KILL -n -f "$brume render.*$folder/farm"; then return; fi
    sleep 0.05
  done
  echo "no task runs" && exit 1
}
# A task dies, and then a node with what runs on it.
kill_task
wait_for 10
kill -KILL "$(cat "$folder/n2.pid")"
kill_task
sleep 8
slurmd -N n2

wait $submission || { cat "$folder/errors" "$folder/result" && exit 1; }
cat "$folder/errors" "$folder/result"
grep -q 'were lost with their tasks' "$folder/errors"
grep -q '"done":40,"failed":\[\],"lost":\[\]' "$folder/result"
for frame in "$folder"/one/*.exr; do cmp "$frame" "$folder/farm/$(basename "$frame")"; done
# All is there: nothing is submitted.
"$brume" submit slurm "$scene" "${options[@]}" -o "$folder/farm/f_%04d.exr" --watch |
  grep -q '"jobs":\[\],"done":40'
