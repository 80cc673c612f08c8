"""Exact hidden-line drawings of polyhedra.

    import roberts
    scene = roberts.read("table.off")          # a path, or the bytes of an OFF, STL, OBJ or PLY file
    scene = roberts.Scene(vertices, faces)     # or arrays, as a mesh of trimesh has them
    drawing = scene.hide("iso")                # visible segments, as a numpy array
    drawing.segments["p0"], drawing.segments["p1"]
    drawing.save("table.pdf")
    scene.sheet("first").save("views.pdf")     # front, top, side and isometric view

In a notebook, scenes, drawings and sheets show themselves. Arrays that the library gives are read-only views of its own
memory, which lives as long as one of them does. Numbers of vertices, faces and bodies count from 0; roberts.NONE stands
for none. What the library refuses is a roberts.Error, with file and line; its warnings are roberts.RobertsWarning.
The names and the rules are those of roberts.h, the header of the library.
"""

from __future__ import annotations

import ctypes
import difflib
import math
import os
import re
import warnings as _warnings
import weakref
from typing import Any, Iterator, Mapping, Optional, Sequence, Union

import numpy as np

from . import _library as c
from ._library import NONE, Error, FileError, RobertsWarning

__all__ = ["NONE", "VISIBLE", "HIDDEN", "CLIPPED", "LINES", "Error", "FileError", "RobertsWarning", "Scene", "View",
           "Drawing", "Regions", "Sheet", "read", "view"]

__version__ = c.VERSION

VISIBLE, HIDDEN, CLIPPED = 0, 1, 2
"""The values of segments["state"]."""

LINES = ("outline", "crease", "back", "border", "wire", "intersection", "back_outline")
"""The names of the values of segments["line"]. Tables call back "crease" and back_outline "outline"."""

_KINDS = ("convex", "closed", "open")
# pens by the program's names; roberts.h calls that of hidden lines back
_PENS = {"hidden" if name == "back" else name: name for name in c.PENS}
_PEN = {"width": "width_mm", "dash": "dash_mm", "gap": "gap_mm", "off": "off", "number": "number"}
# the kind of fill, and whether it is shaded
_FILLS = {"none": (0, False), "white": (1, False), "model": (2, False), "body": (3, False), "shade": (2, True),
          "shade:white": (1, True), "shade:body": (3, True)}
_HIDDEN = {"none": 0, "dashed": 1, "solid": 2}
_GROUPS = {"class": 0, "body": 1, "element": 2}
_LABELS = {"vertices": 1, "edges": 2, "faces": 4, "bodies": 8, "names": 16}
_TEXTS = {"strokes": False, "native": True}
_NAMED = ("vertices", "edges", "faces", "bodies")
_COLUMNS = {"ends": 0, "depth": 1, "level": 2, "name": 3, "by": 4}
_ANGLES = {"first": 0, "third": 1}
_SHEET_VIEWS = ("front", "top", "side", "iso")

# the options of a page: see svg()
_OPTIONS = ("background", "columns", "crop", "description", "dpi", "fill", "group", "hatch", "hidden", "id_prefix",
            "label_size", "labels", "light", "names", "number_layers", "page", "pens", "real_dashes", "scale", "shaded",
            "text", "title")

_TABLES = ("csv", "json")
_ONLY_IN = {"columns": _TABLES, "dpi": ("png",), "group": ("svg",), "id_prefix": ("svg",),
            "text": ("svg", "pdf", "tikz", "dxf")}

_vec2, _vec3 = np.dtype((np.float64, 2)), np.dtype((np.float64, 3))
_SEGMENT = np.dtype([("solid", "u4"), ("v0", "u4"), ("v1", "u4"), ("by", "u4"), ("t0", "f8"), ("t1", "f8"),
                     ("p0", _vec2), ("p1", _vec2), ("z0", "f8"), ("z1", "f8"), ("state", "u1"), ("line", "u1"),
                     ("level", "u2"), ("edge", "u4")])
_CROSSING = np.dtype([("face", "u4", 2), ("end", "f8", (2, 3))])
_COLOR = np.dtype([("count", "u1"), ("value", "f4", 4)], align=True)
_REGION = np.dtype([("solid", "u4"), ("face", "u4"), ("first_ring", np.uintp), ("ring_count", np.uintp),
                    ("area", "f8"), ("z_min", "f8"), ("z_max", "f8"), ("normal", _vec3),
                    ("color", _COLOR), ("section", "?")], align=True)
_SLOPE = np.dtype([("steep", _vec2), ("level", _vec2), ("foot", _vec2)])

PathOrBytes = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview]
ViewLike = Union[str, "View", None]


class _Memory:
    """Memory of the library, as numpy reads it. The array keeps this object, and this object keeps the owner."""

    def __init__(self, owner: Any, address: int, shape: tuple, dtype: np.dtype) -> None:
        self.owner = owner
        base, inner = dtype.subdtype or (dtype, ())
        self.__array_interface__ = {"version": 3, "shape": shape + inner, "typestr": base.str, "descr": base.descr,
                                    "data": (address, True)}


def _array(owner: Any, address: Optional[int], count: int, dtype: Any) -> np.ndarray:
    """A read-only array over the library's memory."""
    dtype = np.dtype(dtype)
    if not address or not count:
        empty = np.empty(0, dtype)
        empty.flags.writeable = False
        return empty
    raw = np.asarray(_Memory(owner, address, (count * dtype.itemsize,), np.dtype("u1")))
    return raw.view(dtype.base).reshape((count,) + dtype.shape) if dtype.subdtype else raw.view(dtype)


class _Warned:
    """Collects the warnings of one call, and issues them after it."""

    def __init__(self) -> None:
        self.said: list[str] = []
        self.function = c.WARNING_FN(self._warn)
        self.struct = c.warnings(self.function, None)

    def _warn(self, _context: Any, file: Optional[bytes], line: int, message: bytes) -> None:
        self.said.append(c.place(c.text(file or b""), line) + c.text(message))

    def issue(self) -> None:
        for message in self.said:
            _warnings.warn(message, RobertsWarning, stacklevel=4)


def _set(struct: Any, name: str, value: Any, what: str) -> None:
    """Sets a field; ctypes would not say which one has a wrong type, and would take any text for True."""
    if isinstance(getattr(struct, name), bool) and not isinstance(value, (bool, np.bool_)) and value not in (0, 1):
        raise TypeError(f"{what}: it is True or False, not {value!r}")
    try:
        setattr(struct, name, value)
    except TypeError as why:
        raise TypeError(f"{what}: {why}") from None


def _unknown(what: str, name: str, names: Sequence[str]) -> TypeError:
    """There is no such name; says which ones there are, and which one was probably meant."""
    meant = [one for one in names if one.startswith(name + "_")] or difflib.get_close_matches(name, names, 1, 0.5)
    return TypeError(f"{what}there is no {name!r}" + (f"; did you mean {' or '.join(meant)}?" if meant else ".") +
                     f" There are {', '.join(names)}")


def _fill(struct: Any, values: Mapping[str, Any], what: str, names: Sequence[str] = ()) -> None:
    """Sets fields of a struct by name: these, or any."""
    names = names or [name for name, *_ in struct._fields_]
    for name, value in values.items():
        if name not in names:
            raise _unknown(f"{what}: ", name, sorted(names))
        _set(struct, name, value, f"{what}: {name}")
        if isinstance(value, int) and getattr(struct, name) != value:  # ctypes keeps the lowest bits
            raise ValueError(f"{what}: {name} is out of range")


def _vector(values: Sequence[float], what: str) -> c.vec3:
    """Three numbers; ctypes would take fewer."""
    part, vector = [*values], c.vec3()
    if len(part) != 3:
        raise ValueError(f"{what}: a vector has three numbers, not {len(part)}")
    for name, value in zip("xyz", part):
        _set(vector, name, value, what)
    return vector


def _number(value: float, what: str, low: float = -math.inf, high: float = math.inf) -> float:
    """A finite number from `low`, and less than `high`."""
    number = ctypes.c_double()
    _set(number, "value", value, what)
    if not math.isfinite(number.value) or not low <= number.value < high:
        raise ValueError(f"{what}: {value!r} is out of range")
    return number.value


def _point(values: Sequence[float], what: str) -> c.vec3:
    """Three finite numbers."""
    vector = _vector(values, what)
    for name in "xyz":
        _number(getattr(vector, name), what)
    return vector


def _direction(values: Sequence[float], what: str) -> c.vec3:
    """Three finite numbers, not all of them 0."""
    vector = _point(values, what)
    if vector.x == vector.y == vector.z == 0.0:
        raise ValueError(f"{what}: 0, 0, 0 is no direction")
    return vector


def _color(values: Sequence[int], what: str) -> tuple[int, int, int]:
    """Red, green and blue, as bytes: ctypes would keep the lowest bits of numbers beyond 255."""
    try:
        red, green, blue = bytes([*values])
    except (TypeError, ValueError):
        raise ValueError(f"{what}: a colour has three numbers from 0 to 255") from None
    return red, green, blue


def _choice(table: Mapping[str, Any], value: str, what: str, other: str = "") -> Any:
    if value not in table:
        raise ValueError(f"{what}: {value!r} is unknown; it can be {', '.join(table)}{other}")
    return table[value]


def _names(value: Union[str, Sequence[str]]) -> Sequence[str]:
    """A sequence of names; of a text, those between its commas, as the program takes them. "": none."""
    return (value.split(",") if value else ()) if isinstance(value, str) else value


# ---- views ----------------------------------------------------------------------------------------------------------


class View:
    """Where the viewer stands; made by roberts.view()."""

    def __init__(self, camera: c.camera) -> None:
        self._camera = camera

    def __repr__(self) -> str:
        at = self._camera.eye if self._camera.projection else self._camera.dir
        kind = "eye" if self._camera.projection else "direction"
        return f"<roberts.View {kind}=({at.x:g}, {at.y:g}, {at.z:g})>"


def view(preset: str = "iso", *, azimuth: Optional[float] = None, elevation: Optional[float] = None, roll: float = 0.0,
         direction: Optional[Sequence[float]] = None, eye: Optional[Sequence[float]] = None,
         look_at: Optional[Sequence[float]] = None, up: Optional[Sequence[float]] = None, fov: float = 0.0,
         near: float = 0.0, section: Optional[Sequence[float]] = None) -> View:
    """A view, by one of four ways to say it.

    preset              iso, dimetric, trimetric, front, back, right, left, top, bottom, cavalier, cabinet
    azimuth, elevation  degrees: 0, 0 is the front; azimuth 90 the right; elevation -90 to 90; one alone: the other is 0
    direction           three numbers: from the scene toward the viewer, at any length but 0
    eye                 three numbers, model units: a perspective from there
    look_at             perspective: the point in the middle of the picture; None: the middle of the scene's box
    up                  what points up in the picture; None: +z
    roll                degrees: turns the picture counter-clockwise
    fov                 perspective: the field of view in degrees, below 180; 0: the whole scene
    near                perspective: what is nearer to the eye is cut off, model units; 0: chosen
    section             three numbers: what is nearer to the viewer than this point is cut off; or six, in parallel
                        views: a point and a direction, to whose side all is cut off; None: nothing is
    Raises TypeError, ValueError.
    """
    camera = c.camera()
    angles = azimuth is not None or elevation is not None
    if (preset != "iso") + angles + (direction is not None) + (eye is not None) > 1:
        raise ValueError("view: preset, angles, direction and eye exclude each other")
    if eye is None and (look_at is not None or fov or near):
        raise ValueError("view: look_at, fov and near need eye")
    roll = _number(roll, "view: roll")
    if angles:
        azimuth = 0.0 if azimuth is None else _number(azimuth, "view: azimuth")
        elevation = 0.0 if elevation is None else _number(elevation, "view: elevation")
        if not c.lib.roberts_camera_angles(azimuth, elevation, roll, ctypes.byref(camera)):
            raise ValueError(f"view: azimuth {azimuth}, elevation {elevation} is no view")
    elif direction is None and eye is None:
        if not c.lib.roberts_camera_preset(preset.encode(), ctypes.byref(camera)):
            raise ValueError(f"view: there is no {preset!r}")
    if direction is not None:
        camera.dir = _direction(direction, "view: direction")
    if eye is not None:
        camera.projection, camera.eye = 1, _point(eye, "view: eye")
    if look_at is not None:
        camera.look_at, camera.has_look_at = _point(look_at, "view: look_at"), True
    if up is not None:
        camera.up = _direction(up, "view: up")
    if section is not None:
        section = [*section]
        if len(section) not in (3, 6):
            raise ValueError(f"view: section: three numbers, or six, not {len(section)}")
        camera.section, camera.has_section = _point(section[:3], "view: section"), True
        if len(section) == 6:
            camera.section_normal = _direction(section[3:], "view: section")
    camera.roll_degrees = roll
    camera.fov_degrees, camera.near_distance = _number(fov, "view: fov", 0.0, 180.0), _number(near, "view: near", 0.0)
    return View(camera)


def _camera(where: ViewLike) -> c.camera:
    if where is None:
        where = "iso"
    if isinstance(where, str):
        where = view(where)
    if not isinstance(where, View):
        raise TypeError(f"a view is the name of a preset, or what roberts.view() returns, not {type(where).__name__}; "
                        "three numbers can be view(direction=...) or view(eye=...)")
    return where._camera


# ---- scenes ---------------------------------------------------------------------------------------------------------


class Scene:
    """Bodies of any shape, ready to be seen from any side.

    vertices    (n, 3) numbers, model units; read in place if they are float64 and contiguous, else converted
    faces       (m, k) vertex numbers, read in place if they are uint32 and contiguous, else converted; or a sequence
                of m sequences of any lengths
    colors      (m, 3) or (m, 4) numbers, for fill="model": red, green, blue and opacity of each face; whole numbers
                from 0 to 255, others from 0 to 1; None: none
    hull        what is no convex solid is replaced by its hull
    solids      what is no convex solid is refused
    tolerance   how far a corner may lie off its face's plane, as a part of the solid's size; 0: 1e-5
    even_odd    the inside of a face that crosses itself is what its border winds round an odd number of times
    rounded     decimal coordinates were rounded: what touches to within two units of their last place touches
    The scene keeps arrays that are read in place. What is drawn does not follow later changes of them.
    Raises Error, MemoryError, ValueError.
    """

    def __init__(self, vertices: Any, faces: Any, *, colors: Any = None, hull: bool = False, solids: bool = False,
                 tolerance: float = 0.0, even_odd: bool = False, rounded: bool = False) -> None:
        for name, given in ("vertices", vertices), ("faces", faces), ("colors", colors):
            _refuse_mask(given, f"Scene: {name}")
        points = np.require(vertices, np.float64, "CA")
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"Scene: vertices have the shape {points.shape}, not (n, 3)")
        start, corners = _pack(faces)
        mesh = c.mesh(vertex_count=len(points), face_count=len(start) - 1, corner_count=len(corners),
                      vertex=points.ctypes.data, face_start=start.ctypes.data, corner=corners.ctypes.data)
        mesh.arrays = [points, start, corners]  # they live as long as the mesh
        if colors is not None:
            mesh.arrays.append(_face_colors(colors, mesh.face_count))
            mesh.face_color = mesh.arrays[-1].ctypes.data
        c.check("mesh_check", ctypes.byref(mesh))
        self._build(mesh, c.scene_options(tolerance=tolerance, hull=hull, solids=solids, even_odd=even_odd,
                                          rounded=rounded), _Warned())

    def _build(self, mesh: c.mesh, options: c.scene_options, warned: _Warned) -> None:
        options.warnings = warned.struct
        handle = ctypes.c_void_p()
        c.check("scene_build", ctypes.byref(mesh), ctypes.byref(options), ctypes.byref(handle))
        weakref.finalize(self, c.lib.roberts_scene_free, handle)
        self._mesh, self._handle = mesh, handle
        self.name = ""
        warned.issue()

    @property
    def vertices(self) -> np.ndarray:
        """(n, 3) float64: the vertices of the input. A view."""
        return _array(self, self._mesh.vertex, self._mesh.vertex_count, _vec3)

    @property
    def face_start(self) -> np.ndarray:
        """(m + 1,) uint32: face f has the corners corners[face_start[f]:face_start[f + 1]]. A view."""
        count = self._mesh.face_count
        return _array(self, self._mesh.face_start, count + 1 if count else 0, np.uint32)

    @property
    def corners(self) -> np.ndarray:
        """(k,) uint32: vertex numbers of all faces, one after the other. A view."""
        return _array(self, self._mesh.corner, self._mesh.corner_count, np.uint32)

    @property
    def faces(self) -> Union[np.ndarray, list[np.ndarray]]:
        """(m, k) uint32 if all faces have k corners, else a list of m arrays. Views, too."""
        count, corners = self._mesh.face_count, self.corners
        if count and self._mesh.corner_count % count == 0:
            k = self._mesh.corner_count // count
            if k and np.all(np.diff(self.face_start) == k):
                return corners.reshape(count, k)
        return np.split(corners, self.face_start[1:-1]) if count else []

    def _sides(self) -> np.ndarray:
        """(k, 2) uint32: the sides of all faces, by their vertices, the smaller number first."""
        start, corners = self.face_start, self.corners
        first, end = start[:-1][np.diff(start) > 0], start[1:][np.diff(start) > 0]
        following = np.roll(corners, -1)
        following[end - 1] = corners[first]
        return np.sort(np.column_stack([corners, following]), 1)

    @property
    def body_count(self) -> int:
        return c.lib.roberts_scene_solid_count(self._handle)

    def body_kind(self, body: int) -> str:
        """convex, closed or open."""
        if not 0 <= body < self.body_count:
            raise IndexError(f"there is no body {body}")
        return _KINDS[c.lib.roberts_scene_body_kind(self._handle, body)]

    def body_name(self, body: int) -> str:
        """The name of the body's group in the file; "" if it has none."""
        if not 0 <= body < self.body_count:
            raise IndexError(f"there is no body {body}")
        return c.text(c.lib.roberts_scene_name(self._handle, body))

    def hide(self, where: ViewLike = None, **options: Any) -> Drawing:
        """Removes the hidden lines, as seen by `where`: a View, or the name of a preset.

        options  fields of roberts_hide_options: keep_hidden (give hidden segments, too), unite (draw all closed bodies
                 as one), crease_degrees, crease_auto, all_edges, levels, nameless (no `by`), epsilon, threads. If
                 crease_degrees is given, it holds for curved bodies, too.
        Raises Error, MemoryError.
        """
        return Drawing(self, _camera(where), options)

    def turntable(self, count: int, where: ViewLike = None, **options: Any) -> Iterator[Drawing]:
        """`count` drawings, one after another, of the scene as it turns once about the upright line through its middle.

        All share one window: on pages of one size they have one scale, and the middle keeps its place. The first is
        seen by `where`.
        options  see hide()
        Raises Error, MemoryError, ValueError; what is wrong with options, when the first drawing is asked for.
        """
        if count < 1:
            raise ValueError(f"turntable: {count} pictures are none")
        first = _camera(where)
        cameras = [c.camera.from_buffer_copy(first) for _ in range(count)]
        low, high, framed = c.vec2(), c.vec2(), ctypes.c_bool()
        windows = []
        for step, camera in enumerate(cameras):
            c.lib.roberts_camera_turn(self._handle, 360.0 * step / count, ctypes.byref(camera))
            c.check("window", self._handle, ctypes.byref(camera), ctypes.byref(low), ctypes.byref(high),
                    ctypes.byref(framed))
            windows.append((low.x, low.y, high.x, high.y, framed.value))
        x0, y0, x1, y1, frames = zip(*windows)
        window = c.vec2(min(x0), min(y0)), c.vec2(max(x1), max(y1)), any(frames)
        return (Drawing(self, camera, options)._within(*window) for camera in cameras)

    def sheet(self, angle: str = "first", **options: Any) -> Sheet:
        """The front, the top, the side and the isometric view, for one page.

        angle    first: the top view stands below, the view from the left at the right; third: the top view stands
                 above, the view from the right at the right (ISO 5456-2)
        options  see hide(); the isometric view has no hidden segments
        Raises Error, MemoryError, ValueError.
        """
        return Sheet(self, _choice(_ANGLES, angle, "sheet"), options)

    def regions(self, where: ViewLike = None, **options: Any) -> Regions:
        """What is seen of each face.

        options  merge_regions (coplanar neighbours of one colour are one), slopes, unite, epsilon, grid, threads
        Raises Error, MemoryError, TypeError.
        """
        return Regions(self, _camera(where), options)

    def project(self, points: Any, where: ViewLike = None) -> np.ndarray:
        """Where points of the model, (n, 3) numbers, lie in the picture, seen or not.

        Returns (n, 3) float64: x and y as p0 of segments, z as z0; NaN what the near plane cuts off.
        Raises Error, ValueError.
        """
        _refuse_mask(points, "project: points")
        camera, given = _camera(where), np.require(points, np.float64, "CA")
        if given.ndim != 2 or given.shape[1] != 3:
            raise ValueError(f"project: points are (n, 3) numbers, not {given.shape}")
        places = np.empty_like(given)
        c.check("project", self._handle, ctypes.byref(camera), given.ctypes.data, len(given), places.ctypes.data)
        return places

    def _repr_svg_(self) -> str:
        return self.hide()._repr_svg_()

    def __repr__(self) -> str:
        bodies, faces = self.body_count, self._mesh.face_count
        return (f"<roberts.Scene {self.name!r}: {bodies} {'body' if bodies == 1 else 'bodies'}, "
                f"{self._mesh.vertex_count} vertices, {faces} face{'s' * (faces != 1)}>")


def _refuse_mask(values: Any, what: str) -> None:
    if np.ma.is_masked(values):
        raise ValueError(f"{what}: some are masked; give those that are not alone")


def _face_colors(colors: Any, count: int) -> np.ndarray:
    """Colours as the library has them."""
    given = np.asarray(colors)
    if given.ndim != 2 or len(given) != count or given.shape[1] not in (3, 4) or given.dtype.kind not in "uif":
        raise ValueError(f"Scene: colors have the shape {given.shape}, not ({count}, 3) or ({count}, 4)")
    values = given / 255.0 if given.dtype.kind in "ui" else given
    if not np.all((values >= 0.0) & (values <= 1.0)):
        raise ValueError("Scene: colors are whole numbers from 0 to 255, or others from 0 to 1")
    packed = np.zeros(count, _COLOR)
    packed["count"], packed["value"][:, :given.shape[1]] = given.shape[1], values
    return packed


def _pack(faces: Any) -> tuple[np.ndarray, np.ndarray]:
    """Faces as starts and corners, uint32 and contiguous."""
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        count, k = faces.shape
        lengths, corners = np.full(count, k), faces.reshape(-1)
    else:
        rows = [np.asarray(face) for face in faces]
        if any(row.ndim != 1 for row in rows):
            raise ValueError("Scene: each face is a sequence of vertex numbers")
        lengths = np.array([len(row) for row in rows], np.int64)
        rows = [row for row in rows if len(row)]  # an array of nothing is one of float64
        corners = np.concatenate(rows) if rows else np.empty(0, np.uint32)
    if corners.size and corners.dtype.kind not in "iu":
        raise ValueError("Scene: faces are made of whole numbers")
    if corners.size and (corners.min() < 0 or corners.max() >= NONE):
        raise ValueError("Scene: a face names a vertex below 0, or beyond 4294967294")
    start = np.concatenate([[0], np.cumsum(lengths)])
    if start[-1] > NONE:
        raise ValueError("Scene: there are too many corners")
    return np.require(start, np.uint32, "CA"), np.require(corners, np.uint32, "CA")


def read(what: PathOrBytes, *, name: Optional[str] = None, hull: bool = False, solids: bool = False,
         tolerance: float = 0.0, even_odd: bool = False, rounded: bool = False) -> Scene:
    """Reads an OFF, STL, OBJ or PLY file, text or binary; its content decides which.

    what  a path ("-" is standard input), or the bytes of a file
    name  what messages and the drawing's title call it; None: the path's last part
    The others are those of Scene. Raises Error (with file and line), MemoryError, ValueError.
    """
    scene = Scene.__new__(Scene)
    mesh, warned = c.mesh(), _Warned()
    weakref.finalize(scene, c.lib.roberts_mesh_free, ctypes.byref(mesh))
    if isinstance(what, (bytes, bytearray, memoryview)):
        data = bytes(what)
        c.check("mesh_read_memory", ctypes.byref(mesh), os.fsencode(name or "data"), data, len(data),
                ctypes.byref(warned.struct))
    else:
        if isinstance(what, str) and "\n" in what and not os.path.exists(what):
            raise ValueError("read: a str is a path, and this one has several lines; the content of a file has to be "
                             "bytes, as of text.encode()")
        path = os.fspath(what)
        name = name or os.path.basename(path)
        c.check("mesh_read_file", ctypes.byref(mesh), os.fsencode(path), ctypes.byref(warned.struct))
    scene._build(mesh, c.scene_options(tolerance=tolerance, hull=hull, solids=solids, even_odd=even_odd,
                                       rounded=rounded), warned)
    scene.name = name or ""
    return scene


# ---- what is seen ---------------------------------------------------------------------------------------------------


_REGION_OPTIONS = ("epsilon", "grid", "merge_regions", "slopes", "threads", "unite")
_HIDE_OPTIONS = [name for name, *_ in c.hide_options._fields_ if name not in ("merge_regions", "slopes")]


def _hide_options(values: Mapping[str, Any], what: str, names: Sequence[str]) -> c.hide_options:
    options = c.lib.roberts_hide_options_default()
    if "crease_degrees" in values:
        options.crease_auto = False
    for name in values:
        if name in (view.__kwdefaults__ or {}):
            raise TypeError(f"{what}: {name} belongs to the view: {what}(roberts.view({name}=...))")
    _fill(options, values, what, names)
    return options


class Regions:
    """What is seen of each face; made by Scene.regions(). All arrays are views of the library's memory.

    regions     (n,) structured: solid, face, first_ring, ring_count, area, z_min, z_max, normal, color,
                section; as roberts_region
    slopes      (n,) structured: steep, level, foot; as roberts_slope
    ring_start  (r + 1,): ring i has the corners corners[ring_start[i]:ring_start[i + 1]]
    corners     (k, 2) float64, picture, model units, y up
    """

    def __init__(self, scene: Scene, camera: c.camera, options: Mapping[str, Any]) -> None:
        self._list = c.region_list()
        weakref.finalize(self, c.lib.roberts_regions_free, ctypes.byref(self._list))
        choice = _hide_options(options, "regions", _REGION_OPTIONS)
        c.check("regions", scene._handle, ctypes.byref(camera), ctypes.byref(choice), ctypes.byref(self._list))

    @property
    def regions(self) -> np.ndarray:
        return _array(self, self._list.region, self._list.count, _REGION)

    @property
    def slopes(self) -> np.ndarray:
        return _array(self, self._list.slope, self._list.count, _SLOPE)

    @property
    def ring_start(self) -> np.ndarray:
        rings = self._list.ring_count
        return _array(self, self._list.ring_start, rings + 1 if rings else 0, np.uintp)

    @property
    def corners(self) -> np.ndarray:
        return _array(self, self._list.corner, self._list.corner_count, _vec2)

    def rings(self, region: int) -> list[np.ndarray]:
        """The rings of a region, (k, 2) each: counter-clockwise round a piece, clockwise round a hole in it."""
        row, start, corners = self.regions[region], self.ring_start, self.corners
        first = int(row["first_ring"])
        return [corners[int(start[i]):int(start[i + 1])] for i in range(first, first + int(row["ring_count"]))]

    def __len__(self) -> int:
        return self._list.count


class _Drawable:
    """What can be written on a page: a drawing or a sheet."""

    _scene: Scene

    def _drawings(self) -> list[Drawing]:
        raise NotImplementedError

    def _call(self, what: str, page: _Page, *arguments: Any) -> None:
        """Calls the library's function for this: "save" or "write"."""
        raise NotImplementedError

    def save(self, path: Union[str, "os.PathLike[str]"], *, format: Optional[str] = None, **options: Any) -> None:
        """Writes the drawing; a file appears whole or not at all.

        format   svg, pdf, ps, eps, png, tikz, dxf, hpgl, csv or json; None: as the path's ending says
        options  see svg()
        Raises Error, MemoryError, ValueError.
        """
        path, ending = os.fspath(path), ctypes.c_int()
        named = c.lib.roberts_format_by_path(os.fsencode(path), ctypes.byref(ending))
        number = _format(format) if format is not None else ending.value if named else None
        if number is None:
            raise ValueError(f"save: no format is called {format!r}" if format is not None
                             else f"save: {path!r} does not end in the name of a format")
        page = _Page(self, number, options)
        if named and ending.value != number:
            page.warned.said.append(f"{os.fsdecode(path)}: its ending names another format, but it is {format}")
        self._call("save", page, os.fsencode(path))
        page.warned.issue()

    def svg(self, **options: Any) -> str:
        """The drawing as SVG: the bytes that the program writes, if title and description are the same.

        hidden            none, dashed or solid: hidden lines, which hide() must have kept (keep_hidden); default:
                          dashed if it did, else none
        page              (width, height) or (width, height, margin), mm; default: A4 upright with margins of 10
        scale             mm on paper for each model unit; default: as large as the margins allow
        pens              a dict of pens by class (outline, border, crease, intersection, wire, hidden, frame,
                          symbol, hatch, text, hidden_text), each a dict of width, dash, gap (mm), color (red,
                          green, blue; 0 to 255), off, number; a frame is drawn if it has a pen here
        background        (red, green, blue)
        fill              none, white, model, body, (red, green, blue), shade (model, but shaded), shade:white or
                          shade:body
        shaded            fills are darker where less light falls
        hatch             True, or a dict with fields of roberts_hatching
        light             toward the light, as the viewer sees it: three numbers
        labels            vertices, edges, faces, bodies or names (of bodies, from the file), or a sequence
        names             names that labels show, a dict of dicts: {"vertices": {0: "A"}, "edges": {(0, 4): "a"},
                          "faces": {2: "top"}, "bodies": {1: "leg"}}; what has a name is labelled; "": no label
        label_size        mm: the height of the capitals of labels
        text              strokes (the default), or native: in SVG, PDF and TikZ, text in a font of the viewer
        columns           tables: further columns: ends, depth, level (needs hide(levels=True)), name, by; or a sequence
        group             class, body or element: the structure of the SVG
        id_prefix, title, description    strings
        crop, dpi, real_dashes, number_layers  as in roberts_draw_options
        Raises Error, MemoryError, TypeError, ValueError.
        """
        return self._text("svg", options)

    def csv(self, **options: Any) -> str:
        """The table of the segments: what save() writes as CSV. pandas.read_csv(io.StringIO(...)) reads it.

        options  columns and hidden; see svg()
        Raises Error, MemoryError, TypeError, ValueError.
        """
        return self._text("csv", options)

    def _text(self, format: str, options: Mapping[str, Any]) -> str:
        page, parts = _Page(self, _format(format), options), []

        def write(_context: Any, data: int, size: int) -> bool:
            parts.append(ctypes.string_at(data, size))
            return True

        self._call("write", page, c.WRITE_FN(write), None)
        page.warned.issue()
        return b"".join(parts).decode("utf-8")


class Drawing(_Drawable):
    """The segments of all lines of a scene, seen from one side; made by Scene.hide().

    All arrays are views of the library's memory.
    """

    def __init__(self, scene: Scene, camera: c.camera, options: Mapping[str, Any]) -> None:
        self._scene, self._camera, self._options = scene, camera, dict(options)
        self._drawing = c.drawing()
        self._keeps_hidden = bool(options.get("keep_hidden", False))
        weakref.finalize(self, c.lib.roberts_drawing_free, ctypes.byref(self._drawing))
        choice = _hide_options(options, "hide", _HIDE_OPTIONS)
        c.check("hide", scene._handle, ctypes.byref(camera), ctypes.byref(choice), ctypes.byref(self._drawing))

    @property
    def segments(self) -> np.ndarray:
        """(n,) structured: solid, v0, v1, by, t0, t1, p0, p1, z0, z1, state, line, level, edge; as roberts_segment.

        p0 and p1 are (n, 2), in the picture, model units, y up.
        """
        return _array(self, self._drawing.segment, self._drawing.count, _SEGMENT)

    @property
    def crossings(self) -> np.ndarray:
        """(n,) structured: face (2), end (2, 3): where faces cross, in the model."""
        return _array(self, self._drawing.crossing, self._drawing.crossing_count, _CROSSING)

    @property
    def window(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """The lower left and the upper right corner of the picture, model units."""
        low, high = self._drawing.window_min, self._drawing.window_max
        return (low.x, low.y), (high.x, high.y)

    def __len__(self) -> int:
        return self._drawing.count

    def _within(self, low: c.vec2, high: c.vec2, framed: bool) -> Drawing:
        """Gives the drawing a window that others share. Returns the drawing."""
        self._drawing.window_min, self._drawing.window_max = low, high
        self._drawing.windowed, self._drawing.framed = True, framed
        return self

    def _drawings(self) -> list[Drawing]:
        return [self]

    def _call(self, what: str, page: _Page, *arguments: Any) -> None:
        c.check("drawing_" + what, ctypes.byref(page.drawings[0]), ctypes.byref(page.options), *arguments)

    def _repr_svg_(self) -> str:
        (x0, y0), (x1, y1) = self.window
        wide, high = max(x1 - x0, 0.0), max(y1 - y0, 0.0)
        unit = 150.0 / max(wide, high) if max(wide, high) > 0.0 else 1.0
        return self.svg(page=(max(wide * unit, 10.0) + 4.0, max(high * unit, 10.0) + 4.0, 2.0),
                        background=(255, 255, 255))

    def __repr__(self) -> str:
        return f"<roberts.Drawing {self._scene.name!r}: {len(self)} segment{'s' * (len(self) != 1)}>"


class Sheet(_Drawable):
    """Several views of a scene on one page; made by Scene.sheet(). `views` holds their drawings by name."""

    def __init__(self, scene: Scene, angle: int, options: Mapping[str, Any]) -> None:
        self._scene, self._angle, self.views = scene, angle, {}
        for number, name in enumerate(_SHEET_VIEWS):
            camera = c.camera()
            c.lib.roberts_sheet_camera(angle, number, ctypes.byref(camera))
            hidden = options.get("keep_hidden", False) and name != "iso"  # as ISO 5456-3 prefers
            self.views[name] = Drawing(scene, camera, {**options, "keep_hidden": hidden})

    def _drawings(self) -> list[Drawing]:
        return list(self.views.values())

    def _call(self, what: str, page: _Page, *arguments: Any) -> None:
        views = (ctypes.POINTER(c.drawing) * 4)(*map(ctypes.pointer, page.drawings))
        sheet = c.sheet(self._angle, 0.0, views)
        c.check("sheet_" + what, ctypes.byref(sheet), ctypes.byref(page.options), *arguments)

    def _repr_svg_(self) -> str:
        return self.svg(page=(210.0, 150.0, 5.0), background=(255, 255, 255))

    def __repr__(self) -> str:
        return f"<roberts.Sheet {self._scene.name!r}: {', '.join(self.views)}>"


def _format(name: str) -> Optional[int]:
    number = ctypes.c_int()
    return number.value if c.lib.roberts_format_by_name(name.encode(), ctypes.byref(number)) else None


class _Page:
    """The options of one page, and what they borrow."""

    def __init__(self, what: _Drawable, format: int, given: Mapping[str, Any]) -> None:
        given, drawings = dict(given), what._drawings()
        of = drawings[0]  # the scene and the options are the same for all
        o = self.options = c.lib.roberts_draw_options_default()
        self.warned = _Warned()
        self.drawings = [c.drawing.from_buffer_copy(one._drawing) for one in drawings]  # these share the segments
        self.regions = []
        o.format, o.scene, o.lettering.warnings = format, of._scene._handle, self.warned.struct
        self._tell(format, given)
        o.hidden = _choice(_HIDDEN, given.pop("hidden", "dashed" if of._keeps_hidden else "none"), "hidden")
        if o.hidden != _HIDDEN["none"] and not any(one._keeps_hidden for one in drawings):
            raise ValueError("hidden: these lines were not kept; hide(..., keep_hidden=True) keeps them")
        o.grouping = _choice(_GROUPS, given.pop("group", "class"), "group")
        self._texts(of, given)
        self._paper(given)
        if self._paint(of, given):
            regions = {name: of._options[name] for name in _REGION_OPTIONS if name in of._options}
            self.regions = [Regions(one._scene, one._camera, regions) for one in drawings]
            for drawing, seen in zip(self.drawings, self.regions):
                drawing.regions = ctypes.addressof(seen._list)
            colored = any(seen.regions["color"]["count"].any() for seen in self.regions)
            if o.fill == _FILLS["model"][0] and not o.shaded and not colored and format not in map(_format, _TABLES):
                self.warned.said.append("fill has no effect: no face that is seen has a colour")
        columns = _names(given.pop("columns", ()))
        if len(set(columns)) < len(columns):
            raise ValueError("columns: each once")
        o.column_count = len(columns)
        for i, name in enumerate(columns):
            o.column[i] = _choice(_COLUMNS, name, "columns")
            if name == "level" and format in map(_format, _TABLES) and not of._options.get("levels", False):
                raise ValueError("columns: levels were not computed; hide(..., levels=True) computes them")
        for name in ("crop", "dpi", "real_dashes", "number_layers"):
            if name in given:
                _set(o, name, given.pop(name), name)
        if "label_size" in given:
            _set(o.lettering, "height_mm", given.pop("label_size"), "label_size")
        o.lettering.native = _choice(_TEXTS, given.pop("text", "strokes"), "text")
        if given:
            raise _unknown("", next(iter(given)), _OPTIONS)

    def _tell(self, format: int, given: dict) -> None:
        """Warns of options that have no effect in a format."""
        table = format in map(_format, _TABLES)
        for name in given:
            formats = _ONLY_IN.get(name, ())
            if formats and format not in map(_format, formats):
                self.warned.said.append(f"{name} has no effect: it is for {' and '.join(formats)}")
            elif table and not formats and name != "hidden":
                self.warned.said.append(f"{name} has no effect: tables have no page")

    def _texts(self, of: Drawing, given: dict) -> None:
        for name, default in (("title", of._scene.name or None), ("description", None), ("id_prefix", None)):
            value = given.pop(name, default)
            if value is not None and not isinstance(value, str):
                raise TypeError(f"{name}: it is a str, not {value!r}")
            if name == "id_prefix" and value is not None and not re.fullmatch(r"[A-Za-z_][-.\w]*", value, re.ASCII):
                raise ValueError(f"{name}: {value!r} cannot begin an id: it needs a letter or _, then letters, digits, "
                                 "- . or _")
            # names of files need not be UTF-8; the library writes a ? for each byte that is not
            setattr(self.options, name, value.encode("utf-8", "surrogateescape") if value is not None else None)

    def _paper(self, given: dict) -> None:
        o = self.options
        if "page" in given:
            page, wanted = given.pop("page"), "page: it is (width, height) or (width, height, margin), numbers of mm"
            if isinstance(page, (str, bytes)) or not hasattr(page, "__iter__"):
                raise TypeError(f"{wanted}, not {page!r}")
            page = [*page]
            if not 2 <= len(page) <= 3:
                raise ValueError(wanted)
            for name, value in zip(("width_mm", "height_mm", "margin_mm"), page):
                _set(o.page, name, value, "page")
        if "scale" in given:
            _set(o.placement, "scale", given.pop("scale"), "scale")
        for name, values in given.pop("pens", {}).items():
            pen = getattr(o, _choice(_PENS, name, "pens"))
            pen.off = False
            for key, value in values.items():
                if key == "color":
                    pen.red, pen.green, pen.blue = _color(value, "pens: color")
                elif key in _PEN:
                    _fill(pen, {_PEN[key]: value}, "pens")
                else:
                    raise _unknown("pens: ", key, ("color", *_PEN))
        if "background" in given:
            o.background = c.background(True, *_color(given.pop("background"), "background"))

    def _paint(self, of: Drawing, given: dict) -> bool:
        """Fills, hatching and labels. Returns whether they need regions."""
        o, fill, hatch, shaded = self.options, given.pop("fill", None), given.pop("hatch", None), False
        if fill is not None and not isinstance(fill, str):
            o.fill, o.fill_color = 1, (ctypes.c_ubyte * 3)(*_color(fill, "fill"))
        elif fill is not None:
            o.fill, shaded = _choice(_FILLS, fill, "fill", ", or (red, green, blue)")
        o.shaded = given.pop("shaded", False) or shaded
        if isinstance(hatch, Mapping):
            o.hatching.on = True
            _fill(o.hatching, hatch, "hatch")
        elif hatch is not None:
            _set(o.hatching, "on", hatch, "hatch, unless it is a dict")
        if o.shaded and not o.fill:
            self.warned.said.append("shaded has no effect: nothing is filled without fill")
        if "light" in given:
            o.light = _vector(given.pop("light"), "light")
            if not (o.shaded and o.fill or o.hatching.on and not o.hatching.sections):
                self.warned.said.append("light has no effect: nothing is shaded without a shaded fill or hatch")
        for name in _names(given.pop("labels", ())):
            o.lettering.labels |= _choice(_LABELS, name, "labels")
        areas = _LABELS["faces"] | _LABELS["bodies"] | _LABELS["names"]
        named = self._name(of, given.pop("names", {}))
        return bool(o.fill or o.hatching.on or (o.lettering.labels | named) & areas)

    def _name(self, of: Drawing, names: Mapping[str, Mapping]) -> int:
        """Gives labels their names. Returns the kinds of what has one."""
        if not isinstance(names, Mapping) or not all(isinstance(some, Mapping) for some in names.values()):
            raise TypeError('names: a dict of dicts, such as {"vertices": {0: "A"}}')
        for kind in names:
            if kind not in _NAMED:
                raise _unknown("names: ", kind, _NAMED)
        mesh, item, kinds = of._scene._mesh, {}, 0
        counts = dict(zip(_NAMED, (mesh.vertex_count, mesh.vertex_count, mesh.face_count, of._scene.body_count)))
        sides = of._scene._sides() if names.get("edges") else ()
        for kind, some in names.items():
            for key, text in some.items():
                ends = list(key) if kind == "edges" and isinstance(key, tuple) else [key]
                if len(ends) != 1 + (kind == "edges") or not all(
                        isinstance(n, (int, np.integer)) and not isinstance(n, bool) for n in ends):
                    wanted = "pair of vertices" if kind == "edges" else "number"
                    raise TypeError(f"names: {kind}: {key!r} is no {wanted}")
                if not all(0 <= n < counts[kind] for n in ends) or (
                        kind == "edges" and not (np.sort(ends) == sides).all(1).any()):
                    raise ValueError(f"names: {kind}: there is no {key!r}")
                if not isinstance(text, str):
                    raise TypeError(f"names: {kind}: {key!r}: a name is a str, not {text!r}")
                name = (_LABELS[kind], *sorted(ends), 0)[:3]
                if name in item:
                    raise ValueError(f"names: {kind}: {key!r} has a name already")
                item[name] = text.encode("utf-8", "surrogateescape")
                kinds |= _LABELS[kind]
        self._list = (c.name * len(item))(*((*key, item[key]) for key in sorted(item)))
        lettering = self.options.lettering
        lettering.name_count, lettering.name = len(item), ctypes.cast(self._list, ctypes.c_void_p)
        return kinds
