#!/usr/bin/env bash
# Installs the Debian packages that porowave needs and that are missing; see usage below.
set -euo pipefail

usage() {
  cat <<'END'
Usage: install-deps.sh [--dev] [--package] [--check]
Installs what is missing on Debian 12 to build, test and run porowave.
  --dev      also what developers use: clang and its OpenMP, clang-format, clang-tidy, shellcheck, valgrind
  --package  also what cpack needs to make the .deb
  --check    install nothing; name what is missing, exit 1 if something is
Exit codes: 0 all there; 1 --check found something missing; 2 wrong usage; 5 cannot install.
END
}

say() { echo "install-deps: $*"; }
fail() { say "$@" >&2; exit 5; }

packages=(g++ cmake make pkg-config libeigen3-dev libgsl-dev libfftw3-dev libboost-dev
          libboost-test-dev librapidcheck-dev libbenchmark-dev libtomlplusplus-dev
          libcli11-dev nlohmann-json3-dev libfmt-dev libsqlite3-dev fonts-dejavu-core)
# gnuplot-nox would replace gnuplot-qt or gnuplot-x11, and any of them will do.
command -v gnuplot >/dev/null || packages+=(gnuplot-nox)

check=no
for option in "$@"; do
  case $option in
    --dev) packages+=(clang clang-14 libclang-rt-14-dev libomp-14-dev clang-format-14 clang-tidy
                     shellcheck valgrind) ;;
    --package) packages+=(dpkg-dev file) ;;  # cpack finds the .deb's dependencies with them
    --check) check=yes ;;
    -h | --help) usage; exit 0 ;;
    *) say "unknown option $option" >&2; usage >&2; exit 2 ;;
  esac
done

type dpkg-query apt-get >/dev/null 2>&1 ||
  fail "this system has no apt. Install what corresponds to: ${packages[*]}"

# dpkg-query fails for a package it has never heard of; that one is simply not in its list.
installed=$(dpkg-query -W -f='${db:Status-Status}:${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qxF "installed:$package" <<<"$installed" || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
  say "nothing to install"
  exit 0
fi
if [[ $check == yes ]]; then
  say "missing: ${missing[*]}"
  exit 1
fi

as_root=()
if ((EUID != 0)); then
  { command -v sudo && sudo true; } >/dev/null ||  # asks for the password here, if at all
    fail "needs root or sudo. Ask an administrator for: apt-get install ${missing[*]}"
  as_root=(sudo)
fi

# --no-remove: better no porowave than a system that has lost something.
# The lock is often held for a while on a machine that has just booted.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0
     -o DPkg::Lock::Timeout=120)
log=$(mktemp)
trap 'rm -f "$log"' EXIT
say "installing ${missing[*]}"
"${apt[@]}" update >"$log" 2>&1 || say "apt-get update failed, trying with the lists at hand" >&2
if ! "${apt[@]}" install -y --no-install-recommends --no-remove "${missing[@]}" >>"$log" 2>&1; then
  tail -n 20 "$log" >&2
  fail "apt-get failed, see above. Check network, disk space and apt's sources (Debian 12 has all" \
       "packages), then run this again, or by hand: apt-get install ${missing[*]}"
fi
say "installed ${#missing[@]} packages and what they depend on in $SECONDS s"
