#!/usr/bin/env bash
# Measures everything that docs/accuracy.md shows: the figures of the tests at full size, then time against error. Run it on
# an idle machine. It ends with an error where a figure is past its bound, having written all that was measured.
set -euo pipefail
cd "$(dirname "$0")/../.."

output=$(mktemp)
trap 'rm -f "$output"' EXIT
status=0
SNELLIUS_FULL=1 cargo test --release --test laws --test accuracy --test reference --no-fail-fast -- --nocapture | tee "$output" ||
    status=$?

# FIGURE|name|measured|at most|bound: a test's own line may stand before it.
{
    echo "figure,measured,bound"
    sed -n 's/^.*FIGURE|/FIGURE|/p' "$output" | LC_ALL=C sort -u | awk -F'|' '
        BEGIN { sign["at most"] = "≤ "; sign["at least"] = "≥ " }
        { printf "\"%s\",%s,%s\n", $2, $3 + 0, $4 ? sign[$4] ($5 + 0) : "" }'
} > docs/accuracy/figures.csv

cargo bench --bench work_precision || status=$?
exit "$status"
