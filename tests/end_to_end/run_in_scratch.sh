#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# run_in_scratch.sh SCRIPT: runs a test script in an empty folder, $SCRATCH, and removes the folder.
set -euo pipefail
SCRATCH=$(mktemp -d "${TMPDIR:-/tmp}/cbvh_test.XXXXXX")
export SCRATCH
trap 'rm -rf "$SCRATCH"' EXIT
cd "$SCRATCH"
bash -euo pipefail "$1"
