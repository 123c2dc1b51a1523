#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/gpu_kit.sh makes an archive, and what is in it runs in a root file system that has a C library and
# nothing else, or a driver beside it. Nothing there is found by accident: no shell, no /proc, no /usr.
source "$(dirname "$0")/../tools/expect.sh"
build=$2
tool=$root/tools/gpu_kit.sh
make_kit() { call "$tool" make --no-build --build "$build" "$@"; }
nothing_left() { [[ -z $(find "$scratch/tmp" "$scratch/out" -mindepth 1) ]]; }
runs() { kill -0 "$1" 2>/dev/null; }
skip() { printf '%s:1: Skipped\n%s\n' "$0" "$1"; finish; }
mkdir "$scratch/tmp" "$scratch/out"
export TMPDIR=$scratch/tmp PATH=$PATH:/usr/sbin:/sbin
chroot=$(command -v chroot)

# What cannot be made is said in a line, and leaves nothing.
refused() {
  check "$1: exit status $2" status_is "$2"
  check "$1: one line" says_one_line
  check "$1: says why" says "$3"
  check "$1: leaves nothing" nothing_left
}
call "$tool" bake
refused "an unknown command" 2 "unknown command 'bake'; known: make, help"
call "$tool" make --wrong
refused "an unknown option" 2 "unknown option '--wrong'; known: -o, --build, --no-build, --help"
call "$tool" make -o
refused "an option without a value" 2 "-o needs a value"
call "$tool" make --build "$scratch/none"
refused "no build" 1 "$scratch/none: no such folder"
make_kit -o "$scratch/none/kit.tar.gz"
refused "no folder for the archive" 1 "$scratch/none: not a folder that can be written to"
mkdir "$scratch/empty"
call "$tool" make --no-build --build "$scratch/empty" -o "$scratch/out/kit.tar.gz"
refused "a build without programs" 1 "apps/kit/run_kit is not there"

# One that is stopped half-way leaves nothing either.
archive=$scratch/out/kit.tar.gz
"$tool" make --no-build --build "$build" -o "$archive" >"$scratch/output" 2>&1 &
maker=$!
while nothing_left && runs $maker; do sleep 0.05; done
kill -TERM $maker 2>/dev/null
wait $maker
check "stopped half-way: exit status 130" test $? -eq 130
check "stopped half-way: leaves nothing" nothing_left

make_kit -o "$archive"
check "the kit is made" status_is 0
check "the archive is there, and nothing beside it" test "$(ls -A "$scratch/out")" = kit.tar.gz
check "it has less than 60 MB" test "$(stat -c %s "$archive")" -lt 60000000
if [[ ! -f $archive ]]; then finish; fi
cp "$scratch/output" "$scratch/made"

# The place has a blank in it: a kit lies anywhere.
place="/some where"
bare=$scratch/bare
mkdir -p "$bare$place" "$bare/tmp"
tar -xzf "$archive" -C "$bare$place"
kit="$bare$place/dermis-kit"
check "the README says what is needed" grep -q "C library of version 2\.[0-9]" "$kit/README.txt"
check "dermis has its licence there" test -s "$kit/licences/dermis.txt"
check "a library has its licence there" test -s "$(compgen -G "$kit/licences/libembree*.txt")"
check "the launcher needs the C library alone" bash -c "
  ! ldd '$kit/run_kit' | grep -vE 'linux-vdso|libc\.so|libdl\.so|ld-linux'"

# copy_to ROOT FILE...: those files at their places, links resolved
copy_to() {
  local to=$1 file
  shift
  for file in "$@"; do
    mkdir -p "$to$(dirname "$file")"
    cp -L --update=none "$file" "$to$file" 2>/dev/null || cp -Ln "$file" "$to$file"
  done
}
needs_of() { ldd "$@" | grep -oE '/[^ ]+ \(0x' | sed 's/ (0x$//' | sort -u; }
is_c_library='/(ld-linux[^/]*|libc|libm|libdl|librt|libpthread|libresolv)\.so\.[0-9]+$'
# shellcheck disable=SC2046
copy_to "$bare" $(needs_of "$build/dermis" | grep -E "$is_c_library") \
  $(find /lib/*-linux-gnu /lib64 -maxdepth 1 -name 'libpthread.so.0' -o -maxdepth 1 -name 'libdl.so.2' \
    -o -maxdepth 1 -name 'librt.so.1' 2>/dev/null)

# within ROOT COMMAND...: the command in that root, with nothing of our environment
inside=("$chroot")
if ! chroot "$bare" "$place/dermis-kit/run_kit" --help >/dev/null 2>&1; then
  inside=("$(command -v unshare)" --user --map-root-user "$chroot")
fi
if ! "${inside[@]}" "$bare" "$place/dermis-kit/run_kit" --help >"$scratch/output" 2>&1; then
  cat "$scratch/output"
  skip "no root file system of our own can be entered: chroot, and unshare --user"
fi
within() { call env -i "${variables[@]}" "${inside[@]}" "$@"; }
variables=(HOME=/)
run_kit="$place/dermis-kit/run_kit"

# one_line WHAT STATUS TEXT: of a run that cannot measure
one_line() {
  check "$1: exit status $2" status_is "$2"
  check "$1: one line" says_one_line
  check "$1: says why" says "$3"
  check "$1: no results" bash -c "! ls '$4'/results/kit-* >/dev/null 2>&1"
}
within "$bare" "$run_kit" --smoke --out /results
one_line "without a driver" 1 "run_kit: no Vulkan driver can be opened" "$bare"
within "$bare" "$run_kit" dermis --version
check "the program starts with the kit's libraries alone" status_is 0
within "$bare" "$run_kit" --wrong
check "a wrong option: exit status 2" status_is 2
within "$bare" "$run_kit" --only bake
check "an unknown part: exit status 2" status_is 2
check "an unknown part: the known ones" says "'bake' is no part; there are: switches, equality"

# A library of the system that is too old gives way to the kit's: here one that is another altogether.
libraries=$(dirname "$(needs_of "$build/dermis" | grep -E '/libc\.so')")
cp "$kit"/lib/libz/libz.so.1 "$bare$libraries/libstdc++.so.6"
within "$bare" "$run_kit" dermis --version
check "a C++ library that is too old is passed over" status_is 0
rm "$bare$libraries/libstdc++.so.6"
mv "$kit/lib/libembree"* "$scratch"
within "$bare" "$run_kit"
one_line "a library is gone" 1 "run_kit: the packed program does not start: " "$bare"
mv "$scratch/libembree"* "$kit/lib"

# A stand-in for the program: what the launcher hands on, and devices that lack something (what the program
# finds missing, its own tests show).
cp -r "$kit" "$scratch/stand-in"
stand_in() {
  printf '#!/bin/sh\n%s\n' "$1" >"$scratch/stand-in/bin/dermis"
  call env -u LD_LIBRARY_PATH "$scratch/stand-in/run_kit" "${@:2}"
}
stand_in 'echo "$LD_LIBRARY_PATH"' dermis
check "libraries of the system that are new enough are used" bash -c "
  grep -q 'stand-in/lib' '$scratch/output' && ! grep -qE 'lib/(libstdc|libgcc|libz)' '$scratch/output'"
stand_in 'echo "$LD_LIBRARY_PATH"; case $LD_LIBRARY_PATH in */lib/libz*) ;; *) exit 1 ;; esac' dermis
check "one that is too old is the kit's" says "stand-in/lib/libz"
check "and that one alone" bash -c "! grep -qE 'lib/(libstdc|libgcc)' '$scratch/output'"
lacks='"name": "Old GPU", "usable": false, "missing": ["needs Vulkan 1.3, this driver has 1.1"]'
stand_in "echo '{\"devices\": [{$lacks}]}'" --smoke --out "$scratch/stand-in/results"
one_line "a driver that lacks something" 1 "Old GPU: needs Vulkan 1.3" "$scratch/stand-in"
rm -r "$scratch/stand-in"

# The software driver, and what it needs.
manifest=$(compgen -G '/usr/share/vulkan/icd.d/lvp_icd*.json' | head -n 1)
driver=$(sed -n 's/.*"library_path": *"\([^"]*\)".*/\1/p' "${manifest:-/dev/null}")
if [[ $driver != /* ]]; then driver=$(find /usr/lib -name "${driver:-none}" -print -quit); fi
if [[ -z $driver ]]; then skip "the software driver is not here (apt install mesa-vulkan-drivers)"; fi
# shellcheck disable=SC2046
copy_to "$bare" "$driver" $(needs_of "$driver")

# As a container has NVIDIA's: no manifest where loaders look, and neither a C++ library nor those of a
# desktop.
odd=$bare/usr/local/nvidia/share/vulkan/icd.d
mkdir -p "$odd"
sed "s|\"library_path\": *\"[^\"]*\"|\"library_path\": \"$driver\"|" "$manifest" >"$odd/nvidia_icd.json"
mkdir "$scratch/away"
for name in libstdc++.so.6 libgcc_s.so.1 libz.so.1 \
  libxcb.so.1 libXau.so.6 libXdmcp.so.6 libbsd.so.0 libmd.so.0; do
  find "$bare/lib" "$bare/usr/lib" -name "$name" -exec cp --parents {} "$scratch/away" \; -delete 2>/dev/null
done
within "$bare" "$run_kit" dermis info
check "a driver that stands where containers have it is found" says "llvmpipe"
cp -r "$scratch/away$bare/." "$bare"
rm -r "$odd"
copy_to "$bare" "$manifest"

touch "$bare/file"
within "$bare" "$run_kit" --smoke --out /file
one_line "a file where the results should go" 1 "run_kit: /file: cannot be" "$bare"

# Where this system lets us mount: a folder that is read-only, and one that is full.
# mounted OPTIONS COMMAND...: with a file system at /mounted that is gone afterwards
mounted() {
  local options=$1
  shift
  # shellcheck disable=SC2016
  call unshare --mount bash -c 'mount -t tmpfs -o "$1" none "$2/mounted" &&
    exec env -i HOME=/ "$(command -v chroot)" "${@:2}"' - "$options" "$bare" "$@"
}
mkdir "$bare/mounted"
if unshare --mount mount -t tmpfs none "$bare/mounted" 2>/dev/null; then
  mounted ro "$run_kit" --smoke --out /mounted
  one_line "a folder that is read-only" 1 "run_kit: /mounted: " "$bare"
  check "a folder that is read-only: says so" says "Read-only file system"
  mounted size=1m "$run_kit" --smoke --out /mounted
  one_line "a full disk" 1 "MB are free there, 100 are needed" "$bare"
else
  echo "note: no mounts here: a read-only folder and a full disk are not tried"
fi

# Killed, it leaves no results; the next run clears up.
start() { env -i HOME=/ "${inside[@]}" "$bare" "$run_kit" "$@" >"$scratch/output" 2>&1 & kit_pid=$!; }
start --smoke --out /results
until compgen -G "$bare/results/.kit-*/cache" >/dev/null || ! runs $kit_pid; do sleep 0.05; done
kill -KILL $kit_pid
wait $kit_pid 2>/dev/null
left=$(compgen -G "$bare/results/.kit-*")
check "killed: no results" bash -c "! ls '$bare'/results/kit-* 2>/dev/null"
check "killed: its folder is left" test -d "$left"

# Stopped in order, it writes the parts until then.
start --smoke --out /results --only equality,sessions
until grep -q '^equality' "$scratch/output" || ! runs $kit_pid; do sleep 0.05; done
kill -TERM $kit_pid
status=0
wait $kit_pid || status=$?
check "stopped: exit status 1" status_is 1
check "stopped: says so" says "run_kit: stopped; what is written holds the parts until then"
check "what the killed run left is gone" test ! -e "$left"
json=$(compgen -G "$bare/results/kit-*.json")
check "stopped: the record says so" grep -q '"complete": false' "$json"
check "stopped: it has the part that was done" grep -q '"equality": \[' "$json"
check "stopped: and nothing else" test "$(ls -A "$bare/results" | wc -l)" -eq 2
rm -r "$bare/results"

# The whole, where nothing else is written.
everything() { (cd "$bare" && find . -type f ! -path './results/*' -printf '%p %s %T@\n' | sort); }
everything >"$scratch/before"
within "$bare" "$run_kit" --smoke --out /results
cat "$scratch/output"
check "the smoke run: exit status 0" status_is 0
check "nothing but the results is written" diff "$scratch/before" <(everything)
check "one JSON and one page" test "$(cd "$bare/results" && echo *)" = \
  "$(basename "$json" .json).html $(basename "$json")"
check "it is complete" grep -q '"complete": true' "$json"
check "nothing has failed" grep -q '"failed": \[\]' "$json"
check "it names the device" grep -q '"device": "llvmpipe' "$json"
check "it names the command" grep -q '"command": "./run_kit --smoke --out /results"' "$json"
for part in switches equality invariants frame bench sessions crowd memory; do
  check "it holds the part $part" grep -q "^ \"$part\":" "$json"
done
check "two pictures were compared to the bit" grep -q '"equal": true' "$json"
check "an invariant holds" grep -q '"result": "holds"' "$json"
if grep -q "the validation layer is not here" "$scratch/made"; then
  check "no layer was packed: it says so" grep -q '"validated": false' "$json"
else
  check "the packed layer is used" grep -q '"validated": true' "$json"
fi
page=${json%.json}.html
check "the page names the device" grep -q "llvmpipe" "$page"
check "the page shows pictures" grep -q 'data:image/png;base64,' "$page"
check "the page asks nothing of the network" bash -c "! grep -oE '(src|href)=\"?https?:' '$page'"
finish
