#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The documentation against the tree: links lead somewhere, paths in `code` exist, each page says for whom it is and is in
# an index, each config and module has a row, each picture is shown.
#   docs_test.sh SOURCE
set -euo pipefail
cd -- "$1"
failures=0
fail() { printf 'FAILED: %s\n' "$1"; failures=$((failures + 1)); }
anchors_of() {  # as GitHub makes them of headings
    awk '/^```/ { code = !code } !code && /^#+ / { sub(/^#+ /, ""); print tolower($0) }' "$1" |
        sed -E 's/\]\([^)]*\)//g; s/[^a-z0-9 _-]//g; s/ /-/g'
}

pages=(*.md configs/README.md effects/README.md docs/*.md docs/*/*.md)
for page in "${pages[@]}"; do
    folder=$(dirname -- "$page")
    for link in $(grep -oE '\]\([^) ]+\)' "$page" | sed -E 's/^\]\(//; s/\)$//'); do
        [[ $link == http*://* ]] && continue
        target=$folder/${link%%#*}
        [[ $link == \#* ]] && target=$page
        if [[ ! -e $target ]]; then
            fail "$page: the link '$link' leads nowhere"
        elif [[ $link == *.md#* || $link == \#* ]]; then
            grep -qxF -- "${link#*#}" <(anchors_of "$target") || fail "$page: '$link' names no heading"
        fi
    done
    for path in $(grep -oE '`(core|backends|effects|configs|tools|tests|docs)/[a-z_0-9/.]+`' "$page" | tr -d '`'); do
        [[ -e $path ]] || fail "$page: there is no '$path'"
    done
done

for page in docs/*.md docs/*/*.md; do
    sed -n 3p "$page" | grep -q '^For ' || fail "$page: the third line does not say for whom it is"
    index=$(dirname -- "$page")/README.md
    [[ -e $index ]] || index=README.md
    [[ $page == "$index" ]] || grep -q "$(basename -- "$page"))" "$index" || fail "$page: $index has no link to it"
done
for config in configs/*.json configs/*/*.json; do
    name=$(basename -- "$config" .json)
    grep -q "^| \`$name[\`=]" docs/which_config.md docs/reference/methods.md || fail "$config: no table has a row for it"
done
for module in effects/*/*.json; do
    name=${module#effects/}
    grep -q "^| .*\`${name%.json}\`.* |" effects/README.md || fail "$module: effects/README.md has no row for it"
done
for picture in docs/reference/pictures/*.png; do
    grep -q "pictures/$(basename -- "$picture")" README.md docs/*.md docs/*/*.md || fail "$picture: no page shows it"
done

((failures == 0)) && echo "all checks passed"
