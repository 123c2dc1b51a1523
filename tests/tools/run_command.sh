#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The front door: its help is complete, a wrong command is refused, and its package list is what
# install_packages.sh can read.
source "$(dirname "$0")/expect.sh"

call "$root/run" help
check "help: exit status 0" status_is 0
for command in demo test build docs python fetch-assets tsan fuzz help; do
  check "help tells of $command" says "  $command "
done
call "$root/run" bake
check "unknown command: exit status 2" status_is 2
check "unknown command: the known ones" says \
  "unknown command 'bake'; known: demo, test, build, docs, python, fetch-assets, tsan, fuzz, help"
call "$root/run" fetch-assets --into "$scratch/nowhere"
check "fetch-assets hands its options on" says "$scratch/nowhere: not a folder"
call bash -c "sed -e 's/#.*//' '$root/tools/packages.txt' |
  grep -vE '^[a-z0-9][a-z0-9+.-]*[[:space:]]*\$|^\[(draw|test|rest|docs)\]\$|^\$'"
check "every package name is one, and every section" says_nothing
call bash -c "sed -e 's/[[:space:]]*#.*//' -e '/^\$/d' '$root/tools/packages.txt' | sort | uniq -d"
check "no package is named twice" says_nothing
call bash -c "grep -E '^[a-z0-9]' '$root/tools/packages.txt' | grep -v '#'"
check "every package says what it is for" says_nothing
finish
