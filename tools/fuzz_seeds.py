#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fuzz_seeds.py TARGETS.tsv SEEDS ASSETS OUT: gathers what fuzzing starts from.

OUT/TARGET gets the files of SEEDS/TARGET and, of the folder ASSETS (none is no error), what the target reads
and what is not longer than it takes. glTF files that name other files get those inside, since a fuzzed file
finds nothing beside it.
"""
import base64
import hashlib
import json
import struct
import sys
from pathlib import Path

# 1 x 1 white pixel, in place of pictures that would fill an input by themselves
WHITE = ("data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4//8/AAX+Av4N70a4"
         "AAAAAElFTkSuQmCC")
LARGEST_PICTURE = 2048  # bytes

# by target: endings of the files of ASSETS that it takes as they are
ENDINGS = {
    "gltf": (".gltf", ".glb"),
    "png": (".png",),
    "jpeg": (".jpg", ".jpeg"),
    "hdr": (".hdr",),
    "exr": (".exr",),
}


def split(path: Path):
    """The JSON of a .gltf or .glb and its binary chunk (None: it has none)."""
    data = path.read_bytes()
    if data[:4] != b"glTF":
        return json.loads(data), None
    length = struct.unpack_from("<I", data, 12)[0]
    rest = data[20 + length :]
    return json.loads(data[20 : 20 + length]), rest[8:] if len(rest) > 8 else None


def bytes_of(uri: str, folder: Path) -> bytes:
    if uri.startswith("data:"):
        return base64.b64decode(uri.partition(",")[2])
    return (folder / uri).read_bytes()


def pack(path: Path) -> bytes:
    """JSON, a zero byte, and the first buffer's bytes; everything else as data uris."""
    document, binary = split(path)
    for number, buffer in enumerate(document.get("buffers", [])):
        if "uri" not in buffer:
            continue
        data = bytes_of(buffer["uri"], path.parent)
        if number == 0 and binary is None:
            binary = data
            del buffer["uri"]
        else:
            buffer["uri"] = "data:;base64," + base64.b64encode(data).decode()
    for image in document.get("images", []):
        if "uri" in image:
            data = bytes_of(image["uri"], path.parent)
            small = "data:;base64," + base64.b64encode(data).decode()
            image["uri"] = small if len(data) <= LARGEST_PICTURE else WHITE
    text = json.dumps(document, separators=(",", ":")).encode()
    return text if binary is None else text + b"\0" + binary


def put(folder: Path, data: bytes, most: int):
    if 0 < len(data) <= most:
        (folder / hashlib.sha1(data).hexdigest()).write_bytes(data)


def main() -> int:
    if len(sys.argv) != 5:
        print(__doc__, file=sys.stderr)
        return 2
    targets, seeds, assets, out = (Path(a) for a in sys.argv[1:])
    files = sorted(p for p in assets.rglob("*") if p.is_file()) if assets.is_dir() else []
    for line in targets.read_text().splitlines():
        name, most, _ = line.split("\t")
        folder = out / name
        folder.mkdir(parents=True, exist_ok=True)
        for path in folder.iterdir():
            path.unlink()
        own = seeds / name
        for path in sorted(own.iterdir()) if own.is_dir() else []:
            put(folder, path.read_bytes(), int(most))
        for path in files:
            if path.suffix in ENDINGS.get(name, ()):
                put(folder, path.read_bytes(), int(most))
            if name == "glb" and path.suffix in ENDINGS["gltf"]:
                try:
                    put(folder, pack(path), int(most))
                except (ValueError, OSError, KeyError, TypeError, AttributeError, struct.error):
                    pass  # a damaged file of the corpus: the other target has it as it is
    return 0


sys.exit(main())
