#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The completions do complete, in bash and in zsh, and man(1) has nothing to say against the page.
. "$(dirname "$0")/../tools/expect.sh"
dermis=$2

# As bash does: sources the completions, sets the words of a line, and calls the function.
cat > "$scratch/line.sh" << 'END'
set -u
COMP_WORDBREAKS=$' \t\n"\'><=;|&(:'
source "$1" || exit
shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
_dermis
printf '%s\n' "${COMPREPLY[@]}"
END

# complete WORD...: what bash offers for the last word of a line, a name per line
complete() { bash "$scratch/line.sh" "$scratch/dermis" "$@" > "$scratch/output" 2>&1; }
offers() { grep -qxF -- "$1" "$scratch/output"; }
offers_no() { ! offers "$1"; }

call "$dermis" --completions bash
check "bash has completions" status_is 0
cp "$scratch/output" "$scratch/dermis"

complete dermis re
check "commands that begin so" offers render
check "commands that begin so" offers reference
check "no other command" offers_no bench
complete dermis --v
check "options of the program" offers --version
complete dermis render --
for option in --size --technique --output --help-all --map-budget; do
  check "options of render: $option" offers "$option"
done
check "no option of another command" offers_no --quick
check "no hidden option" offers_no --view
complete dermis render --tech
check "an option" offers --technique
complete dermis render --technique s
check "values of an option" offers screen-gaussians
check "values of an option" offers separable
check "no other value" offers_no lambert
complete dermis render --technique = la
check "a value behind '='" offers lambert
complete dermis render --technique =
check "all values behind '='" offers texture-space
complete dermis view --tone-map ag
check "values of the viewer's options" offers agx
complete dermis profile --preset skin
check "presets" offers skin-layers
complete dermis render --translucency ''
check "words of a switch" offers off
complete dermis dataset ver
check "words that are no options" offers verify
complete dermis render --optimise cull,de
check "one more value of a list" offers cull,depth
complete dermis render --size 6
check "nothing where a number stands" offers ''

cd "$scratch" || exit
mkdir heads
touch "a head.glb" ahead.gltf
complete dermis render ah
check "files" offers ahead.gltf
complete dermis render 'a '
check "files with spaces" offers 'a head.glb'
complete dermis render --environment a
check "files of an option" offers ahead.gltf
complete dermis render --environment s
check "words beside files" offers studio
complete dermis render built
check "words in the place of a file" offers built-in:light
complete dermis render built-in : li
check "what stands behind a colon" offers light
complete dermis render built-in :
check "all that stands behind a colon" offers dark
complete dermis profile --export-to h
check "folders" offers heads
complete dermis profile --export-to a
check "no file in the place of a folder" offers_no ahead.gltf
complete dermis bake --x
check "an unknown command offers nothing" offers ''

call "$dermis" --completions zsh
check "zsh has completions" status_is 0
cp "$scratch/output" "$scratch/_dermis"
if command -v zsh > /dev/null; then
  call zsh -n "$scratch/_dermis"
  check "zsh reads its completions" status_is 0
  check "zsh reads its completions without a word" says_nothing
else
  echo "zsh is not here: its completions are not read"
fi

call "$dermis" --completions fish
check "another shell is refused" status_is 2
check "another shell is refused" says "'fish' is not known; there are: bash, zsh"

call "$dermis" --man
check "there is a manual page" status_is 0
check "it names every command" says "OPTIONS OF DERMIS SEQUENCE"
check "it has every option" says '\fB\-\-map\-budget\fR'
cp "$scratch/output" "$scratch/dermis.1"
if command -v groff > /dev/null; then
  call groff -man -ww -z -Tutf8 "$scratch/dermis.1"
  check "groff has no warning" says_nothing
else
  echo "groff is not here: the manual page is not checked"
fi
if command -v man > /dev/null; then
  call bash -c 'man --warnings -E UTF-8 -l -Tutf8 "$1" > /dev/null' bash "$scratch/dermis.1"
  check "man shows it" status_is 0
  check "man has no warning" says_nothing
fi

finish
