#!/bin/sh
# The Python package: flake8, mypy, tests with every notebook.   python_checks.sh PLICA WORK
set -eu
plica=$1 work=$2
source=$(cd "$(dirname "$0")/../python" && pwd)
python=${PYTHON:-/usr/bin/python3}
mkdir -p "$work"
cd "$source"
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$source" PLICA="$plica" MPLCONFIGDIR="$work/matplotlib"
"$python" -m flake8 .
"$python" -m mypy --cache-dir "$work/mypy"
"$python" -m pytest -p no:cacheprovider --basetemp "$work/pytest"
