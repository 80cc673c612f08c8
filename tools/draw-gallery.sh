#!/bin/sh
# Draws the pictures of README.md's gallery with the commands in models/gallery/README.md. `make gallery` calls it.
#
# tools/draw-gallery.sh [FOLDER]    (default: models/gallery)
set -eu
cd "$(dirname "$0")/.."
build=$(cd "${ROBERTS_BUILD:-build}" && pwd)
mkdir -p "${1:-models/gallery}"
folder=$(cd "${1:-models/gallery}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
ln -s "$PWD/models" "$work/models"
sed -n 's/^roberts .*/&/p' models/gallery/README.md >"$work/commands"
cd "$work"
PATH=$build:$PATH sh -e commands
mv ./*.svg "$folder"
