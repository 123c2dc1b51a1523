# SPDX-License-Identifier: MIT
# Random events at the viewer, under a window manager and the validation layer: keys, clicks, drags and the
# wheel anywhere, other sizes, drops of whole and of broken files, minimising, and a device that is lost now
# and then. It must neither crash nor hang, say nothing of validation, grow no more than it may, and close
# within a second while something is computed.
#   events.sh SOURCE VIEWER EVENTS [COUNT [SEED]]
set -euo pipefail
source_folder=$1 program=$2 events=$3 count=${4:-160} RANDOM=${5:-7}
source "$source_folder/tests/viewer/drive.sh"

open_display 900x700x24
cd "$work"
openbox >/dev/null 2>&1 &
manager=$!

# whole and broken files
printf 'glTF' >broken.glb
printf '{"asset": {' >broken.gltf
printf '#?RADIANCE\n\n-Y 99999 +X 3\n' >broken.hdr
printf '{"variances_mm2": [1, -1]}' >broken-profile.json
printf '{"output": {"bloom": "much"}}' >broken-settings.json
printf '{"output": {"bloom": 0.1}}' >settings.json
printf 'text' >notes.txt
: >empty.exr
files=(broken.glb broken.gltf broken.hdr broken-profile.json broken-settings.json settings.json notes.txt
  empty.exr missing.glb)

export DERMIS_VIEW_LOSE_DEVICE=20
start_viewer --window 480x360 --map-size 64 --shadow-size 64 --samples 1 --validate

resident_kb() { awk '/VmRSS/ { print $2 }' "/proc/$viewer/status"; }
# When nothing is being drawn, and what was freed has been given back.
resident_at_rest() {
  local end=$((SECONDS + 10))
  mark
  xdotool windowmap "$window" windowactivate "$window" mousemove --window "$window" 20 20
  until since '^idle' >/dev/null || ((SECONDS >= end)); do sleep 0.1; done
  resident_kb
}
random() { echo $((RANDOM * 32768 + RANDOM)); }
keys=(f p ctrl+z ctrl+y ctrl+shift+z w s a d q e Tab Return Escape 1 5 period minus BackSpace)
tabs=(Picture Light Skin Pose Compare Inside Save)

one_event() {
  local px=$(($(random) % 470)) py=$(($(random) % 350))
  case $(($(random) % 12)) in
    0 | 1 | 2) xdotool mousemove --window "$window" "$px" "$py" mousedown 1 sleep 0.05 mouseup 1 ;;
    3 | 4)
      local button=$((1 + RANDOM % 3))
      xdotool mousemove --window "$window" "$px" "$py" mousedown $button sleep 0.04 \
        mousemove --window "$window" $(($(random) % 470)) $(($(random) % 350)) sleep 0.04 mouseup $button
      ;;
    5) xdotool mousemove --window "$window" "$px" "$py" click $((4 + RANDOM % 2)) ;;
    6 | 7) xdotool key --clearmodifiers "${keys[RANDOM % ${#keys[@]}]}" ;;
    8) xdotool windowsize "$window" $((320 + $(random) % 400)) $((180 + $(random) % 400)) ;;
    9) "$events" drop "$window" 50 50 "$work/${files[RANDOM % ${#files[@]}]}" || true ;;
    10)
      find_place "${tabs[RANDOM % ${#tabs[@]}]}" || return 0
      xdotool mousemove --window "$window" $((x + w / 2)) $((y + h / 2)) mousedown 1 sleep 0.05 mouseup 1
      ;;
    11)
      xdotool windowminimize "$window"
      sleep 0.2
      xdotool windowmap "$window" windowactivate "$window"
      ;;
  esac 2>/dev/null
}

start_kb=0
for ((i = 1; i <= count; ++i)); do
  one_event || true
  kill -0 "$viewer" 2>/dev/null || fail "the viewer has ended after $i events"
  # In the first half of them most is made that is kept.
  if ((i == count / 2 || i % 200 == 0 || i == count)); then
    kb=$(resident_at_rest)
    ((i == count / 2)) && start_kb=$kb
    echo "$i events: $((kb / 1000)) MB at rest"
  fi
done
told() { grep -c "$1" "$log" || true; }
echo "$count events: $(told '^picture') pictures, $(told 'device was lost') lost devices," \
  "$(told '^error') errors told; $start_kb kB after half of them, $kb kB at the end"
# One renderer that is not given back is more than that.
((kb < start_kb + start_kb / 5)) || fail "memory grows: $start_kb kB, then $kb kB"

# It closes while a picture is drawn.
xdotool windowsize "$window" 500 400 key --clearmodifiers f
close_viewer
awk '/^closed in/ && $3 < 1 { good = 1 } END { exit !good }' "$log" || fail "$(grep '^closed' "$log")"
