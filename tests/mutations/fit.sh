#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# fit.sh SOURCE   Whether each fault fits the sources as they are. Changes nothing.
set -uo pipefail
cd "$1" || exit 1
status=0
for fault in tests/mutations/*.patch; do
  patch --dry-run --silent -p1 <"$fault" || { echo "$fault does not fit: write it anew"; status=1; }
done
exit "$status"
