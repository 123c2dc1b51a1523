#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A validation layer of today watches every technique, batches, poses, labels and a host: silent, as the
# packaged one is. It sees what is wrong. Skipped where there is none (tools/validation_layer.sh).
set -euo pipefail
source_folder=$1 tests=$2

layer=$("$source_folder/tools/validation_layer.sh" --cached 2>&1) || { echo "skipped: $layer"; exit 77; }
export VK_LAYER_PATH=$layer
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# watched SUITE FILTER: no test of it fails, and some run
watched() {
  if ! "$tests/$1/test_${3:-$1}" --gtest_filter="$2" >"$log" 2>&1; then cat "$log"; exit 1; fi
  grep -E '^\[  PASSED  \] [1-9]' "$log" || { cat "$log"; echo "no test of $1 ran"; exit 1; }
  if grep -q SKIPPED "$log"; then grep -A1 ': Skipped' "$log"; fi
}
VK_LOADER_DEBUG=layer "$tests/vulkan/test_vulkan" --gtest_filter='Validation.*' >"$log" 2>&1 ||
  { cat "$log"; exit 1; }
library=$(sed -n 's/.*"library_path": "\(.*\)".*/\1/p' "$layer"/*.json)
grep -q "Insert instance layer.*$library" "$log" || { echo "$library is not used"; exit 1; }
watched vulkan '*'
watched techniques '*ValidationIsSilent*'
watched texels 'TexelPicturesOf.MeshesThatTakeTurns:Texels.LeaveOut*'
watched embedding '*EmbeddedEntries.EveryTechniqueDrawsItsPicture:*HeadsInBatchesEqualTheRenderersPicture'
watched sessions 'Sessions.AndSoWithLabels:KeptShadows.AreThoseOfFramesThatDrawAll:Labels.OfARowAreItsHeads'
watched poses 'MovedOnDevice.*:PosedPictures.AreThoseOfTheAssetLoadedInThatPose' poses_on_device
