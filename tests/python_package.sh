#!/bin/sh
# The Debian package python3-plica: made, taken apart, used from where it would be installed, alone
# in its folder.   python_package.sh BUILD PLICA WORK
set -eu
build=$1 work=$3
export PLICA="$2" MPLBACKEND=agg
rm -rf "$work"
mkdir -p "$work"
(cd "$build" && cpack -G DEB -B "$work" -D CPACK_COMPONENTS_ALL=python >/dev/null)
package=$(ls "$work"/python3-plica_*_all.deb)
dpkg-deb --field "$package" Depends | grep -q 'python3-numpy'
dpkg-deb --extract "$package" "$work/root"
installed=$work/root/usr/lib/python3/dist-packages
cd "$work"
PYTHONPATH=$installed PYTHONDONTWRITEBYTECODE=1 ${PYTHON:-/usr/bin/python3} - "$installed" <<'END'
import importlib.metadata
import sys
from pathlib import Path
import plica
assert Path(plica.__file__).is_relative_to(sys.argv[1]), plica.__file__
assert importlib.metadata.version("plica") == plica.__version__
examples = Path(sys.argv[1]).parents[2] / "share" / "doc" / "python3-plica" / "examples"
results = plica.run(examples / "cases" / "decoupler.yaml", "out", no_variants=True)
results.plot().figure.savefig("first.png")
print(f"{plica.__file__}: first axial mode {results.headline['f_axial']:.1f} Hz")
END
test -s first.png
