#!/bin/bash
# Builds Regarment and passes its tests on a bare Debian 12:
#   all tests, optimised, and again with the address and undefined-behaviour sanitizers;
#   the libFuzzer targets for half a minute each; the form of the source; clang-tidy on what changed.
# test.sh --full  fuzzes ten minutes a target, runs the thread sanitizer, clang-tidy on everything.
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

# build PRESET: false, and one failure, when it does not build.
build() {
  headline "build $1"
  if cmake --preset "$1" >"build-$1.log" 2>&1; then
    rm -f "build-$1.log"
    cmake --build --preset "$1" && return 0
  else
    cat "build-$1.log"
    rm -f "build-$1.log"
  fi
  failed=$((failed + 1))
  echo "FAILED: build $1"
  return 1
}

attribute() { sed -n "s/.*<testsuite .*[[:space:]]$2=\"\([0-9]*\)\".*/\1/p; s/^[[:space:]]*$2=\"\([0-9]*\)\".*/\1/p" "$1" | head -1; }

# run_tests PRESET: adds what CTest counted.
run_tests() {
  headline "test $1"
  local summary="$PWD/build/$1/tests.xml"
  rm -f "$summary"
  ctest --preset "$1" -j "$jobs" --output-junit "$summary" --output-on-failure --progress </dev/null |
    grep -v -E '^\s*[0-9]+/[0-9]+ Test .*(Passed|Skipped)' || true
  if [ ! -s "$summary" ]; then
    failed=$((failed + 1))
    return
  fi
  local tests bad skipped
  tests=$(attribute "$summary" tests)
  bad=$(attribute "$summary" failures)
  skipped=$(attribute "$summary" skipped)
  echo "$1: $tests tests, $bad failed, $skipped skipped"
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

# Without precompiled headers, which clang-tidy cannot read.
tidy_is_clean() {
  cmake --preset release -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null || return 1
  local sources known
  if [ "$full" = yes ]; then sources=$(git ls-files '*.cpp'); else sources=$(changed_sources | head -40); fi
  known=$(sed -n "s#^ *\"file\": \"$PWD/\(.*\)\".*#\1#p" build/tidy/compile_commands.json)
  sources=$(printf '%s\n' "$sources" | grep -x -F "$known" || true)
  [ -z "$sources" ] || printf '%s\n' "$sources" |
    xargs -n 1 -P "$jobs" clang-tidy-14 -p build/tidy --quiet --warnings-as-errors='*' 2>/dev/null
}

fuzz() {
  local seconds=30 target name
  [ "$full" = yes ] && seconds=600
  for target in build/fuzz/*_fuzz; do
    [ -x "$target" ] || continue
    name=$(basename "$target")
    mkdir -p "build/fuzz/corpus/$name"
    local seeds=()
    [ -d "tests/fuzz/corpus/$name" ] && seeds=("tests/fuzz/corpus/$name")
    check "$name, $seconds s" "$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
      -verbosity=0 -print_final_stats=0 -artifact_prefix="build/fuzz/" \
      "build/fuzz/corpus/$name" "${seeds[@]}"
  done
}

scripts/install_packages.sh build test || exit 1

build release && run_tests release
build asan && run_tests asan
[ "$full" = no ] || { build tsan && run_tests tsan; }
headline "fuzz"
build fuzz && fuzz
headline "form"
check "clang-format" format_is_right
check "clang-tidy" tidy_is_clean

printf '\n%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
