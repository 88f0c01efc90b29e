#!/bin/sh
# Makes the Debian package, installs it in a root of Debian 12 that has nothing else, and runs pipe
# A2 there.   package.sh BUILD WORK
set -eu
build=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
(cd "$build" && cpack -G DEB -B "$work" >/dev/null)
lintian --fail-on error --suppress-tags bogus-mail-host-in-debian-changelog "$work"/plica_*.deb
root=$work/root
mirror=$(apt-get indextargets --format '$(REPO_URI)' | head -1)
debootstrap --variant=minbase --include=ca-certificates bookworm "$root" "$mirror" >"$work/debootstrap.log"
cp -r /etc/apt/. "$root/etc/apt/"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp "$work"/plica_*.deb "$root/plica.deb"
chroot "$root" sh -c "apt-get update -qq && apt-get install -y -qq --no-install-recommends /plica.deb" >"$work/install.log" 2>&1
chroot "$root" plica --version
chroot "$root" plica run /usr/share/plica/cases/bellow_a2 --no-variants --no-error-bars --out /tmp/a2
grep -q '"passed": true' "$root/tmp/a2/results.json"
chroot "$root" plica check /usr/share/plica/cases/pipe_with_bracket # starts the installed mesher
test -s "$root/usr/share/man/man1/plica.1" || test -s "$root/usr/share/man/man1/plica.1.gz"
rm -rf "$root"
