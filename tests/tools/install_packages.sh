#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/install_packages.sh with stand-ins for dpkg-query, apt-get, id and sudo: what is asked of the system,
# and what is said when it fails.
source "$(dirname "$0")/expect.sh"

mkdir "$scratch/bin"
export PATH=$scratch/bin:$PATH calls=$scratch/calls
# stand_in NAME BODY
stand_in() { printf '#!/usr/bin/env bash\n%s\n' "$2" >"$scratch/bin/$1"; chmod +x "$scratch/bin/$1"; }
asked() { grep -qxF -- "$1" "$calls"; }
asked_nothing() { [[ ! -s $calls ]]; }
install() { : >"$calls"; call "$root/tools/install_packages.sh" "$@"; }

cat >"$scratch/list.txt" <<'LIST'
# a comment
present-dev      # there
absent-dev
removed-dev      # was there once: its settings still are

LIST
stand_in dpkg-query 'printf "present-dev installed\nremoved-dev config-files\n"; exit 1'
stand_in apt-get 'echo "apt-get ${*##-*}" | tr -s " " >>"$calls"
[[ $* != *"${apt_fails:-nothing}"* ]] || { echo "E: Unable to locate package"; exit 100; }'
stand_in id 'echo "${user:-0}"'
stand_in sudo 'echo sudo >>"$calls"; exec "$@"'

install "$scratch/list.txt"
check "missing packages: exit status 0" status_is 0
check "the missing ones are named" says "installing 2 missing packages: absent-dev removed-dev"
check "apt-get installs those two" grep -qE 'install .*absent-dev removed-dev$' "$calls"
check "no sudo as root" bash -c '! grep -q sudo "$calls"'
user=1000 install "$scratch/list.txt"
check "sudo for a user" asked sudo
apt_fails=update install "$scratch/list.txt"
check "an index that cannot be refreshed is no failure by itself" status_is 0
apt_fails=install install "$scratch/list.txt"
check "a failed install: exit status 1" status_is 1
check "what apt-get said" says "E: Unable to locate package"
check "what to look at" says "error: apt-get could not install: absent-dev removed-dev"

stand_in dpkg-query 'printf "present-dev installed\nremoved-dev installed\nabsent-dev installed\n"'
user=1000 install "$scratch/list.txt"
check "nothing missing: exit status 0" status_is 0
check "nothing is asked of the system" asked_nothing
check "nothing is said" says_nothing
install -- other-dev
check "packages by name" says "installing 1 missing packages: other-dev"
printf '[draw]\npresent-dev\n[test]\nother-dev  # there\n' >"$scratch/sections.txt"
install "$scratch/sections.txt" draw
check "a section: what stands in another is not asked for" asked_nothing
install "$scratch/sections.txt" draw test
check "two sections" says "installing 1 missing packages: other-dev"
install "$scratch/sections.txt" none
check "a section that is none: exit status 1" status_is 1
install "$scratch/none.txt"
check "no list: exit status 1" status_is 1
check "no list: said" says "cannot be read"
finish
