#!/bin/sh
# The decks as they are made: none names a network address, and in Chromium everything shows and fits.
# Skipped until ./course slides has installed Marp: a test installs nothing.
set -eu
home=build/slides
skip() { echo "skipped: $*"; exit 77; }
command -v node >/dev/null || skip "node is not installed"
cmp -s slides/package-lock.json "$home/installed" || skip "Marp is not installed yet; ./course slides does that"

made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$home/node_modules/.bin/marp" --no-stdin --config-file slides/marp.config.mjs --input-dir slides --output "$made" \
    >"$made/log" 2>&1 || { cat "$made/log"; exit 1; }
node slides/index.mjs "$made"
for deck in slides/*.md; do
    [ -s "$made/$(basename "$deck" .md).html" ] || { echo "$deck was not made"; exit 1; }
done
if grep -noE '(src|href|poster|data)="?https?:[^"]{0,60}|url\(["'\'']?https?:[^)]{0,60}|@import[^;]{0,60}' "$made"/*.html; then
    echo "a deck names a network address"
    exit 1
fi
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$chromium" ] || { echo "made without network addresses; Chromium is not installed, so nobody has looked"; exit 0; }
CHROMIUM=$chromium node tests/slides/overflow.mjs "$home" "$made"/[0-9]*.html
