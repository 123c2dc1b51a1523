# SPDX-License-Identifier: MIT
"""dermis: human skin in real time. Pictures, labels and diffusion profiles as NumPy arrays.

>>> import dermis
>>> picture = dermis.render("built-in", size=(512, 512))
>>> picture.display          # uint8 (512, 512, 4)
>>> picture.linear           # float32 (512, 512, 4)
"""

import sys

_for_doctor = "dermis.doctor" in getattr(sys, "orig_argv", [])  # which says itself what is missing

try:
    from . import _core
except ImportError as error:
    if not _for_doctor:
        raise ImportError(f"{error}; `python -m dermis.doctor` says what to install") from error
else:
    import atexit

    atexit.register(_core.end_threads)

    from ._core import Cancelled, DeviceError, InputError, InternalError
    from ._asset import Asset, Bounds, Light, Material, Mesh
    from ._landmarks import LandmarkPlace, Landmarks, PictureLandmarks
    from ._parts import part_classes, part_names
    from ._profile import Profile
    from ._renderer import Device, Frame, Picture, Renderer, Session, devices, render, techniques
    from ._scene import Camera, Instance, Joint, Pose, Scene

    for _error in (Cancelled, DeviceError, InputError, InternalError):
        _error.__module__ = "dermis"

    __all__ = [
        "Asset",
        "Bounds",
        "Camera",
        "Cancelled",
        "Device",
        "DeviceError",
        "Frame",
        "InputError",
        "Instance",
        "InternalError",
        "Joint",
        "LandmarkPlace",
        "Landmarks",
        "Light",
        "Material",
        "Mesh",
        "Picture",
        "PictureLandmarks",
        "Pose",
        "Profile",
        "Renderer",
        "Scene",
        "Session",
        "devices",
        "part_classes",
        "part_names",
        "render",
        "techniques",
    ]
