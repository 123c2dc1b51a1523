#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the library into an empty folder, builds docs/example against it as a stranger would, and lets it
# make a picture.
set -euo pipefail
source_folder=$1 build_folder=$2 cmake=$3 generator=$4 cxx=$5 c=$6
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

fail() { echo "$1"; exit 1; }
# build SOURCES FOLDER: against what is installed
build() {
  quiet "$cmake" -S "$1" -B "$2" -G "$generator" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$cxx" \
    -DCMAKE_C_COMPILER="$c" -DCMAKE_PREFIX_PATH="$place/installed"
  quiet "$cmake" --build "$2"
}
quiet() { "$@" > "$place/log" 2>&1 || { cat "$place/log"; fail "failed: $*"; }; }

quiet "$cmake" --install "$build_folder" --component development --prefix "$place/installed"
headers=$(cd "$place/installed/include" && find . -type f | sort | tr '\n' ' ')
expected=$(cd "$source_folder/include" && find . -type f | sort | tr '\n' ' ')
[ "$headers" = "$expected" ] || fail "installed headers are '$headers', not '$expected'"
if grep -rlF -e "$source_folder" -e "$build_folder" \
  "$place/installed/include" "$place"/installed/lib*/cmake; then
  fail "these installed files name the folder they were built in"
fi

# A copy: nothing of the source tree must be in reach of the example.
cp -r "$source_folder/docs/example" "$place/example"
build "$place/example" "$place/build"
"$place/build/portrait" "$place/portrait.png" | head -3

signature=$(head -c 8 "$place/portrait.png" | od -An -tx1 | tr -d ' \n')
[ "$signature" = 89504e470d0a1a0a ] || fail "portrait.png is no PNG"
size=$(od -An -tu1 -j16 -N8 "$place/portrait.png" | awk '{print $3 * 256 + $4 "x" $7 * 256 + $8}')
[ "$size" = 160x180 ] || fail "portrait.png has $size pixels, not 160x180"
# A picture of one colour packs into some hundred bytes.
[ "$(stat -c %s "$place/portrait.png")" -gt 8000 ] ||
  fail "portrait.png shows nothing: $(stat -c %s "$place/portrait.png") bytes"

# What draws arrays alone finds and links no library for rays or files.
mkdir "$place/alone"
cp "$source_folder/tests/gpu/draw_alone/draw_alone_test.cpp" "$place/alone"
cat >"$place/alone/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(alone LANGUAGES C CXX)
find_package(dermis 0.2 REQUIRED COMPONENTS draw)
find_package(GTest REQUIRED)
add_executable(alone draw_alone_test.cpp)
target_link_libraries(alone PRIVATE dermis::draw GTest::gtest_main)
CMAKE
build "$place/alone" "$place/alone/build"
grep -qiE "embree|openexr|draco|tbb" "$place/alone/build/CMakeCache.txt" &&
  fail "find_package(dermis COMPONENTS draw) looks for libraries that it does not need"
quiet "$place/alone/build/alone"

# Errors arrive as exceptions across the installed library.
if "$place/build/portrait" "$place/other.png" "$place/missing.glb" 2> "$place/log"; then
  fail "a missing head is no error"
fi
grep -q "missing.glb" "$place/log" || fail "the error does not name the file: $(cat "$place/log")"
[ ! -e "$place/other.png" ] || fail "something was written in spite of the error"
