# SPDX-License-Identifier: MIT
# A session with the viewer: it opens the scan (else the built-in head), orbits, moves a light, changes
# melanin, compares with the truth, and saves. The saved picture is that of the copied command line, to the
# bit.
set -euo pipefail
source_folder=$1 program=$2 events=$3
source "$source_folder/tests/viewer/drive.sh"

scan=$source_folder/assets/heads/lee-perry-smith.gltf
[[ -f $source_folder/assets/heads/LeePerrySmith.glb ]] || scan=built-in
# Without a display it says so, and what draws without one.
said=$(env -u DISPLAY -u WAYLAND_DISPLAY "$program" view 2>&1) && fail "a window without a display"
[[ $(wc -l <<<"$said") == 1 && $said == *"no display"* && $said == *render* ]] ||
  fail "without a display: $said"

open_display 1024x768x24
cd "$work"
start_viewer "$scan" --window 800x560 --map-size 256 --shadow-size 256 --samples 1 --bloom 0

echo "opened"
# At rest it wakes for nothing: it says when it has gone to sleep, and says so once.
mark; point 100 100; wait_for '^idle after'
sleep 1; before=$(grep -c '^idle' "$log"); sleep 3
[[ $(grep -c '^idle' "$log") == "$before" ]] || fail "it wakes at rest: $(grep '^idle' "$log" | tail -n 3)"

# orbit, nearer, frame, undo
mark; drag picture 40 50 60 40; wait_for 'picture .* moving'; wait_for 'picture .* at rest'
mark; xdotool mousemove --window "$window" 150 200 click 4; wait_for 'picture .* at rest'
mark; xdotool key f; wait_for 'picture .* at rest'
mark; xdotool key ctrl+z; wait_for 'picture .* at rest'

echo "moved the camera"
# a light on its ball
click Light
grep -q 'place Edit each of them' "$log" && click 'Edit each of them'
mark; click 'light 1'; drag ball 60 40 35 30; wait_for 'picture .* at rest'

echo "moved a light"
# melanin
click Skin
click 'made of'; mark; click 'melanin and blood'; wait_for 'skin .*quick'
mark; drag melanin 10 50 40 50; wait_for 'skin .*quick'; wait_for 'picture .* at rest'

echo "changed the skin"
# the truth, until there is a comparison
click Compare
mark; click 'Ground truth as B'; wait_for 'compared skin: FLIP' 240
click 'A alone'

echo "compared"
# files
click Save
for what in 'Settings (.settings.json)' 'Profile (.profile.json)' 'Copy the command line' \
  'Picture, as shown (.png)'; do
  mark; click "$what"; wait_for 'message: (saved|copied)'
done
wait_for 'message: saved skin.png' 240

# two pictures of the camera around the head
click 'frames per second' 20; xdotool key ctrl+a type 0.5; xdotool key Return; sleep 0.2
mark; click Record; wait_for 'message: recorded' 240
sequence=$(since '^sequence:' | cut -d' ' -f2-)
close_viewer
grep -q '^closed in 0' "$log" || fail "closing took long: $(grep '^closed' "$log")"

line=$(sed -n 's/^command: dermis //p' "$log" | tail -n 1)
echo "dermis $line"
eval "\"${program%-view}\" ${line/-o skin.png/-o again.png}" >/dev/null
cmp skin.png again.png || fail "the saved picture is not that of the command line"
"${program%-view}" render skin.scene.json --settings skin.settings.json -o settings.png >/dev/null
cmp skin.png settings.png || fail "the saved picture is not that of the saved settings"
grep -q variances_mm2 skin.profile.json || fail "no profile"

# The second of them is half a turn later, as `render` draws it.
[[ -f skin-0000.png && ! -f skin-0002.png ]] || fail "not two pictures of a sequence: $(ls)"
half=$(sed -E 's/^sequence /render /; s/--orbit .?0,([-0-9]+)\.\.[^ ]*/--orbit 180,\1/
  s/--fps .* --device/--device/; s/skin-%04d.png/half.png/' <<<"$sequence")
eval "\"${program%-view}\" $half" >/dev/null
cmp skin-0001.png half.png || fail "the sequence is not what render draws: $half"

# The curve of the skin opens in the browser.
mkdir browser
printf '#!/bin/sh\necho "$@" >"%s/opened"\n' "$work" >browser/xdg-open
chmod +x browser/xdg-open
export PATH=$work/browser:$PATH
start_viewer built-in --window 640x480 --map-size 64 --shadow-size 64 --samples 1 --bloom 0
click Skin
click 'made of'; mark; click 'a measured material'; wait_for 'skin .*final' 240
mark; wait_for 'picture .* at rest'  # what is known of it has moved the widgets below
click 'For other engines, and as a page'
mark; click 'R(r) and its fit in the browser'; wait_for 'message: wrote'
end=$((SECONDS + 10))
until [[ -s opened ]]; do
  ((SECONDS < end)) || fail "no browser was asked"
  sleep 0.05
done
grep -q '<svg' "$(cat opened)" || fail "no curve: $(cat opened)"

# Gaussians dragged on it, settings that were dropped and a pose come back from the files.
click 'made of'; mark; click Gaussians; wait_for 'skin Gaussians'
mark; drag 'term 5' 50 50 -200 50; wait_for 'skin Gaussians'; wait_for 'picture .* at rest'
printf '{"output": {"tone_map": "neutral"}, "camera": {"fov_deg": 12}}' >dropped.json
mark; drop "$work/dropped.json"; wait_for 'message: settings'; wait_for 'picture .* at rest'
click Pose; click weights 3
mark; drag "jaw open" 5 50 50 50; wait_for 'picture .* at rest'
click Save
mark; click 'Copy the command line'; wait_for 'message: copied'
mark; click 'Picture, as shown (.png)'; wait_for 'message: saved skin.png' 240
close_viewer
line=$(sed -n 's/^command: dermis //p' "$log" | tail -n 1)
grep -q '"weights"' skin.scene.json || fail "no pose in the scene file"
[[ $line == *neutral* ]] || fail "the dropped settings are not in the command line: $line"
eval "\"${program%-view}\" ${line/-o skin.png/-o again.png}" >/dev/null
cmp skin.png again.png || fail "the picture of a pose is not that of the command line"

# Under the validation layer it closes in order, five times out of five: the last frame may still be drawn.
for turn in 1 2 3 4 5; do
  start_viewer built-in --validate --window 640x480 --map-size 64 --shadow-size 64 --samples 1 --bloom 0
  mark; drag picture 40 50 $((50 + turn)) 40
  close_viewer
  grep 'validation:' "$log" && fail "closing is not in order"
done

# A window that another program destroys ends with one line.
start_viewer built-in --window 640x480 --map-size 64 --shadow-size 64 --samples 1 --bloom 0
xdotool windowclose "$window"
status=0
wait "$viewer" || status=$?
[[ $status == 1 ]] || fail "without its window it ends with status $status"
said=$(grep -vE '^(place|picture|idle|frame|opened|message)' "$log" | grep '^dermis:')
[[ $said == 'dermis: the window was destroyed by another program' ||
  $said == *'surface was lost'* ]] || fail "without its window it says: $said"
grep -q 'X Error' "$log" && fail "an error of the display is not told as ours"
true
