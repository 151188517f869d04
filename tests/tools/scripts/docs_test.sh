#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The documentation against the tree: links lead somewhere, every config and module is on some page, and every
# method's page has a picture, of which none is left over, and names a command. Paths exist, and each page says for whom
# it is.
#   docs_test.sh SOURCE
set -euo pipefail
cd -- "$1"
failures=0
fail() { printf 'FAILED: %s\n' "$1"; failures=$((failures + 1)); }

pages=(README.md CONTRIBUTING.md configs/README.md effects/README.md docs/*.md docs/methods/*.md)
methods=()
for page in docs/methods/*.md; do [[ $page == */README.md ]] || methods+=("$page"); done

# What a page links to: the targets of [text](target) and ![text](target), without anchors.
links_of() { grep -oE '\]\([^) ]+\)' "$1" | sed -E 's/^\]\(//; s/\)$//; s/#.*//' || true; }

for page in "${pages[@]}"; do
    for link in $(links_of "$page"); do
        target=$(realpath -m --relative-to=. -- "$(dirname -- "$page")/$link")
        [[ $target == out/page/* ]] && target=tools/page/${target#out/page/}  # tools/page.sh puts it there
        [[ $link == http*://* || -e $target ]] || fail "$page: the link '$link' leads nowhere"
    done
done

# Files and folders that these pages name in `code`.
for page in CONTRIBUTING.md docs/architecture.md docs/glossary.md docs/host.md; do
    for path in $(grep -oE '`(core|backends|effects|configs|tools|tests|docs)/[a-z_0-9/.]+`' "$page" | tr -d '`'); do
        [[ -e $path ]] || fail "$page: there is no '$path'"
    done
done

# Each page opens with a sentence that says for whom it is.
for page in docs/*.md; do
    sed -n '3p' "$page" | grep -q '^For ' || fail "$page: the third line does not say for whom it is"
done

for page in "${methods[@]}"; do
    grep -q '^pictures/.*\.png$' <<<"$(links_of "$page")" || fail "$page: has no picture"
    grep -qE '^    (for|crevice|tools/)|`tools/[a-z_/]+\.sh`' "$page" || fail "$page: names no command"
    grep -q "($(basename -- "$page")" docs/methods/README.md || fail "$page: docs/methods/README.md does not name it"
done
for picture in docs/methods/pictures/*.png; do
    grep -q "pictures/$(basename -- "$picture")" README.md docs/methods/*.md || fail "$picture: no page shows it"
done

for config in configs/*.json; do
    name=$(basename -- "$config" .json)
    grep -q "^| \`$name\` |" docs/methods/README.md || fail "$config: docs/methods/README.md has no row for it"
    grep -q "\`$name\`" "${methods[@]}" || fail "$config: no method's page mentions it"
done

# A page of configs opens the built page at one of them.
for page in $(sed -nE 's/^\| `[a-z0-9_]+` \| \[[a-z_]+\]\(([a-z_]+\.md).*/\1/p' docs/methods/README.md | sort -u); do
    opened=$(sed -nE 's/.*out\/page\/index\.html#config=([a-z0-9_]+)\).*/\1/p' "docs/methods/$page")
    [[ -e configs/$opened.json ]] || fail "docs/methods/$page: opens the page at no config"
    grep -q "^| \`$opened\` | \[[a-z_]*\]($page" docs/methods/README.md || fail "docs/methods/$page: '$opened' is another page's"
done
for module in effects/*/*.json; do
    name=${module#effects/}
    grep -q "^| .*\`${name%.json}\`.* |" effects/README.md || fail "$module: effects/README.md has no row for it"
done
for page in docs/methods/*.md; do
    unknown=$(sed -nE '/\| room \| spheres \| cost \|$/,/^$/ s/^\| `([a-z0-9_]+)` \|.*/\1/p' "$page")
    for name in $unknown; do
        [[ -e configs/$name.json ]] || fail "$page: there is no config '$name'"
    done
done

((failures == 0)) && echo "all checks passed"
