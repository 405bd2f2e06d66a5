# shellcheck shell=bash
# What the scripts beside this file share. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; }

# quietly <command...>: shows what the command printed only if it fails, and then fails alike.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" -ne 0 ]; then
    grep -vE '^\[[0-9]+/[0-9]+\] (Building|Linking)' "$log" >&2 || true
    say "failed with exit code $status: $*"
  fi
  rm -f "$log"
  return "$status"
}

# configure_preset <preset> [-D...]: with ccache if it is here. The launcher is set either way, so that a
# build folder survives the removal of ccache.
configure_preset() {
  local launcher=${CMAKE_CXX_COMPILER_LAUNCHER-$(command -v ccache || true)}
  # who builds all and changes nothing, saves by compiling several sources as one, and debugs nothing
  local once=()
  [ -z "${CI-}" ] || once=(-DTAUTLINE_UNITY=ON -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2)
  quietly cmake -S "$root" --preset "$1" "-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher" "${once[@]}" "${@:2}"
}

# fetch_from_npm <folder> <consequence of doing without>: brings what the folder's package.json pins. A
# machine may have no way to npm's registry: that is said, and is no failure.
fetch_from_npm() {
  local folder=$root/$1
  if cmp --silent "$folder/package-lock.json" "$folder/node_modules/.fetched"; then
    return
  fi
  say "npm ci in $1"
  if command -v npm >/dev/null && quietly npm ci --prefix "$folder" --ignore-scripts --no-audit --no-fund; then
    cp "$folder/package-lock.json" "$folder/node_modules/.fetched"
  else
    say "npm brought nothing to $1: $2"
  fi
}

# build_preset <preset> [-D...]
build_preset() {
  fetch_from_npm bench/page "the report page will have no charts"
  say "configure and build ($1, in build/$1; the first time takes minutes)"
  configure_preset "$@"
  quietly cmake --build "$root/build/$1"
}

# tool <name> <pinned version>: prints the command to call; another version is named, not hidden.
tool() {
  if command -v "$1-$2" >/dev/null; then
    echo "$1-$2"
  elif command -v "$1" >/dev/null; then
    say "$1-$2 is not here; $("$1" --version | grep -o 'version [0-9.]*' | head -n 1) may disagree"
    echo "$1"
  else
    say "$1-$2 is not here; see scripts/packages.txt"
    return 1
  fi
}
