#!/bin/sh
# Print the path of a Chromium for the browser tests. Where there is none and we may install, install one.
# Prints nothing when none can be had; the tests then say so and are skipped.
set -u

find_one() {
  for candidate in "${CHROMIUM:-}" chromium chromium-browser google-chrome google-chrome-stable; do
    if [ -n "$candidate" ] && command -v "$candidate" > /dev/null 2>&1; then
      command -v "$candidate"
      return 0
    fi
  done
  return 1
}

find_one && exit 0
if [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null 2>&1; then
  {
    echo "No Chromium found: installing one for the browser tests."
    apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends chromium
  } >&2
  find_one && exit 0
fi
echo "No Chromium found and none could be installed; the browser tests will be skipped." >&2
exit 0
