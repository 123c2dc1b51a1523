# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import os
import threading
from collections.abc import Iterable
from types import TracebackType
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._asset import Asset, Path
from ._keywords import render_keywords, settings_of
from ._png import png_of
from ._progress import Progress, progress_of
from ._scene import Scene
from ._types import OutputName, RenderKeywords

_outputs = {row[0]: number for number, row in enumerate(_core.output_rows())}


class Picture:
    """A finished picture. The arrays are its memory: no copies, and they outlive the object."""

    def __init__(self, core: _core.Picture) -> None:
        self._inner = core

    @property
    def display(self) -> NDArray[np.uint8]:
        """uint8 (H, W, 4): RGBA after the tone map; alpha is 255."""
        return self._inner.display

    @property
    def linear(self) -> NDArray[np.float32]:
        """float32 (H, W, 4): linear Rec.709 with exposure and bloom. Alpha is the share of the pixel that
        is skin, which is no matte."""
        return self._inner.linear

    @property
    def statistics(self) -> dict[str, Any]:
        """What was rendered, on which device, and what it cost; the keys of `dermis render --stats`."""
        statistics: dict[str, Any] = json.loads(self._inner.statistics)
        return statistics

    @property
    def width(self) -> int:
        return self._inner.width

    @property
    def height(self) -> int:
        return self._inner.height

    def save(self, path: Path) -> None:
        """Writes .png (display) or .exr (linear), atomically. Raises InputError."""
        self._inner.save(os.fspath(path))

    def _repr_png_(self) -> bytes:
        return png_of(self.display)

    def __repr__(self) -> str:
        return f"<dermis.Picture {self.width} x {self.height}>"


class Frame:
    """A frame of a session. Its arrays wait for the device, and are the memory that the device wrote: no
    copies. They stay as they are, whatever the session draws, as long as anyone holds them; the memory
    then serves again."""

    def __init__(self, session: _core.Session, ticket: int, width: int, height: int) -> None:
        self._session = session
        self._ticket = ticket
        self._results: _core.Results | None = None
        self.width = width
        self.height = height

    def wait(self) -> Frame:
        """Waits until the device has drawn the frame, and keeps its memory. Raises InputError once as
        many frames have been drawn after it as may be in flight."""
        self._waited()
        return self

    def _waited(self) -> _core.Results:
        if self._results is None:
            self._results = self._session.results(self._ticket)
        return self._results

    def array(self, output: OutputName) -> NDArray[Any]:
        """Returns an output by its name. Raises InputError: the session does not want it."""
        array = _array_of(self._waited(), _number_of(output))
        if array is None:
            raise _core.InputError(f"this session does not draw '{output}': name it in Session(outputs=...)")
        return array

    @property
    def display(self) -> NDArray[np.uint8]:
        """uint8 (H, W, 4): RGBA after the tone map; alpha is 255."""
        return self.array("display")

    @property
    def linear(self) -> NDArray[np.float32]:
        """float32 (H, W, 4): linear Rec.709 with exposure and bloom. Alpha is the share of the pixel that
        is skin, which is no matte."""
        return self.array("linear")

    @property
    def instance(self) -> NDArray[np.uint32]:
        """uint32 (H, W): 0 nothing, else 1 + the place in Scene.instances."""
        return self.array("instance")

    @property
    def material(self) -> NDArray[np.uint32]:
        """uint32 (H, W): 0 nothing, else 1 + the place in Asset.materials of the instance."""
        return self.array("material")

    @property
    def depth(self) -> NDArray[np.float32]:
        """float32 (H, W): metres from the eye along the axis of the camera, not along the ray; infinity:
        nothing."""
        return self.array("depth")

    @property
    def normal(self) -> NDArray[np.float32]:
        """float32 (H, W, 3): interpolated, without normal maps; unit, in the world, of the side that is
        seen; 0 nothing. Frame.normal @ camera.R.T has it in the camera."""
        return self.array("normal")

    @property
    def uv(self) -> NDArray[np.float32]:
        """float32 (H, W, 2): texture coordinates of the file, v down; 0 nothing."""
        return self.array("uv")

    @property
    def motion(self) -> NDArray[np.float32]:
        """float32 (H, W, 2): pixels by which that point has moved since the frame before, right and down."""
        return self.array("motion")

    @property
    def region(self) -> NDArray[np.uint8]:
        """uint8 (H, W): 0 no skin, 1 nose, 2 ear, 3 other skin."""
        return self.array("region")

    @property
    def skin_mesh(self) -> NDArray[np.uint32]:
        """uint32 (H, W): 0 no skin, else 1 + the number of the skin mesh in the asset."""
        return self.array("skin_mesh")

    @property
    def unwrap(self) -> NDArray[np.float32]:
        """float32 (H, W, 2): coordinates of the light map of that skin mesh, 0 to 1, v down."""
        return self.array("unwrap")

    @property
    def thickness(self) -> NDArray[np.float32]:
        """float32 (H, W): of the body below the skin, mm; 0 no skin."""
        return self.array("thickness")

    @property
    def matte(self) -> NDArray[np.float32]:
        """float32 (H, W): the share of the pixel that heads cover, 0 to 1, blended parts by their alpha;
        before light L stands `linear + (1 - matte) * L`. Takes a lit frame."""
        return self.array("matte")

    @property
    def part(self) -> NDArray[np.uint32]:
        """uint32 (H, W): 0 nothing, else a place in dermis.part_names(); dermis.part_classes() has tables to
        the classes of data sets."""
        return self.array("part")

    @property
    def front(self) -> NDArray[np.float32]:
        """float32 (H, W): what blended parts (lashes, brows) cover of the pixel's middle, 0 to 1."""
        return self.array("front")

    @property
    def front_part(self) -> NDArray[np.uint32]:
        """uint32 (H, W): a place in dermis.part_names(), of the nearest blended part that covers a half or
        more; 0 none."""
        return self.array("front_part")

    @property
    def statistics(self) -> dict[str, Any]:
        """As Picture.statistics; what is counted is 0 unless the session was asked for statistics."""
        statistics: dict[str, Any] = json.loads(self._session.statistics(self._ticket))
        return statistics

    @property
    def bytes_read_back(self) -> int:
        """Copied from the device to memory of the host for this frame."""
        return self._session.bytes(self._ticket)[0]

    def _repr_png_(self) -> bytes | None:
        display = _array_of(self._waited(), _outputs["display"])
        return None if display is None else png_of(display)

    def __repr__(self) -> str:
        return f"<dermis.Frame {self.width} x {self.height}>"


def _array_of(results: _core.Results, number: int) -> NDArray[Any] | None:
    array: Any = results.array(number)
    return array  # type: ignore[no-any-return]


class Renderer:
    """Draws scenes on one device. One thread at a time may use a renderer and its sessions: others get a
    RuntimeError. Several renderers may work at the same time."""

    def __init__(
        self, device: str = "best", *, validate: bool = False, progress: Progress | bool | None = None
    ) -> None:
        """`device`: "best", a number or a part of a name of devices(). `progress` hears of work that
        takes seconds. Raises DeviceError: no driver, no such device, something that dermis needs is
        missing."""
        self._engine = _core.make_engine(str(device), validate, progress_of(progress))

    def render(self, scene: Scene | Asset | Path, **settings: Unpack[RenderKeywords]) -> Picture:
        """Draws a picture: the same as `dermis render` with these options, to the bit. Raises InputError,
        DeviceError, Cancelled; TypeError for a keyword that is not known."""
        of_render = settings_of("render", settings)
        with render_keywords.named():
            return Picture(self._engine.render(_scene_of(scene)._inner, of_render))

    def session(
        self,
        outputs: OutputName | Iterable[OutputName] = ("display", "linear"),
        *,
        frames_in_flight: int = 2,
        statistics: bool = False,
    ) -> Session:
        """Returns Session(renderer=self, ...)."""
        return Session(outputs, renderer=self, frames_in_flight=frames_in_flight, statistics=statistics)

    def validation_messages(self) -> list[str]:
        """Returns what the Vulkan validation layer has said; empty unless validate=True."""
        return self._engine.validation_messages()

    def close(self) -> None:
        """Gives the device back as soon as its sessions are gone; happens by itself."""
        self._engine.close()

    def __enter__(self) -> Renderer:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


class Session:
    """Frames of a scene that changes: draw() returns before the device has drawn, and nothing that is not
    wanted is drawn or read back.

    >>> session = dermis.Session(outputs=("display", "depth", "normal"))
    >>> frame = session.draw(scene, size=(512, 512), exposure=0)
    >>> frame.depth            # float32 (512, 512), metres
    """

    def __init__(
        self,
        outputs: OutputName | Iterable[OutputName] = ("display", "linear"),
        *,
        renderer: Renderer | None = None,
        frames_in_flight: int = 2,
        statistics: bool = False,
    ) -> None:
        """`outputs`: names of what frames give; labels alone light nothing. `frames_in_flight`: 1 to 3.
        `statistics`: counts what each frame computes, which costs time. Raises InputError."""
        names = [outputs] if isinstance(outputs, str) else list(outputs)
        engine = (renderer or default_renderer())._engine
        self._inner = engine.session([_number_of(name) for name in names], frames_in_flight, statistics)
        self._given: dict[str, Any] | None = None
        self._settings = settings_of("Session.draw", {})
        self._size = (0, 0)

    def draw(self, scene: Scene, **settings: Unpack[RenderKeywords]) -> Frame:
        """Draws the scene as it is now. `exposure` must be a number, and `show` "picture". Waits for the
        frame before those that may be in flight, not for this one. Raises as Renderer.render() does;
        after an InputError the session is as before."""
        self._take(settings)
        with render_keywords.named():
            ticket = self._inner.draw(scene._inner, self._settings)
        return Frame(self._inner, ticket, *self._size)

    def _take(self, given: RenderKeywords) -> None:
        # Settings seldom change from frame to frame.
        if self._given is not None and _same(self._given, given):
            return
        self._settings = settings_of("Session.draw", given)
        output = json.loads(self._settings.json)["output"]
        self._size = (output["width"], output["height"])
        self._given = dict(given)


def _same(a: dict[str, Any], b: Any) -> bool:
    try:
        return bool(a == b) and all(type(value) in _plain_types for value in a.values())
    except ValueError:  # arrays
        return False


# What a caller cannot change behind our back.
_plain_types = (bool, int, float, str, tuple, type(None))


def _number_of(name: str) -> int:
    number = _outputs.get(name)
    if number is None:
        near = _core.nearest(name, list(_outputs))
        raise _core.InputError(
            f"'{name}' is no output"
            + (f"; did you mean '{near}'?" if near else f"; there are: {', '.join(_outputs)}")
        )
    return number


_of_thread = threading.local()


def default_renderer() -> Renderer:
    """Returns the renderer that render() and Session() use in this thread."""
    found: Renderer | None = getattr(_of_thread, "renderer", None)
    if found is None:
        found = _of_thread.renderer = Renderer()
    return found


def render(scene: Scene | Asset | Path, **settings: Unpack[RenderKeywords]) -> Picture:
    """Draws a picture with a renderer that this thread keeps: see Renderer.render().

    >>> picture = dermis.render("head.glb", size=(512, 512), technique="texture-space")
    """
    return default_renderer().render(scene, **settings)


def _scene_of(scene: Scene | Asset | Path) -> Scene:
    if isinstance(scene, Scene):
        return scene
    return Scene(scene) if isinstance(scene, Asset) else Scene.load(scene)


class Device:
    """A device that Vulkan offers."""

    def __init__(self, core: _core.DeviceInfo) -> None:
        self.name = core.name
        self.driver = core.driver
        self.type = core.type
        """discrete, integrated, virtual, software, other"""
        self.api = core.api
        self.memory_bytes = core.memory_bytes
        self.missing = core.missing
        """What dermis needs and the device has not; empty: it can be used."""

    def __repr__(self) -> str:
        return f"<dermis.Device {self.name!r}, {self.type}>"


def devices() -> list[Device]:
    """Returns all devices, best first; empty without a driver."""
    return [Device(core) for core in _core.list_devices()]


def techniques() -> list[str]:
    """Returns what `technique` may be; the first is the default."""
    return _core.technique_names()
