#!/bin/sh
# Installs the Debian packages of packages.txt that are missing; says what to do where it may not.
#   install_packages.sh SECTION ...      run, test, check, bench, mpi
set -eu
here=$(dirname "$0")
missing=""
wanted() {
  awk -v sections=" $* " '/^# [a-z]+:/ {on = index(sections, " " substr($2, 1, length($2) - 1) " ")}
                          /^[^#]/ && on {print}' "$here/packages.txt"
}
for package in $(wanted "$@"); do
  [ "$package" = npm ] && command -v npm >/dev/null 2>&1 && continue
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
    missing="$missing $package"
done
[ -z "$missing" ] && exit 0

if [ "$(id -u)" = 0 ]; then
  as_root=""
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
  as_root="sudo"
else
  echo "plica: these packages are missing and you have no right to install them:" >&2
  echo "   $missing" >&2
  echo "Ask an administrator for:  apt-get install$missing" >&2
  exit 1
fi
command -v apt-get >/dev/null 2>&1 || {
  echo "plica: this is not Debian; install the equivalents of:$missing" >&2
  exit 1
}
echo "Installing:$missing"
$as_root apt-get update -qq
DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
