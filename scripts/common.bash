# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the scripts beside it: where things are, how to speak, how to become root.
# shellcheck shell=bash
set -euo pipefail

script_name=$(basename "$0")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build_dir=${MGF_BUILD_DIR:-$root/build}
stage_dir=$build_dir/stage

say() { printf '%s: %s\n' "$script_name" "$*"; }
die() {
  printf '%s: %s\n' "$script_name" "$*" >&2
  exit 1
}

# retry COUNT COMMAND...: package mirrors now and then lack a file for some seconds.
retry() {
  local left=$1
  shift
  until "$@"; do
    left=$((left - 1))
    ((left > 0)) || return 1
    say "failed, trying again: $*"
    sleep 5
  done
}

# as_root COMMAND...: never waits for an answer that nobody can give.
as_root() {
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
    sudo "$@"
  else
    die "this needs root, and sudo is missing or wants a password; as root run: $*"
  fi
}
