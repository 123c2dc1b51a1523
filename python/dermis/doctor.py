# SPDX-License-Identifier: MIT
"""python -m dermis.doctor: says what dermis runs on, what is missing, and draws a picture. Exit status 0:
it works."""

from __future__ import annotations

import platform
import re
import sys
import time

# Of Debian 12, for libraries that the module cannot find.
_packages = {
    "libvulkan": "libvulkan1",
    "libOpenEXR": "libopenexr-3-1-30",
    "libdraco": "libdraco7",
    "libembree3": "libembree3-3",
    "libfmt": "libfmt9",
    "libjpeg": "libjpeg62-turbo",
    "libmeshoptimizer": "libmeshoptimizer2d",
    "libspirv-cross": "libspirv-cross-c-shared0",
    "libspng": "libspng0",
    "libtbb": "libtbb12",
}


def _say(what: str, text: str) -> None:
    print(f"{what:<10} {text}")


def advice(error: str) -> str:
    """Returns what to do about a module that does not load."""
    library = re.search(r"(lib\S+\.so\S*): cannot open", error)
    for prefix, package in _packages.items():
        if library and library[1].startswith(prefix):
            return f"apt-get install {package}"
    return "install the module anew: pip install --force-reinstall"


def main() -> int:
    _say("python", f"{platform.python_version()}, {sys.executable}")
    try:
        import numpy

        _say("numpy", numpy.__version__)
    except ImportError:
        _say("numpy", "missing: pip install numpy")
        return 1
    try:
        import dermis
        from dermis import _core
    except ImportError as error:
        _say("dermis", f"does not load: {error}")
        _say("", advice(str(error)))
        return 1
    _say("dermis", str(_core.__file__))

    devices = dermis.devices()
    for number, device in enumerate(devices):
        memory = f"{device.memory_bytes / 2**30:.1f} GiB"
        _say(
            "device",
            f"{number}: {device.name}, {device.type}, Vulkan {device.api}, {memory}, {device.driver}",
        )
        for missing in device.missing:
            _say("", f"cannot be used: {missing}")
    if not any(not device.missing for device in devices):
        _say("", "no device can be used: install a driver of Vulkan 1.3, on Debian mesa-vulkan-drivers")
        return 1

    try:
        start = time.perf_counter()
        picture = dermis.render("built-in", size=(64, 64), map_size=256, exposure=0)
    except (dermis.DeviceError, dermis.InputError, dermis.InternalError) as error:
        _say("picture", f"cannot be drawn: {error}")
        return 1
    if not 1 < picture.display[:, :, :3].mean() < 254:
        _say("picture", f"is not one: its mean is {picture.display[:, :, :3].mean():.1f} of 255")
        return 1
    _say("picture", f"64 x 64 on {picture.statistics['device']} in {time.perf_counter() - start:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
