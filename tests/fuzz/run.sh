#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the fuzzers and runs each for so many seconds, 30 by default; for hours by hand. What they
# learn stays in build/asan/corpus, so that the next run goes on from there. A text that breaks
# something is written to build/asan as crash-*, slow-* or timeout-*; pass it as an argument to the
# fuzzer to see it again, and keep it in tests/fuzz/found once it is mended: each run begins with
# those.
#
#   tests/fuzz/run.sh 3600
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."

seconds=${1:-30}
if ! [[ $seconds =~ ^[1-9][0-9]*$ ]]; then
    echo "usage: tests/fuzz/run.sh [SECONDS]" >&2
    exit 2
fi

cmake --preset asan && cmake --build --preset asan --target crevice_fuzzers

out=build/asan
seeds=$out/seeds
rm -rf -- "$seeds"
mkdir -p "$seeds"
for file in configs/*.json configs/*/*.json effects/*/*.json tests/fuzz/{seeds,found}/*; do
    if [[ -f $file ]]; then cp -- "$file" "$seeds/${file//\//_}"; fi
done
# Baked effects, where this machine's build can make them.
crevice=${CREVICE:-build/ci/tools/crevice}
for config in mobile+geometry/host_depth gtao balanced_temporal; do
    [[ ! -x $crevice ]] || "$crevice" bake "$config" --out "$seeds/${config//\//_}.crevice" 2>/dev/null
done
# The malformed configs, as tests/support/bad_corpus.h describes their files.
for group in tests/data/bad/*.txt; do
    LC_ALL=C awk -v out="$seeds/$(basename "$group" .txt)_" '
        function finish() {
            if (name == "around") {
                head = substr(body, 1, index(body, "...\n") - 1)
                foot = substr(body, length(head) + 5)
            }
            else if (name ~ /json$/) printf "%s", case_ ? head body foot : body > out name
            body = ""
        }
        /^(---|===) / { finish(); case_ = /^---/; name = $2 (case_ ? ".json" : ""); gsub("/", "_", name); next }
        { body = body $0 "\n" }
        END { finish() }' "$group"
done

# Every word of the format and all that the seeds have in quotes, for libFuzzer to combine.
grep -ohE '"[a-z_.]+"' docs/config.schema.json "$seeds"/*.json | sort -u | sed -E 's/"(.*)"/"\\"\1\\""/' > "$out/words.dict"

for fuzzer in document config baked; do
    printf '\n-- %s, %s s\n' "$fuzzer" "$seconds"
    mkdir -p "$out/corpus/$fuzzer"
    "$out/tests/fuzz/crevice_fuzz_$fuzzer" -max_total_time="$seconds" -timeout=10 -max_len=32768 \
        -dict="$out/words.dict" -artifact_prefix="$out/" -print_final_stats=1 \
        "$out/corpus/$fuzzer" "$seeds" 2>&1 | grep -vE '^(#|"|INFO|[[:space:]]*NEW_FUNC)'
done
