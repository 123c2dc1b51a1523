# SPDX-License-Identifier: MIT
# What the viewer costs a hand: pictures per second while the scan is orbited, the time from a drag of a
# profile slider to its picture, and the processor at rest. Prints figures, asserts nothing.
#   benchmark.sh SOURCE VIEWER EVENTS [ARGUMENTS OF VIEW...]
set -euo pipefail
source_folder=$1 program=$2 events=$3
shift 3
source "$source_folder/tests/viewer/drive.sh"
open_display 1280x800x24
cd "$work"
start_viewer "$source_folder/assets/heads/lee-perry-smith.gltf" --window 1280x800 "$@"

ticks() { awk '{ print $14 + $15 }' "/proc/$viewer/stat"; }
milliseconds() { echo $((${EPOCHREALTIME/[.,]/} / 1000)); }

# Small pictures are made once before, so that what is measured is not their plan.
orbit() {
  local i
  place picture
  point $((x + w / 2)) $((y + h / 2))
  xdotool mousedown 1
  for ((i = 0; i < $1; ++i)); do
    xdotool mousemove_relative -- $((i % 40 < 20 ? 4 : -4)) 0 sleep 0.025
  done
  xdotool mouseup 1
}
mark; orbit 40; wait_for 'picture .* at rest'
mark; before=$(ticks); start=$(milliseconds)
orbit 200
took=$(($(milliseconds) - start)) used=$(($(ticks) - before))
count=$(since 'picture .* moving' | wc -l)
echo "orbit: $count pictures in $took ms, $((1000 * count / took)) per second, at" \
  "$(since 'picture .* moving' | tail -n 1 | cut -d' ' -f3,4);" \
  "$((10 * used / (count > 0 ? count : 1))) ms of processor time per picture, panels included"
wait_for 'picture .* at rest'

click Skin; click 'made of'; mark; click 'melanin and blood'; wait_for 'skin .*final' 240
wait_for 'picture .* at rest'
# From the press of the button to the frame that shows the picture of the new profile.
slide() {
  place melanin
  point $((x + w * $1 / 100)) $((y + h / 2))
  mark; start=$(milliseconds)
  xdotool mousedown 1
  wait_for '^shown' 60
  echo "profile slider, $2: its picture is in the window after" \
    "$(($(since '^shown' | head -n 1 | cut -d' ' -f4) - start)) ms"
  xdotool mouseup 1
}
for to in 20 30 40 50 60; do
  slide $to "from rest"
  wait_for 'skin .*final' 240; wait_for 'picture .* at rest' 240; wait_for '^idle' 60
done
for to in 30 40 50 60 70; do
  slide $to "while a sharp picture is drawn"
  wait_for 'skin .*final' 240; sleep 0.8
done
wait_for 'picture .* at rest' 240
mark; point 100 100; wait_for '^idle' 60
sleep 2
before=$(ticks) frames=$(grep -c '^idle' "$log"); sleep 5
echo "at rest: $(($(ticks) - before)) ticks of the processor in 5 s," \
  "$(($(grep -c '^idle' "$log") - frames)) frames"
awk '/VmRSS/ { print "memory: " int($2 / 1000) " MB" }' "/proc/$viewer/status"
close_viewer
