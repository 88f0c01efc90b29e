#!/bin/sh
# The Python package: flake8, mypy, tests with every notebook.   python_checks.sh PLICA WORK [PART]
# PART `notebooks`: these alone; `tests`: all but these, so that both can go side by side.
set -eu
plica=$1 work=$2 part=${3:-all}
source=$(cd "$(dirname "$0")/../python" && pwd)
python=${PYTHON:-/usr/bin/python3}
mkdir -p "$work"
cd "$source"
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$source" PLICA="$plica" MPLCONFIGDIR="$work/matplotlib"
case $part in
  all) set -- ;;
  tests) set -- --ignore=tests/test_notebooks.py ;;
  notebooks) set -- tests/test_notebooks.py ;;
  *) echo "python_checks.sh: $part is no part; tests or notebooks" >&2; exit 2 ;;
esac
if [ "$part" != notebooks ]; then
  "$python" -m flake8 .
  "$python" -m mypy --cache-dir "$work/mypy"
fi
"$python" -m pytest -p no:cacheprovider --basetemp "$work/pytest" "$@"
