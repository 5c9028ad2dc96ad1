#!/usr/bin/env bash
# Installs the Debian packages that are missing: PostgreSQL with PostGIS, Python's venv, and Chromium for the tests.
# With DATABASE_URL set, running needs PostgreSQL's client programs only.
# Usage: scripts/debian_packages.sh run|test
# Does nothing (in a few milliseconds) when all is there. Without the right to install, says the command to run.
set -euo pipefail
purpose=${1:?run or test}

fail() { printf 'lanewright: %s\n' "$*" >&2; exit 2; }

has_postgis() { # a server whose extension folder holds PostGIS: the same search as lanewright.cluster.programs
  [ -n "${LANEWRIGHT_POSTGRES_BIN:-}" ] && return 0
  compgen -G '/usr/lib/postgresql/*/bin/initdb' >/dev/null &&
    compgen -G '/usr/share/postgresql/*/extension/postgis.control' >/dev/null && return 0
  command -v pg_config >/dev/null && [ -f "$(pg_config --sharedir)/extension/postgis.control" ]
}

has_python() { python3 -c 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; }

has_chromium() { [ -x "${LANEWRIGHT_CHROMIUM:-/usr/bin/chromium}" ]; }

wants=()
has_python || wants+=(python3 python3-venv)
if [ -n "${DATABASE_URL:-}" ] && [ "$purpose" = run ]; then # that server is somebody else's: only backup and psql are needed
  command -v pg_dump >/dev/null || wants+=(postgresql-client)
else
  has_postgis || wants+=(postgis)
fi
if [ "$purpose" = test ]; then
  has_chromium || wants+=(chromium)
  # The program that Playwright drives the browser with needs it, and brings none.
  compgen -G '/usr/lib/*/libatomic.so.1' >/dev/null || wants+=(libatomic1)
fi
[ "${#wants[@]}" -gt 0 ] || exit 0

command -v apt-get >/dev/null ||
  fail "missing: ${wants[*]} (PostgreSQL 15 or later with PostGIS 3, Python 3.11 or later, Chromium), and this system has no apt-get: install them with its package manager, then run make again."

if [ "$(id -u)" -eq 0 ]; then
  as_root=()
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
  as_root=(sudo -n)
else
  fail "missing: ${wants[*]}. Run as root: apt-get update && apt-get install --no-install-recommends ${wants[*]/#postgis/postgresql postgresql-15-postgis-3}; then run make again."
fi

apt() { # noninteractive, and one retry because mirrors hiccup
  local attempt
  for attempt in 1 2; do
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@" >>"$log" 2>&1 && return 0
    [ "$attempt" = 2 ] || printf 'apt-get %s failed once, trying again\n' "$1" >>"$log"
  done
  return 1
}

log=$(mktemp "${TMPDIR:-/tmp}/lanewright-apt.XXXXXX.log")
printf 'Installing Debian packages: %s (log: %s)\n' "${wants[*]}" "$log"
apt update || fail "apt-get update failed (log: $log): check the network and /etc/apt/sources.list, then run make again."

packages=()
for want in "${wants[@]}"; do
  if [ "$want" != postgis ]; then
    packages+=("$want")
    continue
  fi
  # Debian's release decides the version: the one that is installed already, else the newest on offer.
  offered=$(apt-cache pkgnames postgresql- | sed -nE 's/^postgresql-([0-9]+)-postgis-3$/\1/p' | sort -rn)
  [ -n "$offered" ] || fail "this Debian offers no package postgresql-N-postgis-3: add a source that does, or set DATABASE_URL to a PostGIS database."
  version=$(head -n 1 <<<"$offered")
  for candidate in $offered; do
    if [ -x "/usr/lib/postgresql/$candidate/bin/initdb" ]; then version=$candidate; break; fi
  done
  packages+=("postgresql-$version" "postgresql-$version-postgis-3")
  if [ ! -e /etc/postgresql-common/createcluster.conf ]; then
    # Debian would make a cluster of its own and start it on port 5432: Lanewright brings its own, on a socket.
    "${as_root[@]}" mkdir -p /etc/postgresql-common/createcluster.d
    printf 'create_main_cluster = false\n' |
      "${as_root[@]}" tee /etc/postgresql-common/createcluster.d/lanewright.conf >/dev/null
  fi
done
apt install --yes --no-install-recommends "${packages[@]}" ||
  fail "apt-get install ${packages[*]} failed twice (log: $log): mend what it says, then run make again."

has_python || fail "Python 3.11 or later is needed, and this Debian's python3 is older: install a newer one first in PATH."
rm -f "$log"
