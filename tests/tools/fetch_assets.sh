#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/fetch_assets.sh against everything that goes wrong on the way, with file:// URLs and a closed port.
source "$(dirname "$0")/expect.sh"

export DERMIS_ASSET_CACHE=$scratch/cache
mkdir -p "$scratch/server" "$scratch/into" "$DERMIS_ASSET_CACHE/test-set"
printf 'a map of nothing' >"$scratch/server/map.jpg"
right=$(sha256sum <"$scratch/server/map.jpg" | cut -d ' ' -f 1)
bytes=$(stat -c %s "$scratch/server/map.jpg")
other=$(printf 'x' | sha256sum | cut -d ' ' -f 1)

# row URL SHA256 BYTES [NAME]: the list with this one file
row() {
  printf 'name\turl\tsha256\tlicence\tbytes\n%s\t%s\t%s\tCC0-1.0\t%s\n' \
    "${4-map.jpg}" "$1" "$2" "$3" >"$scratch/list.tsv"
}
fetch() {
  call "$root/tools/fetch_assets.sh" --list "$scratch/list.tsv" --into "$scratch/into" --set test-set "$@"
}
folder_is_empty() { [[ -z $(ls -A "$scratch/into") ]]; }
is_there() { cmp -s "$scratch/into/map.jpg" "$scratch/server/map.jpg"; }

# fails_with SENTENCE-PART: one line, exit status 1, nothing left behind
fails_with() {
  check "'$1': exit status 1" status_is 1
  check "'$1' is said" says "$1"
  check "'$1': one line" says_one_line
  check "'$1': nothing is left" folder_is_empty
}

row "file://$scratch/server/map.jpg" "$other" "$bytes"; fetch
fails_with "map.jpg: wrong hash"
row "file://$scratch/server/map.jpg" "$right" $((bytes + 1)); fetch
fails_with "map.jpg: short file: file://$scratch/server/map.jpg holds $bytes of $((bytes + 1)) bytes"
row "file://$scratch/server/map.jpg" "$right" $((bytes - 1)); fetch
fails_with "map.jpg: wrong length"
row "file://$scratch/server/none.jpg" "$right" "$bytes"; fetch
fails_with "map.jpg: missing file"
row "http://127.0.0.1:9/map.jpg" "$right" "$bytes"; no_proxy=127.0.0.1 NO_PROXY=127.0.0.1 fetch
fails_with "map.jpg: no network"
row "file://$scratch/server/map.jpg" "$right" "$bytes"; fetch --cached
fails_with "not in the asset cache"

# A server that sends half of the file and then nothing, until the caller loses patience, as ./run demo does.
cat >"$scratch/half.py" <<'PYTHON'
import socket, sys, time
server = socket.create_server(("127.0.0.1", 0))
print(server.getsockname()[1], flush=True)
connection, _ = server.accept()
connection.recv(65536)
connection.sendall(b"HTTP/1.1 200 OK\r\nContent-Length: 16\r\n\r\na map of")
time.sleep(30)
PYTHON
python3 "$scratch/half.py" >"$scratch/port" &
server=$!
until [[ -s $scratch/port ]]; do sleep 0.05; done
row "http://127.0.0.1:$(<"$scratch/port")/map.jpg" "$right" "$bytes"
no_proxy=127.0.0.1 NO_PROXY=127.0.0.1 call timeout 2 "$root/tools/fetch_assets.sh" \
  --list "$scratch/list.tsv" --into "$scratch/into" --set test-set
kill "$server"
check "a fetch that is cut off: timeout's exit status" status_is 124
check "a fetch that is cut off leaves nothing" folder_is_empty

row "ftp://example.org/map.jpg" "$right" "$bytes"; fetch
fails_with "line 2: expected an https, http or file URL"
row "file://$scratch/server/map.jpg" "$right" "$bytes" "../map.jpg"; fetch
fails_with "'../map.jpg' is not a plain file name"
row "file://$scratch/server/map.jpg" "short" "$bytes"; fetch
fails_with "64 hexadecimal digits"
printf 'something else\n' >"$scratch/list.tsv"; fetch
fails_with "line 1: expected the header"
rm "$scratch/list.tsv"; fetch
fails_with "no such list"

row "file://$scratch/server/map.jpg" "$right" "$bytes"; fetch
check "a good download: exit status 0" status_is 0
check "a good download is there" is_there
mv "$scratch/server" "$scratch/gone"
fetch
check "what is right is kept without asking the server" status_is 0
check "and nothing is said" says_nothing
mv "$scratch/gone" "$scratch/server"
printf 'spoilt' >"$scratch/into/map.jpg"
fetch
check "a spoilt file is replaced" is_there
printf 'spoilt' >"$scratch/into/map.jpg"
row "file://$scratch/server/none.jpg" "$right" "$bytes"; fetch
check "a failed download: exit status 1" status_is 1
check "and leaves no part beside what was there" test "$(ls -A "$scratch/into")" = map.jpg

rm "$scratch/into/map.jpg"
cp "$scratch/server/map.jpg" "$DERMIS_ASSET_CACHE/test-set/map.jpg"
fetch
check "the cache is asked before the server" is_there
rm "$scratch/into/map.jpg"
printf 'a map of nothinG' >"$DERMIS_ASSET_CACHE/test-set/map.jpg"
fetch
fails_with "wrong hash: the sha256 of $DERMIS_ASSET_CACHE/test-set/map.jpg"
finish
