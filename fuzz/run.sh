#!/usr/bin/env bash
# Fuzzes each target for some seconds and prints a line for each: executions, coverage, finds. Fails where there are finds.
#
#     fuzz/run.sh [SECONDS] [TARGET…]
#
# README.md tells more.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-1200}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(text scene)
fuzz=(cargo +nightly fuzz)
# The code is free of `unsafe`: a sanitizer would only slow it down. Debug assertions and overflow checks are on.
flags=(--sanitizer none --no-trace-compares)

# Texts from the project's own scenes; and for scenes made from bytes, bytes as good as random: the same texts packed.
mkdir -p fuzz/corpus/{text,scene}
find scenes tests/invalid -name '*.ron' | while read -r scene; do
  name=$(basename "$(dirname "$scene")")-$(basename "$scene" .ron)
  cp "$scene" "fuzz/corpus/text/seed-$name"
  gzip -nc "$scene" | tail -c +11 > "fuzz/corpus/scene/seed-$name"
done

"${fuzz[@]}" build "${flags[@]}"
status=0
for target in "${targets[@]}"; do
  log=$(mktemp)
  finds=0 executions=0 begin=$SECONDS
  # A find ends the fuzzer, not the run.
  while left=$((seconds - (SECONDS - begin))) && ((left > 0 && finds < 20)); do
    "${fuzz[@]}" run "${flags[@]}" "$target" -- -max_total_time="$left" -max_len=8192 -dict=fuzz/words.dict \
      -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 > "$log" 2>&1 || {
      finds=$((finds + 1))
      grep -E 'panicked at|ERROR: libFuzzer|Test unit written to' -A 1 "$log" || { cat "$log"; exit 1; }
    }
    executions=$((executions + $(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)))
  done
  coverage=$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 || true)
  took=$((SECONDS - begin))
  echo "$target: $executions executions in $took s, $((executions / took)) a second; ${coverage/cov: /} edges covered; $finds finds"
  rm "$log"
  [ "$finds" = 0 ] || status=1
done
exit $status
