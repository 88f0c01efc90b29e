#!/bin/sh
# Opens a report in the browser of a desktop; elsewhere says where it is.
set -eu
report=$(realpath "$1")
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && command -v xdg-open >/dev/null 2>&1; then
  xdg-open "$report" >/dev/null 2>&1 || echo "Open $report in a browser."
else
  echo "Open $report in a browser."
fi
