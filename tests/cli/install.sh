#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# cmake --install puts the programs and what belongs to them into place, and no more; they run elsewhere, with
# neither source nor build folder in reach.
. "$(dirname "$0")/../tools/expect.sh"
build=$2 cmake=$3 version=$4

call "$cmake" --install "$build" --component programs --prefix "$scratch/installed"
check "the programs are installed" status_is 0
files() { (cd "$scratch/$1" && find "${@:2}" -type f | sort | tr '\n' ' '); }
viewer=''
[[ -e $build/dermis-view ]] && viewer='bin/dermis-view '
expected="bin/dermis ${viewer}share/bash-completion/completions/dermis share/man/man1/dermis.1 "
expected+="share/zsh/site-functions/_dermis "
files installed bin share > "$scratch/output"
check "these files and no others" test "$(files installed bin share)" = "$expected"
check "nothing beside bin and share" test "$(ls "$scratch/installed" | tr '\n' ' ')" = "bin share "

# Everything, as without a word of components: kit, tests and benches are no part of it.
call "$cmake" --install "$build" --prefix "$scratch/all"
check "all is installed" status_is 0
files all bin > "$scratch/output"
check "programs alone in bin" test "$(files all bin)" = "bin/dermis $viewer"

mv "$scratch/installed" "$scratch/moved"
mkdir "$scratch/elsewhere"
cd "$scratch/elsewhere" || exit

# Hides source and build folder where the system lets a program have mounts of its own.
hide=()
if unshare --mount true 2> /dev/null; then
  hide=(unshare --mount bash -c 'mount -t tmpfs none "$1" && mount -t tmpfs none "$0" 2> /dev/null; "${@:2}"'
    "$build" "$root")
else
  echo "no mounts of one's own here: source and build folder stay in reach"
fi
installed() {
  local driver=()
  [[ -n ${VK_DRIVER_FILES:-} ]] && driver=("VK_DRIVER_FILES=$VK_DRIVER_FILES")
  "${hide[@]}" env -i HOME="$scratch/elsewhere" PATH=/usr/bin:/bin "${driver[@]}" \
    "$scratch/moved/bin/dermis" "$@"
}

call installed --version
check "it says its version" status_is 0
check "it says its version" says "dermis $version ("
call installed render test:nose --size 64x64 --map-size 256 --environment studio -o nose.png
check "it renders" status_is 0
check "it writes a picture" test "$(head -c 8 nose.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a
call installed profile --preset skin1 --model dipole -o skin1.json
check "it computes a profile" status_is 0
if [[ -n $viewer ]]; then
  call installed view
  check "it finds the viewer beside itself" says "there is no display to open a window on"
fi

finish
