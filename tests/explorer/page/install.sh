#!/usr/bin/env bash
# install.sh SOURCE TARGET: a copy of the page's source with what its lock file names, so
# that the source tree stays as it is. What is installed already stays.
set -euo pipefail
source=$1 target=$2
mkdir -p "$target"
cp -r "$source"/{.npmrc,index.html,package.json,package-lock.json,tsconfig.json,vite.config.js} "$target"
rm -rf "$target/src" "$target/public"
cp -r "$source"/{src,public} "$target"
cd "$target"
if ! cmp -s package-lock.json node_modules/.installed; then
  npm ci --ignore-scripts
  cp package-lock.json node_modules/.installed
fi
