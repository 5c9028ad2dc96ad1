#!/usr/bin/env bash
# Proves both commands on a machine that has nothing: a new Debian in a folder, and in it a clean clone below a folder
# closed to others, as root, with a new HOME and no caches. Prints what each step took.
# Usage (as root, on Debian with debootstrap): scripts/prove_fresh.sh FOLDER [run|all]
#   run: make run, twice. all (default): also make check and make test, then all of it once more.
set -euo pipefail
folder=$(realpath -m "${1:?a folder that is not there yet}")
extent=${2:-all}
source=$(cd "$(dirname "$0")/.." && pwd)
machine=$folder/machine
clone=/srv/closed/lanewright # as seen from inside

[ "$(id -u)" -eq 0 ] || { echo 'prove_fresh.sh needs root: it makes a Debian of its own.' >&2; exit 2; }
[ ! -e "$folder" ] || { echo "$folder exists: name a folder that is not there yet." >&2; exit 2; }
command -v debootstrap >/dev/null || { echo 'Install the package debootstrap first.' >&2; exit 2; }

times=()
step() { # name, command...
  local name=$1 began=$SECONDS status=0
  shift
  printf '\n== %s\n' "$name"
  "$@" || status=$?
  times+=("$(printf '%-32s %5d s  %s' "$name" "$((SECONDS - began))" "$([ "$status" -eq 0 ] && echo ok || echo "FAILED ($status)")")")
  return "$status"
}
report() { printf '\n== times\n'; printf '%s\n' "${times[@]}"; }
trap report EXIT

new_debian() {
  local mirror release
  # the mirror and release that this machine itself uses
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1)
  release=$(. /etc/os-release && echo "$VERSION_CODENAME")
  mkdir -p "$folder"
  debootstrap --variant=minbase --include=make,git,ca-certificates "$release" "$machine" "$mirror" >"$folder/debootstrap.log"
  # The way to the network is the machine's, not the product's: sources, certificates, names.
  rm -rf "$machine/etc/apt/sources.list" "$machine/etc/apt/sources.list.d"
  cp -a /etc/apt/sources.list* "$machine/etc/apt/"
  [ ! -e /etc/pip.conf ] || cp /etc/pip.conf "$machine/etc/"
  cp -aL /etc/ssl/certs/ca-certificates.crt "$machine/etc/ssl/certs/"
  cp -L /etc/resolv.conf /etc/hosts "$machine/etc/"
}

clean_clone() {
  install -d -m 0700 "$machine/srv/closed" "$machine/srv/closed/home"
  git clone --quiet --no-hardlinks "$source" "$machine$clone"
  [ ! -d "$source/../shared" ] || cp -a "$source/../shared" "$machine/srv/closed/shared"
}

inside() { # runs a line of shell in the clone, in namespaces of its own; what it leaves running ends with it
  local certificates=/etc/ssl/certs/ca-certificates.crt
  unshare --mount --pid --fork --kill-child -- bash -euc '
    mount --bind "$1" "$1"
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    cd "$1"
    mkdir -p .before
    pivot_root . .before # not chroot, which forbids user namespaces
    umount -l .before
    exec env -i HOME=/srv/closed/home PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      LANG=C.UTF-8 CI=true PIP_CERT="$3" SSL_CERT_FILE="$3" NODE_EXTRA_CA_CERTS="$3" NPM_CONFIG_CAFILE="$3" \
      bash -euc "cd $2; $4"
  ' bash "$machine" "$clone" "$certificates" "$1" 2>&1 | with_seconds
}

with_seconds() {
  local began=$SECONDS line
  while IFS= read -r line; do printf '%5d s  %s\n' "$((SECONDS - began))" "$line"; done
}

# Starts it, asks it over HTTP, and stops it as Ctrl-C does.
run_once='
  make run & run=$!
  for _ in $(seq 1800); do
    if [ -x .venv/bin/python ] && .venv/bin/python -c "import urllib.request as r; print(r.urlopen(\"http://127.0.0.1:8000/readyz\").read().decode())" 2>/dev/null; then break; fi
    kill -0 $run || exit 1
    sleep 0.5
  done
  make stop
  wait $run'

step 'new Debian' new_debian
step 'clean clone' clean_clone
step 'make run, first time' inside "$run_once"
step 'make run, second time' inside "$run_once"
[ "$extent" = all ] || exit 0
for time in first second; do
  step "install for tests, $time time" inside 'make install-test'
  step "make check, $time time" inside 'make check'
  step "Python tests, $time time" inside "make test-python PYTEST_ARGS='-m \"not browser\"'"
  step "browser tests, $time time" inside "make test-python PYTEST_ARGS='-m browser'"
  step "frontend tests, $time time" inside 'make test-frontend'
done
step 'make run, third time' inside "$run_once"
