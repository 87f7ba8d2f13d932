#!/usr/bin/env bash
# bundle_test.sh WEB COMMITTED: what the page's source makes, byte for byte, is the bundle
# in the repository; and its lock file names no host, so that any registry will do.
set -euo pipefail
web=$1 committed=$2
if grep -n '"resolved"' "$web/package-lock.json"; then
  echo 'package-lock.json names where packages were loaded from' >&2
  exit 1
fi
cd "$web"
npm run --silent build
diff -r dist "$committed" ||
  { echo 'explorer/web/dist is out of date: npm run build in explorer/web' >&2; exit 1; }
