#!/bin/sh
# ./course slides [--html]: every deck as one HTML file in out/slides with an index page, and as PDF where Chromium is
# installed (not with --html). Marp makes them. It is installed once, into the build folder; after that no network is needed.
set -u
cd "$(dirname "$0")/.." || exit 2
home=build/slides out=out/slides

say() { printf '%s\n' "$*"; }
fail() { printf 'course: %s\n' "$*" >&2; exit 2; }

with_pdf=yes
case "$#-${1-}" in
0-) ;;
1---html) with_pdf=no ;;
*) fail "slides takes --html or nothing, not '$*'" ;;
esac
mkdir -p "$home" && mkdir -p "$out" && [ -w out ] && [ -w "$out" ] || fail "$out cannot be written"

# ---- What is needed: node, npm for the first time, and Marp in the version that slides/package-lock.json names -------

installed() { cmp -s slides/package-lock.json "$home/installed" && command -v node >/dev/null; }
has_node() { command -v node >/dev/null && command -v npm >/dev/null; }

install_node() {
    as_root=
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null && sudo true || return 0
        as_root=sudo
    fi
    command -v apt-get >/dev/null || return 0
    say "Installing: nodejs npm"
    $as_root apt-get update -qq || say "course: the package lists could not be refreshed" >&2
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends nodejs npm \
        >"$home/packages.log" 2>&1 || true
}

if ! installed; then
    has_node || install_node
    has_node || fail "the slides are made by Marp, which needs node 18 or later and npm: install the packages nodejs and npm"
    node -e 'process.exit(parseInt(process.versions.node) < 18 ? 1 : 0)' ||
        fail "the slides are made by Marp, which needs node 18 or later; this one is $(node --version)"
    say "Installing Marp into $home"
    rm -rf "$home/node_modules" "$home/installed"
    cp slides/package.json slides/package-lock.json slides/.npmrc "$home" || exit 2
    (cd "$home" && npm ci --ignore-scripts) >"$home/install.log" 2>&1 ||
        fail "Marp could not be installed; the first time, that needs the network ($home/install.log)"
    cp slides/package-lock.json "$home/installed" || exit 2
fi

# ---- The decks: made aside, then put in place together ---------------------------------------------------------------

marp() {
    "$home/node_modules/.bin/marp" --no-stdin --config-file slides/marp.config.mjs --input-dir slides \
        --output "$home/new" "$@" >"$home/marp.log" 2>&1
}

rm -rf "$home/new"
say "Making the decks"
marp || { grep -v INFO "$home/marp.log" | head -n 5 >&2; fail "the decks could not be made ($home/marp.log)"; }

chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ "$with_pdf" = no ]; then
    :
elif [ -z "$chromium" ]; then
    say "  Chromium is not installed, so no PDF is made"
else
    say "Making the PDFs"
    [ "$(id -u)" != 0 ] || export CHROME_NO_SANDBOX=1
    CHROME_PATH=$chromium marp --pdf || { rm -f "$home/new"/*.pdf; say "course: the PDFs could not be made ($home/marp.log)" >&2; }
fi
node slides/index.mjs "$home/new" || fail "the index of the decks could not be made"
rm -rf "$out" && mv "$home/new" "$out" || fail "$out cannot be written"
say "$(find "$out" -name '[0-9]*.html' | wc -l) decks. Open $out/index.html"
