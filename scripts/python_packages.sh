#!/usr/bin/env bash
# Makes .venv and installs the locked Python packages, each checked against its hash.
# Usage: scripts/python_packages.sh run|test
# Does nothing when the lock files are those of the last installation.
set -euo pipefail
purpose=${1:?run or test}
cd "$(dirname "$0")/.."

fail() { printf 'lanewright: %s\n' "$*" >&2; exit 2; }

exec 9>.venv.lock
flock 9 # a second make waits here, and then finds all installed

venv_key="$PWD $(python3 -c 'import sys; print(sys.version)')" # scripts in .venv hold its path: a moved one is useless
if [ ! -x .venv/bin/python ] || [ "$(cat .venv/.made-for 2>/dev/null)" != "$venv_key" ]; then
  echo 'Making .venv'
  python3 -m venv --clear .venv || fail "python3 -m venv failed: install the package python3-venv (or Python 3.11 or later), then run make again."
  printf '%s' "$venv_key" >.venv/.made-for
fi

locks=(requirements-uv.txt requirements.txt pyproject.toml)
[ "$purpose" = run ] || locks+=(requirements-dev.txt requirements-av2.txt)
key=$(sha256sum "${locks[@]}")
[ "$(cat ".venv/.installed-$purpose" 2>/dev/null)" != "$key" ] || exit 0
rm -f .venv/.installed-* # what was installed for the other purpose may change below

echo "Installing Python packages from the lock files ($purpose)"
retry() { "$@" || { echo "Trying once more: $*"; "$@"; }; } # networks hiccup
unreachable='Python packages could not be installed: check the network (pip config list shows the index in use), then run make again.'
retry .venv/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-uv.txt || fail "$unreachable"
uv() { .venv/bin/uv pip install --quiet --python .venv/bin/python "$@"; }
if [ "$purpose" = run ]; then
  retry uv --require-hashes -r requirements.txt || fail "$unreachable"
else
  retry uv --require-hashes -r requirements-dev.txt || fail "$unreachable"
  # The av2 library proper drags in 6.5 GB of torch; the tests need only its map reader, whose needs are in requirements-dev.
  retry uv --require-hashes --no-deps -r requirements-av2.txt || fail "$unreachable"
fi
uv --no-deps --no-build-isolation -e .
[ "$purpose" = run ] || sha256sum requirements-uv.txt requirements.txt pyproject.toml >.venv/.installed-run
printf '%s\n' "$key" >".venv/.installed-$purpose"
