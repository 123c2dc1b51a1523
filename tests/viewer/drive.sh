# SPDX-License-Identifier: MIT
# Functions that drive dermis view on a display of its own, by keys, a mouse and drops, as a hand does.
# Read by the tests beside it: build=, program= and events= are set before.

fail() {
  echo "error: $*" >&2
  [[ -f ${log-} ]] && grep -v '^place' "$log" | tail -n 15 >&2
  exit 1
}

# A display that nobody sees, gone with the script.
open_display() {
  work=$(mktemp -d)
  log=$work/log
  exec {ready}<> <(:)
  Xvfb -displayfd "$ready" -screen 0 "${1:-1024x768x24}" -nolisten tcp >/dev/null 2>&1 &
  xvfb=$!
  trap 'kill "${viewer-}" "${manager-}" "$xvfb" 2>/dev/null || true; rm -rf "$work"' EXIT
  read -r -t 20 number <&"$ready" || fail "no display"
  export DISPLAY=:$number
}

# start_viewer ARGUMENTS...: and waits for its first picture at rest.
start_viewer() {
  : >"$log"
  marked=0
  "$program" view --tell "$@" >>"$log" 2>&1 &
  viewer=$!
  wait_for 'at rest' 300
  window=$(xdotool search --onlyvisible --pid "$viewer" | tail -n 1)
  [[ -n $window ]] || fail "no window"
  xdotool windowfocus "$window" 2>/dev/null || true
}

# mark: what is waited for from here on comes after.
mark() { marked=$(wc -l <"$log"); }
marked=0

# since PATTERN: lines after the mark.
since() { tail -n "+$((marked + 1))" "$log" | grep -E "${@:2}" -- "$1"; }

# wait_for PATTERN [SECONDS]: a line after the mark.
wait_for() {
  local end=$((SECONDS + ${2:-120}))
  until since "$1" >/dev/null; do
    kill -0 "$viewer" 2>/dev/null || fail "the viewer has ended before '$1'"
    ((SECONDS < end)) || fail "no '$1' within ${2:-120} s"
    sleep 0.05
  done
}

# find_place NAME: sets x y w h of a widget that is shown; fails if none is.
find_place() {
  local line
  line=$(awk -v name="place $1:" '
      /^places told/ { shown = found; found = "" }
      index($0, name) == 1 { found = substr($0, length(name) + 1) }
      END { print shown }' "$log")
  read -r x y w h <<<"$line"
  [[ -n ${h-} ]]
}

# place NAME: the same, and waits for it.
place() {
  local end=$((SECONDS + 20))
  until find_place "$1"; do
    ((SECONDS < end)) || fail "no widget '$1'"
    sleep 0.05
  done
}

point() { xdotool mousemove --window "$window" "$1" "$2"; sleep 0.06; }

# click NAME [part of its width, per cent]
click() {
  place "$1"
  point $((x + w * ${2:-50} / 100)) $((y + h / 2))
  xdotool mousedown 1; sleep 0.08; xdotool mouseup 1; sleep 0.12
}

# drag NAME FROM_X FROM_Y TO_X TO_Y [button]: per cent of the widget
drag() {
  place "$1"
  local step button=${6:-1}
  point $((x + w * $2 / 100)) $((y + h * $3 / 100))
  xdotool mousedown "$button"; sleep 0.08
  for step in 1 2 3 4 5 6 7 8; do
    point $((x + w * ($2 + ($4 - $2) * step / 8) / 100)) $((y + h * ($3 + ($5 - $3) * step / 8) / 100))
  done
  xdotool mouseup "$button"; sleep 0.1
}

drop() { "$events" drop "$window" 100 100 "$@" || fail "the window takes no drop"; }

# close_viewer [SECONDS]: its exit status must be 0.
close_viewer() {
  mark
  "$events" close "$window"
  local status=0 end=$((SECONDS + ${1:-20}))
  while kill -0 "$viewer" 2>/dev/null; do
    ((SECONDS < end)) || fail "it does not close"
    sleep 0.05
  done
  wait "$viewer" || status=$?
  [[ $status == 0 ]] || fail "it ended with status $status"
  ! grep -q 'validation:' "$log" || fail "the validation layer has said something"
}
