#!/usr/bin/env bash
# Fuzzes each target for some seconds and prints for each one line: executions, coverage, finds. Fails where there are finds.
#
#     fuzz/run.sh [SECONDS] [TARGET…]
#
# It needs a nightly toolchain and `cargo install cargo-fuzz`. What it learns stays in fuzz/corpus; a find is a file in
# fuzz/artifacts, and `cargo +nightly fuzz run --sanitizer none TARGET FILE` shows it again.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-1200}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(text scene)

# Texts from the project's own scenes; and for scenes made from bytes, bytes as good as random: the same texts packed.
mkdir -p fuzz/corpus/{text,scene,logs}
find scenes tests/invalid -name '*.ron' | while read -r scene; do
  name=$(basename "$(dirname "$scene")")-$(basename "$scene" .ron)
  cp "$scene" "fuzz/corpus/text/seed-$name"
  gzip -nc "$scene" | tail -c +11 > "fuzz/corpus/scene/seed-$name"
done

# The code is free of `unsafe`, so that a sanitizer would only slow it down. Debug assertions and overflow checks are on.
cargo +nightly fuzz build --sanitizer none
status=0
for target in "${targets[@]}"; do
  mkdir -p "fuzz/artifacts/$target"
  log=fuzz/corpus/logs/$target
  dictionary=()
  [ "$target" != text ] || dictionary=(-dict=fuzz/words.dict)
  # A find does not end the run: the workers are processes of their own. An input may take 20 s and 4 GB.
  cargo +nightly fuzz run --sanitizer none "$target" -- -fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 \
    -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=8192 "${dictionary[@]}" > "$log" 2>&1 || true
  last=$(grep -E '^#[0-9]+: cov:' "$log" | tail -n 1)
  [ -n "$last" ] || { cat "$log"; exit 1; }
  read -r executions coverage finds took < <(sed -E 's|^#([0-9]+): cov: ([0-9]+) .* oom/timeout/crash: ([0-9/]+) time: ([0-9]+)s.*|\1 \2 \3 \4|' <<< "$last")
  echo "$target: $executions executions in $took s, $((executions / took)) a second; coverage $coverage; out of memory/too slow/wrong $finds"
  [ "$finds" = 0/0/0 ] || status=1
done
exit $status
