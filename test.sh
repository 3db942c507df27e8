#!/bin/bash
# Builds Regarment and passes its tests on a bare Debian 12:
#   all tests, optimised, and again with the address and undefined-behaviour sanitizers;
#   the libFuzzer targets for half a minute each; the form of the source; clang-tidy on what changed.
# test.sh --full  fuzzes ten minutes a target, runs the thread sanitizer, clang-tidy on everything,
#                 the package on a bare system, a batch by Slurm, the service killed, Blender, a
#                 bench.
# The last line is "N passed, N failed".
set -u
cd "$(dirname "$0")" || exit 1

full=no
case "${1:-}" in
  "") ;;
  --full) full=yes ;;
  *) echo "test.sh: '$1' is no option; the only one is --full" >&2; exit 2 ;;
esac
passed=0
failed=0
jobs=$(nproc)

headline() { printf '\n== %s\n' "$1"; }

# check NAME COMMAND...: a step that counts as one test.
check() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
    echo "passed: $name"
  else
    failed=$((failed + 1))
    echo "FAILED: $name"
  fi
}

# try NAME COMMAND...: the same for one that may leave with 77, which is neither.
try() {
  "${@:2}"
  local status=$?
  if [ "$status" = 77 ]; then echo "skipped: $1"; else check "$1" test "$status" = 0; fi
}

# build PRESET [TARGETS]: false, and one failure, when it does not build.
build() {
  headline "build $1"
  local preset=$1 log="build-$1.log" target=()
  shift
  [ $# = 0 ] || target=(--target "$@")
  if cmake --preset "$preset" >"$log" 2>&1; then
    rm -f "$log"
    cmake --build --preset "$preset" "${target[@]}" && return 0
  else
    cat "$log"
    rm -f "$log"
  fi
  failed=$((failed + 1))
  echo "FAILED: build $preset"
  return 1
}

attribute() { sed -n "s/.*<testsuite .*[[:space:]]$2=\"\([0-9]*\)\".*/\1/p; s/^[[:space:]]*$2=\"\([0-9]*\)\".*/\1/p" "$1" | head -1; }

# run_tests PRESET [CTEST OPTIONS]: adds what CTest counted. A skipped test is not a passed one.
run_tests() {
  local preset=$1
  shift
  headline "test $preset"
  local summary="$PWD/build/$preset/tests.xml"
  rm -f "$summary"
  ctest --test-dir "build/$preset" -j "$jobs" --output-junit "$summary" --output-on-failure "$@" \
    </dev/null | grep -v -E '^ *([0-9]+/[0-9]+ Test .* Passed|Start +[0-9]+:)'
  if [ ! -s "$summary" ]; then
    failed=$((failed + 1))
    return
  fi
  local tests bad skipped
  tests=$(attribute "$summary" tests)
  bad=$(attribute "$summary" failures)
  skipped=$(attribute "$summary" skipped)
  echo "$preset: $tests tests, $bad failed, $skipped skipped"
  passed=$((passed + tests - bad - skipped))
  failed=$((failed + bad))
}

format_is_right() {
  git ls-files '*.h' '*.cpp' | xargs clang-format-14 --dry-run --Werror
}

# What differs from main elsewhere, or, on main itself, the last commit.
changed_sources() {
  local base
  base=$(git merge-base HEAD origin/main 2>/dev/null || true)
  if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
    base=$(git rev-parse -q --verify 'HEAD~1' || git hash-object -t tree /dev/null)
  fi
  git diff --name-only --diff-filter=d "$base" -- '*.cpp'
}

# Without precompiled headers, which clang-tidy cannot read. What changed is looked at without the
# analyzer, which doubles the time; everything, with --full, with it.
tidy_is_clean() {
  cmake --preset release -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null || return 1
  local sources known checks=()
  if [ "$full" = yes ]; then
    sources=$(git ls-files '*.cpp')
  else
    sources=$(changed_sources | head -40)
    checks=(--checks=-clang-analyzer-*)
  fi
  known=$(sed -n "s#^ *\"file\": \"$PWD/\(.*\)\".*#\1#p" build/tidy/compile_commands.json)
  sources=$(printf '%s\n' "$sources" | grep -x -F "$known" || true)
  [ -z "$sources" ] || printf '%s\n' "$sources" |
    xargs -n 1 -P "$jobs" clang-tidy-14 -p build/tidy --quiet --warnings-as-errors='*' \
      "${checks[@]}" 2>/dev/null
}

# The targets tests/fuzz declares; only these are compiled with the fuzzer.
fuzz_targets() {
  cmake --preset fuzz >/dev/null && ninja -C build/fuzz -t targets all |
    sed -n 's/^\(fuzz_[a-z_]*\): .*EXECUTABLE.*/\1/p; s/^\(fuzz_[a-z_]*\): phony$/\1/p' | sort -u
}

# fuzz_long TARGETS: ten minutes each, beyond the half minute CTest gives them.
fuzz_long() {
  local target
  for target in "$@"; do
    check "$target, 600 s" "build/fuzz/$target" -max_total_time=600 -timeout=10 \
      -rss_limit_mb=1024 -verbosity=0 "-artifact_prefix=build/fuzz/" "build/fuzz/corpus/$target"
  done
}

# What Debian does not have; without npm the tests that want it are skipped.
install_validators() {
  command -v npm >/dev/null || { echo "no npm: neither GLB files nor the API's description are validated" >&2; return; }
  npm ci --silent --prefix tests/exports || echo "npm failed: GLB files are not validated" >&2
  npm ci --silent --prefix tests/service || echo "npm failed: the API's description is not validated" >&2
}

scripts/install_packages.sh build test || exit 1
[ "$full" = no ] || scripts/install_packages.sh full || exit 1
install_validators

build release && run_tests release && check "installed library and package" tests/package/library.sh
build asan && run_tests asan
[ "$full" = no ] || { build tsan && run_tests tsan; }
mapfile -t fuzzers < <(fuzz_targets)
build fuzz "${fuzzers[@]}" && run_tests fuzz -L fuzz
[ "$full" = no ] || fuzz_long "${fuzzers[@]}"
[ "$full" = no ] || check "package on a bare system" tests/package/bare_system.sh
[ "$full" = no ] || check "image" tests/package/image.sh
[ "$full" = no ] || try "a batch by Slurm, killed part by part" \
  python3 tests/slurm/slurm_test.py build/release/regarment examples/data
[ "$full" = no ] || check "a campaign by every engine, killed part by part" \
  python3 tests/campaign/campaign_test.py build/release 500 20
[ "$full" = no ] || check "the service killed 5 times, its workers 50" \
  python3 tests/service/chaos_test.py build/release/regarment 200 5 50
[ "$full" = no ] || try "an exported garment as Blender's cloth" \
  tests/exports/blender_cloth.sh build/release/regarment examples/data/skirt-1.mesh.ply
[ "$full" = no ] || check "a bench of a person made for it" \
  python3 tests/bench/bench_command_test.py build/release/regarment
headline "form"
check "clang-format" format_is_right
check "clang-tidy" tidy_is_clean

printf '\n%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
