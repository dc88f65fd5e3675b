#!/usr/bin/env bash
# Counts the instructions of one trace of the prism and of the slabs, streamed into a summary and kept as a tree, and compares
# them with benches/instructions.csv: more than 5 % above ends with 1. `--update` writes the file anew. Unlike a time, a count
# does not depend on what else the machine does; it does depend on the compiler, which the file names.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v valgrind >/dev/null; then
    echo "instructions.sh needs valgrind (its tool callgrind counts the instructions), and it is not installed" >&2
    exit 2
fi
known=benches/instructions.csv
compiler=$(rustc --version | cut -d ' ' -f 2)
program=$(cargo bench --locked --bench instructions --no-run 2>&1 |
    sed -n 's/.*Executable benches\/instructions.rs (\(.*\)).*/\1/p')
if [ -z "$program" ]; then
    echo "instructions.sh cannot find the program: does \`cargo bench --bench instructions --no-run\` build?" >&2
    exit 2
fi

# Instructions of a whole run: scene, way, repetitions.
count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$@" 2>&1 | sed -n 's/.*Collected : *//p'
}

status=0
counted=$(mktemp)
trap 'rm -f "$counted"' EXIT
echo "scene,way,instructions,compiler" > "$counted"
for scene in prism slabs; do
    for way in stream tree; do
        # What is not part of a trace drops out of the difference.
        each=$((($(count "$scene" "$way" 15) - $(count "$scene" "$way" 5)) / 10))
        echo "$scene,$way,$each,$compiler" >> "$counted"
        before=$(sed -n "s/^$scene,$way,\([0-9]*\),.*/\1/p" "$known" 2>/dev/null || true)
        if [ -z "$before" ]; then
            echo "$scene, $way: $each instructions, not known before"
            [ "${1-}" = --update ] || status=1
            continue
        fi
        echo "$scene, $way: $each instructions, $before before ($(((each - before) * 1000 / before)) per mille)"
        if [ $((each * 100)) -gt $((before * 105)) ]; then status=1; fi
    done
done

if [ "${1-}" = --update ]; then
    cp "$counted" "$known"
elif [ "$status" != 0 ]; then
    echo "more than 5 % above $known (counted with rustc $compiler); if that is meant, run benches/instructions.sh --update" >&2
    exit 1
fi
