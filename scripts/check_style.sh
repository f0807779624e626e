#!/usr/bin/env bash
# Says which files clang-format 14 would change, and where code outside studies/trials knows one kind of trial from the
# others; fails if there are any.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 --dry-run --Werror
echo "style: clang-format agrees"
if git grep -nE 'StageKind::[a-z]' -- studies results app ':!studies/trials' ':!*.hpp'; then
    echo "style: what a kind of trial is stands in studies/trials; ask its declaration (stage_kind.hpp)" >&2
    exit 1
fi
