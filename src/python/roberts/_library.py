"""The shared library as roberts.h declares it: the structs, the functions, and errors as exceptions.

Fields have the names and the order of the header. tests/python/test_roberts.py compares all sizes and offsets with
those of the C compiler. Each `*_p` is a pointer whose memory the library owns.
"""

import ctypes
import os
from ctypes import (
    POINTER, Structure, byref, c_bool, c_char, c_char_p, c_double, c_float, c_int, c_size_t, c_ssize_t, c_ubyte,
    c_uint, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p,
)

NONE = 0xFFFFFFFF
"""No vertex, face or body."""

STATUS = ("OK", "NO_MEMORY", "IO", "BAD_SYNTAX", "BAD_INDEX", "BAD_NUMBER", "NOT_CLOSED", "NOT_PLANAR", "NOT_CONVEX",
          "FLAT", "BAD_VIEW", "BAD_ARGUMENT", "STOPPED")


class vec2(Structure):
    _fields_ = [("x", c_double), ("y", c_double)]


class vec3(Structure):
    _fields_ = [("x", c_double), ("y", c_double), ("z", c_double)]


class error(Structure):
    _fields_ = [("status", c_int), ("file", c_char * 256), ("line", c_size_t), ("message", c_char * 256)]


WARNING_FN = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_size_t, c_char_p)
WRITE_FN = ctypes.CFUNCTYPE(c_bool, c_void_p, c_void_p, c_size_t)


class warnings(Structure):
    _fields_ = [("warn", WARNING_FN), ("context", c_void_p)]


class color(Structure):
    _fields_ = [("count", c_ubyte), ("value", c_float * 4)]


class source(Structure):
    _fields_ = [("name", c_char_p), ("first_vertex", c_uint32), ("first_face", c_uint32), ("float32", c_bool),
                ("missing", c_char_p)]


class group(Structure):
    _fields_ = [("name", c_char_p), ("first_face", c_uint32)]


class mesh(Structure):
    _fields_ = [(name, c_size_t) for name in
                ("vertex_count", "face_count", "corner_count", "source_count", "group_count")] + [
        ("vertex", c_void_p), ("face_start", c_void_p), ("corner", c_void_p), ("vertex_color", c_void_p),
        ("face_color", c_void_p), ("source", POINTER(source)), ("group", POINTER(group))] + [
        (name, c_size_t) for name in ("vertex_room", "face_room", "corner_room", "vertex_color_room",
                                      "face_color_room", "source_room", "group_room")] + [("threads", c_uint32)]


class scene_options(Structure):
    _fields_ = [("tolerance", c_double), ("hull", c_bool), ("warnings", warnings), ("threads", c_uint32),
                ("solids", c_bool), ("even_odd", c_bool), ("rounded", c_bool)]


class camera(Structure):
    _fields_ = [("projection", c_int), ("dir", vec3), ("eye", vec3), ("look_at", vec3), ("has_look_at", c_bool),
                ("up", vec3), ("oblique", vec2), ("near_distance", c_double), ("section", vec3),
                ("section_normal", vec3), ("has_section", c_bool), ("fov_degrees", c_double),
                ("roll_degrees", c_double)]


class segment(Structure):
    _fields_ = [("solid", c_uint32), ("v0", c_uint32), ("v1", c_uint32), ("by", c_uint32), ("t0", c_double),
                ("t1", c_double), ("p0", vec2), ("p1", vec2), ("z0", c_double), ("z1", c_double), ("state", c_uint8),
                ("line", c_uint8), ("level", c_uint16), ("edge", c_uint32)]


class crossing(Structure):
    _fields_ = [("face", c_uint32 * 2), ("end", vec3 * 2)]


class tally(Structure):
    _fields_ = [(name, c_uint64) for name in ("pairs", "test1_visible", "test2_visible", "test3_visible",
                                              "test3_invisible", "test4", "covered", "pierced", "refined")]


class time(Structure):
    _fields_ = [("cpu", c_double), ("wall", c_double)]


class drawing(Structure):
    _fields_ = [("count", c_size_t), ("segment", c_void_p), ("crossing_count", c_size_t), ("crossing", c_void_p),
                ("crossing_pairs", c_size_t), ("window_min", vec2), ("window_max", vec2), ("framed", c_bool),
                ("sectioned", c_bool), ("windowed", c_bool), ("regions", c_void_p), ("epsilon", c_double),
                ("epsilon_reason", c_int), ("scene_diameter", c_double), ("grid", c_uint32), ("grid_rows", c_uint32),
                ("solids", c_size_t), ("culled_solids", c_size_t), ("front_faces", c_size_t), ("back_faces", c_size_t),
                ("edge_on_faces", c_size_t), ("edges", c_size_t), ("surviving_edges", c_size_t), ("seams", c_size_t),
                ("drawn_edges", c_size_t), ("tally", tally), ("view_time", time), ("grid_time", time),
                ("hide_time", time), ("region_time", time), ("known_edge_count", c_size_t), ("known_edge", c_void_p),
                ("cut_count", c_size_t)]


class hide_options(Structure):
    _fields_ = [("crease_degrees", c_double), ("crease_auto", c_bool), ("all_edges", c_bool), ("keep_hidden", c_bool),
                ("levels", c_bool), ("nameless", c_bool), ("unite", c_bool), ("merge_regions", c_bool),
                ("slopes", c_bool), ("epsilon", c_double), ("grid", c_uint32), ("threads", c_uint32)]


class region(Structure):
    _fields_ = [("solid", c_uint32), ("face", c_uint32), ("first_ring", c_size_t), ("ring_count", c_size_t),
                ("area", c_double), ("z_min", c_double), ("z_max", c_double), ("normal", vec3), ("color", color),
                ("section", c_bool)]


class slope(Structure):
    _fields_ = [("steep", vec2), ("level", vec2), ("foot", vec2)]


class region_list(Structure):
    _fields_ = [("count", c_size_t), ("ring_count", c_size_t), ("corner_count", c_size_t), ("region", c_void_p),
                ("ring_start", c_void_p), ("corner", c_void_p), ("slope", c_void_p), ("united", c_bool)]


class pen(Structure):
    _fields_ = [("width_mm", c_double), ("dash_mm", c_double), ("gap_mm", c_double), ("red", c_ubyte),
                ("green", c_ubyte), ("blue", c_ubyte), ("off", c_bool), ("number", c_ubyte)]


class background(Structure):
    _fields_ = [("on", c_bool), ("red", c_ubyte), ("green", c_ubyte), ("blue", c_ubyte)]


class hatching(Structure):
    _fields_ = [("on", c_bool), ("spacing_mm", c_double), ("levels", c_uint32), ("along", c_int),
                ("degrees", c_double), ("nested", c_bool), ("cross", c_double), ("shortest_mm", c_double),
                ("sections", c_bool)]


class page(Structure):
    _fields_ = [("width_mm", c_double), ("height_mm", c_double), ("margin_mm", c_double)]


class placement(Structure):
    _fields_ = [("scale", c_double), ("unit_mm", c_double), ("align_x", c_int), ("align_y", c_int),
                ("standard", c_bool)]


class name(Structure):
    _fields_ = [("of", c_int), ("number", c_uint32), ("other", c_uint32), ("text", c_char_p)]


class lettering(Structure):
    _fields_ = [("height_mm", c_double), ("native", c_bool), ("labels", c_uint), ("name_count", c_size_t),
                ("name", c_void_p), ("title", c_char_p), ("field_count", c_size_t), ("field", c_void_p),
                ("overall", c_bool), ("distance_count", c_size_t), ("distance", c_void_p), ("zones", c_bool),
                ("unit", c_char_p), ("warnings", warnings)]


class plotter(Structure):
    _fields_ = [("centre", c_bool), ("turn", c_uint32), ("inside_mm", vec2)]


PENS = ("outline", "border", "crease", "intersection", "wire", "back", "frame", "symbol", "hatch", "text",
        "hidden_text")


class draw_options(Structure):
    _fields_ = [("format", c_int), ("hidden", c_int), ("page", page), ("crop", c_bool)] + [
        (name, pen) for name in PENS] + [
        ("lettering", lettering), ("background", background), ("hatching", hatching), ("fill", c_int),
        ("fill_color", c_ubyte * 3), ("shaded", c_bool), ("light", vec3), ("placement", placement), ("order", c_int),
        ("scene", c_void_p), ("column_count", c_size_t), ("column", c_int * 5), ("real_dashes", c_bool),
        ("number_layers", c_bool), ("grouping", c_int), ("id_prefix", c_char_p), ("plotter", plotter),
        ("dpi", c_double), ("title", c_char_p), ("description", c_char_p), ("ink", c_void_p), ("temporary", c_void_p),
        ("temporary_context", c_void_p)]


class sheet(Structure):
    _fields_ = [("angle", c_int), ("gap_mm", c_double), ("view", POINTER(drawing) * 4)]


STRUCTS = (vec2, vec3, error, warnings, color, source, group, mesh, scene_options, camera, segment, crossing, tally,
           time, drawing, hide_options, region, slope, region_list, pen, background, hatching, page, placement,
           lettering, plotter, draw_options, sheet)

VERSION = "0.1.0"
"""Of the header that the structs come from: a library with another one may have others."""

INSTALLED = ""  # `make install-python` writes the library's path here


def _load() -> ctypes.CDLL:
    """ROBERTS_LIBRARY decides; else the library that was installed with the package; else the loader finds it."""
    path = os.environ.get("ROBERTS_LIBRARY")
    if not path:
        path = INSTALLED if os.path.exists(INSTALLED) else "libroberts.so.0"
    library = ctypes.CDLL(path)
    version = getattr(library, "roberts_version", None)
    if version:
        version.restype = c_char_p
    found = version().decode() if version else "older"
    if found != VERSION:
        raise ImportError(f"the package is of roberts {VERSION}, but the library {path} is {found}", name="roberts",
                          path=path)
    return library


lib = _load()


def _declare(name: str, result, *arguments) -> None:
    function = getattr(lib, "roberts_" + name)
    function.restype, function.argtypes = result, arguments


_error_p = POINTER(error)
_declare("mesh_read_file", c_int, POINTER(mesh), c_char_p, POINTER(warnings), _error_p)
_declare("mesh_read_memory", c_int, POINTER(mesh), c_char_p, c_void_p, c_size_t, POINTER(warnings), _error_p)
_declare("mesh_check", c_int, POINTER(mesh), _error_p)
_declare("mesh_free", None, POINTER(mesh))
_declare("scene_build", c_int, POINTER(mesh), POINTER(scene_options), POINTER(c_void_p), _error_p)
_declare("scene_free", None, c_void_p)
for _count in ("solid", "vertex", "face", "edge"):
    _declare("scene_" + _count + "_count", c_size_t, c_void_p)
_declare("scene_body_kind", c_int, c_void_p, c_uint32)
_declare("scene_name", c_char_p, c_void_p, c_uint32)
_declare("camera_preset", c_bool, c_char_p, POINTER(camera))
_declare("camera_angles", c_bool, c_double, c_double, c_double, POINTER(camera))
_declare("camera_turn", None, c_void_p, c_double, POINTER(camera))
_declare("window", c_int, c_void_p, POINTER(camera), POINTER(vec2), POINTER(vec2), POINTER(c_bool), _error_p)
_declare("project", c_int, c_void_p, POINTER(camera), c_void_p, c_size_t, c_void_p, _error_p)
_declare("hide_options_default", hide_options)
_declare("hide", c_int, c_void_p, POINTER(camera), POINTER(hide_options), POINTER(drawing), _error_p)
_declare("drawing_free", None, POINTER(drawing))
_declare("regions", c_int, c_void_p, POINTER(camera), POINTER(hide_options), POINTER(region_list), _error_p)
_declare("regions_free", None, POINTER(region_list))
_declare("draw_options_default", draw_options)
_declare("format_by_name", c_bool, c_char_p, POINTER(c_int))
_declare("format_by_path", c_bool, c_char_p, POINTER(c_int))
_declare("drawing_write", c_int, POINTER(drawing), POINTER(draw_options), WRITE_FN, c_void_p, _error_p)
_declare("drawing_save", c_int, POINTER(drawing), POINTER(draw_options), c_char_p, _error_p)
_declare("sheet_camera", c_bool, c_int, c_int, POINTER(camera))
_declare("sheet_write", c_int, POINTER(sheet), POINTER(draw_options), WRITE_FN, c_void_p, _error_p)
_declare("sheet_save", c_int, POINTER(sheet), POINTER(draw_options), c_char_p, _error_p)


class Error(Exception):
    """What the library refuses.

    status   the name in roberts.h without its prefix: "BAD_SYNTAX", "IO", ...
    file     the name of the input or output; "" where none applies
    line     the line of the input, from 1; 0 where none applies
    message  the reason, without file and line
    """

    def __init__(self, status: str, file: str, line: int, message: str) -> None:
        self.status, self.file, self.line, self.message = status, file, line, message
        super().__init__(place(file, line) + message)

    def __reduce__(self):
        return type(self), (self.status, self.file, self.line, self.message)


class FileError(Error, OSError):
    """A file that cannot be read or written. It is an OSError, but errno is None."""


class RobertsWarning(UserWarning):
    """What the library warns of: parts of a file that it ignores, labels without room."""


def place(file: str, line: int) -> str:
    return f"{file}:{line}: " if file and line else f"{file}: " if file else f"line {line}: " if line else ""


def text(value: bytes) -> str:
    return value.decode("utf-8", "replace")


def check(name: str, *arguments) -> None:
    """Calls a function that returns a status. Raises Error, or MemoryError."""
    problem = error()
    status = getattr(lib, "roberts_" + name)(*arguments, byref(problem))
    if status == 1:
        raise MemoryError("roberts_" + name)
    if status != 0:
        kind = FileError if STATUS[status] == "IO" else Error
        raise kind(STATUS[status], text(problem.file), problem.line, text(problem.message))
