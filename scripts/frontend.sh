#!/usr/bin/env bash
# Installs the frontend's locked packages, builds it, or runs one of its scripts.
# Usage: scripts/frontend.sh build | SCRIPT (a script of frontend/package.json)
# Installs and builds nothing when neither lock file nor sources changed. Comes after scripts/python_packages.sh.
set -euo pipefail
task=${1:?build, or a script of frontend/package.json}
cd "$(dirname "$0")/../frontend"

fail() { printf 'lanewright: %s\n' "$*" >&2; exit 2; }

node_fits() { # the versions that vite runs on
  node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 22 || (a === 22 && b >= 12) || (a === 20 && b >= 19) ? 0 : 1)' 2>/dev/null &&
    command -v npm >/dev/null
}

log=../.lanewright/logs/frontend.log
quietly() { mkdir -p "$(dirname "$log")" && "$@" >"$log" 2>&1; }

exec 9>../.venv.lock
flock 9 # a second make waits here, and then finds all installed

if ! node_fits; then
  export PATH="$PWD/../.venv/bin:$PATH"
  if ! node_fits; then
    echo 'Installing Node.js into .venv (this system has none, or an older one than 20.19)'
    ../.venv/bin/uv pip install --quiet --python ../.venv/bin/python --require-hashes -r ../requirements-node.txt ||
      fail 'Node.js 20.19 or later is needed and could not be installed: install it with npm, then run make again.'
  fi
fi

key=$(sha256sum package.json package-lock.json .npmrc; node --version)
if [ "$(cat node_modules/.installed 2>/dev/null)" != "$key" ]; then
  echo 'Installing frontend packages from package-lock.json'
  quietly npm ci --no-progress --loglevel=error || { echo 'Trying once more: npm ci'; quietly npm ci --no-progress --loglevel=error; } ||
    fail "npm ci failed: $(head -n 3 "$log" | tr '\n' ' ')... Check the network and package-lock.json (log: $log), then run make again."
  printf '%s\n' "$key" >node_modules/.installed
fi

if [ "$task" = build ]; then
  key=$(find . ../docs/rules \( -name node_modules -o -name dist -o -name coverage \) -prune -o -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum)
  { [ ! -f dist/index.html ] || [ "$(cat node_modules/.built 2>/dev/null)" != "$key" ]; } || exit 0
  echo 'Building the frontend'
  quietly npm run --silent build || { cat "$log" >&2; fail 'the frontend does not build: see above.'; }
  printf '%s\n' "$key" >node_modules/.built
else
  npm run --silent "$task"
fi
