"""The Python package: tests/python/test_roberts.py BUILD FOLDER, with ROBERTS_LIBRARY set and from the top folder.

What it gives is compared with what the program in BUILD writes.
"""

import csv
import ctypes
import gc
import html
import io
import os
import pickle
import re
import shutil
import subprocess
import sys
import unittest
import warnings

import numpy as np

import roberts
from roberts import _library

BUILD, HERE = sys.argv[1:3]
CUBE = "models/platonic/cube.off"


def program(*arguments):
    return subprocess.run([os.path.join(BUILD, "roberts"), *arguments], check=True, capture_output=True).stdout


class Layout(unittest.TestCase):
    def test_structs_are_those_of_the_compiler(self):
        lines, expected = [], []
        for struct in _library.STRUCTS:
            name = "roberts_" + struct.__name__
            lines.append(f'printf("%zu\\n", sizeof({name}));')
            expected.append((name, ctypes.sizeof(struct)))
            for field, *_ in struct._fields_:
                lines.append(f'printf("%zu %zu\\n", offsetof({name}, {field}), sizeof((({name} *)0)->{field}));')
                expected.append((f"{name}.{field}", f"{getattr(struct, field).offset} {getattr(struct, field).size}"))
        source, binary = os.path.join(HERE, "layout.c"), os.path.join(HERE, "layout")
        with open(source, "w") as file:
            file.write('#include <stdio.h>\n#include "roberts.h"\nint main(void)\n{\n' + "\n".join(lines) + "\n}\n")
        subprocess.run([*os.environ.get("CC", "cc").split(), "-Iinclude", source, "-o", binary], check=True)
        printed = subprocess.run([binary], check=True, capture_output=True, text=True).stdout.splitlines()
        self.assertEqual(len(printed), len(expected))
        for (name, value), line in zip(expected, printed):
            self.assertEqual(str(value), line, name)
        self.assertGreater(len(expected), 150)

    def test_array_types_are_the_structs(self):
        for dtype, struct in ((roberts._SEGMENT, _library.segment), (roberts._CROSSING, _library.crossing),
                              (roberts._REGION, _library.region), (roberts._SLOPE, _library.slope),
                              (roberts._COLOR, _library.color)):
            self.assertEqual(dtype.itemsize, ctypes.sizeof(struct))
            self.assertEqual([name for name, *_ in struct._fields_], list(dtype.names))
            for name in dtype.names:
                self.assertEqual(dtype.fields[name][1], getattr(struct, name).offset, name)


    def test_libraries_of_other_versions_are_refused(self):
        self.assertEqual(program("--version").decode(), f"roberts {roberts.__version__}\n")
        folder = os.path.join(HERE, "other", "roberts")
        shutil.copytree(os.path.dirname(roberts.__file__), folder)
        with open(os.path.join(folder, "_library.py")) as file:
            text = file.read()
        with open(os.path.join(folder, "_library.py"), "w") as file:
            file.write(text.replace(f'VERSION = "{roberts.__version__}"', 'VERSION = "0.0.9"'))
        run = subprocess.run([sys.executable, "-c", "import roberts"], capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": os.path.dirname(folder)})
        self.assertEqual(run.returncode, 1)
        self.assertIn("ImportError: the package is of roberts 0.0.9, but the library ", run.stderr)
        self.assertIn(f" is {roberts.__version__}\n", run.stderr)


class Scenes(unittest.TestCase):
    def test_cube_by_hand(self):
        scene = roberts.read(CUBE)
        self.assertEqual((scene.body_count, scene.body_kind(0), scene.name), (1, "convex", "cube.off"))
        self.assertEqual(scene.vertices.shape, (8, 3))
        self.assertEqual(scene.faces.shape, (6, 4))
        segments = scene.hide("top").segments
        self.assertEqual(len(segments), 4)
        length = np.hypot(*(segments["p1"] - segments["p0"]).T)
        np.testing.assert_allclose(length, 2.0, rtol=1e-12)
        self.assertRaises(IndexError, scene.body_kind, 1)

    def test_rows_are_those_of_the_table(self):
        for path, view in (("models/table.off", "iso"), ("models/interpenetrating-cubes.off", "trimetric")):
            table = program("-f", "csv", "--view", view, "--hidden", "dashed", path).decode()
            rows = list(csv.DictReader(io.StringIO(table)))
            segments = roberts.read(path).hide(view, keep_hidden=True).segments
            self.assertEqual(len(rows), len(segments))
            self.assertGreater(len(rows), 10)
            for row, segment in zip(rows, segments):
                self.assertEqual(row["body"], str(segment["solid"]))
                self.assertEqual(row["state"], ("visible", "hidden", "clipped")[segment["state"]])
                self.assertEqual(row["by"], "" if segment["by"] == roberts.NONE else str(segment["by"]))
                self.assertEqual([float(row[k]) for k in ("t0", "t1", "x0", "y0", "x1", "y1")],
                                 [segment["t0"], segment["t1"], *segment["p0"], *segment["p1"]])

    def test_arrays_in(self):
        read = roberts.read("models/table.off")
        tracked = type("TrackedArray", (np.ndarray,), {})  # as trimesh has them
        triangles = roberts.read("models/platonic/icosahedron.off")
        mesh = roberts.Scene(triangles.vertices.view(tracked), triangles.faces.astype(np.int64).view(tracked))
        np.testing.assert_array_equal(mesh.hide().segments, triangles.hide().segments)
        for faces in (read.faces, [list(map(int, face)) for face in read.faces], iter(list(read.faces))):
            made = roberts.Scene(read.vertices, faces)
            np.testing.assert_array_equal(made.vertices, read.vertices)
            np.testing.assert_array_equal(made.corners, read.corners)
            np.testing.assert_array_equal(made.hide().segments, read.hide().segments)
        mixed = roberts.Scene([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]],
                              [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
        self.assertEqual([len(face) for face in mixed.faces], [4, 3, 3, 3, 3])
        self.assertEqual(mixed.body_kind(0), "convex")
        sparse = roberts.Scene([[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[], [0, 1, 2], []])
        self.assertEqual([len(face) for face in sparse.faces], [0, 3, 0])
        vertices, faces = triangles.vertices.copy(), triangles.faces.copy()
        placed = roberts.Scene(vertices, faces)  # their own numbers, and no copies of them
        self.assertEqual(placed.vertices.ctypes.data, vertices.ctypes.data)
        self.assertEqual(placed.corners.ctypes.data, faces.ctypes.data)
        shown = placed.vertices
        del vertices, placed
        gc.collect()
        np.testing.assert_array_equal(shown, triangles.vertices)

    def test_colors_in(self):
        cube, red = roberts.read(CUBE), np.zeros((6, 4), np.uint8)
        red[:] = 255, 0, 0, 128
        scene = roberts.Scene(cube.vertices, cube.faces, colors=red)
        color = scene.regions("iso").regions["color"]
        self.assertEqual(color["value"].tolist(), [[1.0, 0.0, 0.0, np.float32(128 / 255)]] * 3)
        self.assertEqual(color["count"].tolist(), [4] * 3)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            blue = roberts.Scene(cube.vertices, cube.faces, colors=[[0, 0, 1.0]] * 6).hide().svg(fill="model")
        self.assertEqual(blue.count('fill="#0000ff"'), 1)

    def test_table_as_text(self):
        drawing = roberts.read(CUBE).hide()
        self.assertEqual(drawing.csv(columns="ends").encode(), program(CUBE, "-f", "csv", "--columns", "+ends"))

    def test_bytes(self):
        with open(CUBE, "rb") as file:
            data = file.read()
        for what in (data, bytearray(data), memoryview(data)):
            scene = roberts.read(what, name="cube.off")
            self.assertEqual(scene.hide().svg(), roberts.read(CUBE).hide().svg())

    def test_errors(self):
        with self.assertRaises(roberts.Error) as caught:
            roberts.read(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n", name="odd.off")
        error = caught.exception
        self.assertEqual((error.status, error.file, error.line), ("BAD_INDEX", "odd.off", 6))
        self.assertTrue(str(error).startswith("odd.off:6: "), str(error))
        with self.assertRaisesRegex(ValueError, "^read: a str is a path, .{,100}$"):
            roberts.read("OFF\n3 1 0\n" + "0 0 0\n" * 1000)
        with self.assertRaises(roberts.Error) as caught:
            roberts.read("none.off")
        self.assertEqual((caught.exception.status, caught.exception.file), ("IO", "none.off"))
        with self.assertRaisesRegex(OSError, "^none.off: ") as caught:
            roberts.read("none.off")
        self.assertIsInstance(caught.exception, roberts.FileError)
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((type(again), again.file, str(again)), (roberts.FileError, "none.off", str(caught.exception)))
        triangle = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        for vertices, faces, status in ((triangle, [[0, 1, 3]], "BAD_INDEX"), ([[np.nan, 0, 0]], [[0]], "BAD_NUMBER")):
            with self.assertRaises(roberts.Error) as caught:
                roberts.Scene(vertices, faces)
            self.assertEqual(caught.exception.status, status)
        for vertices, faces in ((triangle, [[0, 1, -1]]), (triangle, [[0.5, 1, 2]]), ([[0, 0]], [[0]]),
                                (triangle, [3, 0, 1, 2]), (triangle, [[[0, 1, 2]]])):
            self.assertRaises(ValueError, roberts.Scene, vertices, faces)
        scene = roberts.Scene(triangle, [[0, 1, 2]])
        self.assertRaises(ValueError, scene.hide, "nowhere")
        self.assertRaises(ValueError, scene.hide, "")
        for method in (scene.hide, scene.regions):
            with self.assertRaisesRegex(TypeError, r"a view is the name of a preset, or .*view\(\).*, not tuple"):
                method((1, 2, 3))
        self.assertRaises(TypeError, scene.hide, odd=1)
        self.assertRaises(TypeError, scene.hide, slopes=True)
        self.assertRaises(TypeError, scene.regions, keep_hidden=True)
        for options in {"keep_hidden": "yes"}, {"unite": 2}:
            with self.assertRaisesRegex(TypeError, "^hide: .*: it is True or False, not "):
                scene.hide(**options)
        with self.assertRaisesRegex(TypeError, r"^hide: azimuth belongs to the view: hide\(roberts.view\(azimuth="):
            scene.hide(azimuth=3)
        self.assertRaises(ValueError, scene.hide().save, "a.odd")
        self.assertRaises(ValueError, scene.hide().svg, fill="odd")
        for option, meant in ({"odd": 1}, "background"), ({"label": "vertices"}, "labels"), ({"colour": 1}, "columns"):
            with self.assertRaisesRegex(TypeError, rf"^there is no '{[*option][0]}'[;.] .*\b{meant}\b"):
                scene.hide().svg(**option)
        with self.assertRaisesRegex(TypeError, "no 'crease'; did you mean crease_auto or crease_degrees[?] There are "):
            scene.hide(crease=30)
        with self.assertRaisesRegex(TypeError, "did you mean unite[?] There are all_edges, .*crease_degrees, "):
            scene.hide(union=True)
        with self.assertRaisesRegex(TypeError, "^hatch: there is no 'spacing'; did you mean spacing_mm[?] "):
            scene.hide().svg(hatch={"spacing": 1})
        with self.assertRaises(roberts.Error) as caught:
            scene.hide(roberts.view(eye=(1, 2, 3), look_at=(1, 2, 3)))
        self.assertEqual(caught.exception.status, "BAD_VIEW")
        self.assertRaises(roberts.Error, roberts.Scene, triangle, [[0, 1, 2]], solids=True)
        for odd in ({"direction": (1, 2)}, {"eye": (1, 2, 3, 4)}, {"eye": (1, 2, 3), "direction": (1, 2, 3)},
                    {"eye": (1, 2, 3), "elevation": 5}, {"fov": 60}, {"near": 1}, {"look_at": (0, 0, 0)},
                    {"preset": "top", "azimuth": 5}):
            self.assertRaises(ValueError, roberts.view, **odd)
        eye = {"eye": (1, 2, 3)}
        for name, value, others in (("direction", (0, 0, 0), {}), ("direction", (np.inf, 0, 0), {}),
                                    ("up", (0, 0, 0), {}), ("up", (0, np.nan, 1), {}), ("roll", np.nan, {}),
                                    ("azimuth", np.inf, {}), ("eye", (np.nan, 0, 0), {}), ("fov", -5, eye),
                                    ("fov", 180, eye), ("near", -1, eye), ("near", np.inf, eye),
                                    ("look_at", (np.inf, 0, 0), eye), ("section", (np.nan, 0, 0), {})):
            with self.assertRaisesRegex(ValueError, f"^view: {name}: "):
                roberts.view(**{name: value}, **others)
        for name, others in ("azimuth", {}), ("elevation", {}), ("roll", {}), ("fov", eye), ("near", eye):
            with self.assertRaisesRegex(TypeError, f"^view: {name}: "):
                roberts.view(**{name: "x"}, **others)
        masked = np.ma.array(np.eye(3), mask=np.eye(3))
        self.assertRaisesRegex(ValueError, "^Scene: vertices: .* masked", roberts.Scene, masked, [[0, 1, 2]])
        self.assertRaisesRegex(ValueError, "^Scene: faces: .* masked", roberts.Scene, triangle,
                               np.ma.array([[0, 1, 2, 9]], mask=[[0, 0, 0, 1]]))
        self.assertRaisesRegex(ValueError, "^project: points: .* masked", scene.project, masked)
        self.assertEqual(roberts.Scene(np.ma.array(triangle), [[0, 1, 2]]).body_count, 1)  # nothing is masked
        self.assertEqual(repr(scene), "<roberts.Scene '': 1 body, 3 vertices, 1 face>")
        self.assertIn(": 25 bodies, ", repr(roberts.read("models/tower.off")))
        for name in ("direction", "eye", "look_at", "up"):
            with self.assertRaisesRegex(ValueError, f"^view: {name}: a vector has three numbers, not 2$"):
                roberts.view(**{"eye": (1, 2, 3)} if name == "look_at" else {}, **{name: (1, 2)})
        for name, value in (("light", (1, 2)), ("fill", (1, 2)), ("background", (0, 0, 256)), ("page", (1, 2, 3, 4)),
                            ("pens", {"outline": {"color": (0.5, -1, 0)}}), ("id_prefix", "1"), ("id_prefix", ""),
                            ("background", "red")):
            with self.assertRaisesRegex(ValueError, f"^{name}: "):
                scene.hide().svg(**{name: value})
        for name, value in (("page", "a4"), ("scale", "1:2"), ("dpi", "fine"), ("light", "top"),
                            ("pens", {"outline": {"width": "1 mm"}}), ("hatch", {"spacing_mm": "1"})):
            with self.assertRaisesRegex(TypeError, f"^{name}: .*number"):
                scene.hide().svg(**{name: value})
        for name, value in (("hatch", "off"), ("hatch", [1]), ("crop", "yes"), ("hatch", {"on": "no"}), ("title", 3),
                            ("pens", {"outline": {"widht": 1}})):
            with self.assertRaisesRegex(TypeError, f"^{name}[:,] .*(True or False|str|did you mean width[?])"):
                scene.hide().svg(**{name: value})
        with self.assertRaisesRegex(ValueError, "^fill: 'shades' is unknown; it can be none, .*, or .red, green, b"):
            scene.hide().svg(fill="shades")
        colors = np.zeros((1, 3))
        for odd in (colors[0], colors[:, :2], np.zeros((2, 3)), colors + 2, colors - 1, colors * np.nan, [["a"] * 3]):
            self.assertRaises(ValueError, roberts.Scene, triangle, [[0, 1, 2]], colors=odd)
        self.assertIn('id="_a.1-', scene.hide().svg(id_prefix="_a.1-"))
        for odd in ({"fill": (256, 0, 0)}, {"background": (0, 0)}, {"pens": {"outline": {"color": (0, -1, 0)}}},
                    {"pens": {"outline": {"number": 256}}}, {"light": (1, 2)}):
            self.assertRaises(ValueError, scene.hide().svg, **odd)

    def test_warnings(self):
        with self.assertWarnsRegex(roberts.RobertsWarning, "colour"):
            roberts.read(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 x y\n", name="odd.off")

    def test_options_without_effect(self):
        drawing = roberts.read(CUBE).hide()
        for options in ({"fill": "model"}, {"shaded": True}, {"light": (1, 1, 1)},
                        {"light": (1, 1, 1), "fill": "body"}):
            with self.assertWarnsRegex(roberts.RobertsWarning, f"^{next(iter(options))} has no effect: "):
                drawing.svg(**options)
        path = os.path.join(HERE, "misnamed.svg")
        for name, value, ending in (("columns", "name", "svg"), ("fill", "shade", "csv"), ("page", (50, 50), "json"),
                                    ("dpi", 300, "pdf"), ("group", "element", "png"), ("id_prefix", "a", "dxf")):
            with self.assertWarnsRegex(roberts.RobertsWarning, f"^{name} has no effect: "):
                drawing.save(os.path.join(HERE, "idle." + ending), **{name: value})
        with self.assertWarnsRegex(roberts.RobertsWarning, "misnamed.svg: .* another format, but it is pdf"):
            drawing.save(path, format="pdf")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for options in ({"fill": "shade"}, {"hatch": True}, {"fill": "body", "shaded": True}):
                drawing.svg(light=(1, 1, 1), **options)
            drawing.save(path, format="svg", hidden="none", group="body", id_prefix="a")
            drawing.csv(hidden="none", columns="name")
            drawing.save(os.path.join(HERE, "used.png"), dpi=50)
            drawing.save(os.path.join(HERE, "no-ending"), format="pdf")


class Memory(unittest.TestCase):
    def test_arrays_are_views(self):
        scene = roberts.read("models/table.off")
        drawing = scene.hide()
        self.assertEqual(scene.vertices.ctypes.data, scene._mesh.vertex)
        self.assertEqual(drawing.segments.ctypes.data, drawing._drawing.segment)
        self.assertEqual(drawing.segments["p0"].base is None, False)
        self.assertRaises(ValueError, scene.vertices.__setitem__, 0, 1.0)
        self.assertRaises(ValueError, drawing.segments.__setitem__, "t0", 1.0)

    def test_arrays_keep_their_memory(self):
        vertices = roberts.read("models/table.off").vertices
        points = roberts.read("models/table.off").hide().segments["p0"]
        before = vertices.copy(), points.copy()
        gc.collect()
        for _ in range(50):
            roberts.read("models/tower.off").hide()
        np.testing.assert_array_equal(vertices, before[0])
        np.testing.assert_array_equal(points, before[1])

    def test_memory_comes_back(self):
        freed = []
        free = _library.lib.roberts_drawing_free
        scene = roberts.read(CUBE)
        drawing = scene.hide()
        roberts.weakref.finalize(drawing, freed.append, True)
        points = drawing.segments["p0"]
        del drawing
        gc.collect()
        self.assertEqual(freed, [])
        del points
        gc.collect()
        self.assertEqual(freed, [True])
        self.assertIsNotNone(free)


class Pages(unittest.TestCase):
    def same(self, drawing, *arguments, **options):
        """The description of the program's drawing is its command line; all else must be the same."""
        expected = program(*arguments, "-f", "svg").decode()
        about = html.unescape(re.search("<desc>(.*?)</desc>", expected).group(1))
        self.assertEqual(drawing.svg(description=about, **options), expected)

    def test_svg_of_a_section(self):
        drawing = roberts.read(CUBE).hide(roberts.view("front", section=(0, -0.5, 0)))
        self.same(drawing, CUBE, "--view", "front", "--section", "0,-.5,0", "--hatch", "faces=sections",
                  hatch={"sections": True})
        drawing = roberts.read(CUBE).hide(roberts.view("iso", section=(0.25, 0, 0, 1, 0, 0)))
        self.same(drawing, CUBE, "--section", "0.25,0,0,1,0,0")
        with self.assertRaisesRegex(ValueError, "view: section: three numbers, or six, not 4"):
            roberts.view(section=(0, 0, 0, 1))
        with self.assertRaisesRegex(ValueError, "0, 0, 0 is no direction"):
            roberts.view(section=(0, 0, 0, 0, 0, 0))

    def test_svg_is_that_of_the_program(self):
        for path in ("models/table.off", "models/temple.off", "models/interpenetrating-cubes.off"):
            scene = roberts.read(path)
            self.same(scene.hide(), path)
            self.same(scene.hide("top", keep_hidden=True), path, "--view", "top", "--hidden", "dashed", "--fill",
                      "shade:body", fill="body", shaded=True)
            self.same(scene.hide(unite=True), path, "--style", "outline:width=0.7,color=#ff0000", "--page", "100x80",
                      "--margin", "5", "--group", "element", "--union", page=(100, 80, 5), group="element",
                      pens={"outline": {"width": 0.7, "color": (255, 0, 0)}})

    def test_turntable(self):
        """A wedge that is far from symmetrical: its pictures have one scale, and its middle one place."""
        wedge = b"OFF\n6 5 0\n0 0 0\n4 0 0\n0 1 0\n4 1 0\n0 0 2\n0 1 2\n" \
                b"4 0 2 3 1\n3 0 1 4\n3 2 5 3\n4 0 4 5 2\n4 1 3 5 4\n"
        path = os.path.join(HERE, "wedge.off")
        with open(path, "wb") as file:
            file.write(wedge)
        for where, arguments in ((roberts.view(azimuth=10, elevation=20), ("--azimuth", "10", "--elevation", "20")),
                                 (roberts.view(eye=(9, -7, 5)), ("--eye", "9,-7,5"))):
            program(path, "--turntable", "5", *arguments, "-o", os.path.join(HERE, "turned-%d.svg"))
            drawings = list(roberts.read(path).turntable(5, where))
            self.assertEqual(len(drawings), 5)
            for number, drawing in enumerate(drawings):
                with open(os.path.join(HERE, f"turned-{number}.svg"), encoding="utf-8") as file:
                    expected = file.read()
                about = html.unescape(re.search("<desc>(.*?)</desc>", expected).group(1))
                self.assertEqual(drawing.svg(description=about), expected)
        with self.assertRaisesRegex(ValueError, "^turntable: 0 pictures"):
            roberts.read(CUBE).turntable(0)

    def test_labels(self):
        drawing = roberts.read(CUBE).hide()
        self.same(drawing, CUBE, "--label", "vertices", labels="vertices")
        self.same(drawing, CUBE, "--label", "vertices,faces", labels="vertices,faces")
        house = roberts.read("tests/fuzz/seeds/house.obj").hide()
        self.same(house, "tests/fuzz/seeds/house.obj", "--label", "names", labels="names")
        self.same(drawing, CUBE, "--label", "vertices,faces", labels=["vertices", "faces"])

    def test_names(self):
        scene = roberts.read(CUBE)
        drawing = scene.hide()
        path = os.path.join(HERE, "names.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write("vertex,0,A\nvertex,1,Ω\nedge,4-5,a\nface,3,top\nbody,0,box\n")
        names = {"edges": {(5, 4): "a"}, "vertices": {1: "Ω", 0: "A"}, "faces": {3: "top"}, "bodies": {0: "box"}}
        self.same(drawing, CUBE, "--labels", path, names=names)
        self.same(drawing, CUBE, "--labels", path, "--label-size", "5", "--text", "native", names=names, label_size=5,
                  text="native")
        self.assertNotIn('class="text"', drawing.svg(names={"vertices": {0: ""}}))
        for names, error, message in (
                ({"points": {0: "A"}}, TypeError, "names: there is no 'points'"),
                ({"vertices": ["A"]}, TypeError, "names: a dict of dicts"),
                ({"edges": {(0, 6): "a"}}, ValueError, r"names: edges: there is no \(0, 6\)"),
                ({"vertices": {8: "A"}}, ValueError, "names: vertices: there is no 8"),
                ({"vertices": {(0, 1): "A"}}, TypeError, "names: vertices: .* is no number"),
                ({"vertices": {True: "A"}}, TypeError, "names: vertices: True is no number"),
                ({"edges": {(0, 1): "a", (1, 0): "b"}}, ValueError, "names: edges: .1, 0. has a name already"),
                ({"edges": {0: "a"}}, TypeError, "names: edges: 0 is no pair of vertices"),
                ({"edges": {(0, 1, 2): "a"}}, TypeError, "names: edges: .* is no pair of vertices"),
                ({"faces": {0: 1}}, TypeError, "names: faces: 0: a name is a str, not 1")):
            with self.assertRaisesRegex(error, message):
                drawing.svg(names=names)

    def test_shade(self):
        for path in ("models/table.off", "models/locomotive.off"):
            scene = roberts.read(path)
            for fill in ("none", "shade", "shade:white", "shade:body"):
                self.same(scene.hide(), path, "--fill", fill, fill=fill)

    def test_hidden_lines(self):
        path = "models/table.off"
        scene = roberts.read(path)
        self.same(scene.hide(keep_hidden=True), path, "--hidden", "solid", "--style", "hidden:width=0.1",
                  hidden="solid", pens={"hidden": {"width": 0.1}})
        self.same(scene.hide(), path, "--frame", "--style", "frame:color=red", pens={"frame": {"color": (255, 0, 0)}})
        self.same(scene.hide(), path, "--style", "crease:off,color=red",
                  pens={"crease": {"off": True, "color": (255, 0, 0)}})
        with self.assertRaisesRegex(ValueError, "keep_hidden"):
            scene.hide().svg(hidden="dashed")
        with self.assertRaisesRegex(ValueError, "'back' is unknown; it can be outline, border, crease, intersection, "
                                                "wire, hidden, frame, symbol, hatch, text, hidden_text$"):
            scene.hide().svg(pens={"back": {}})

    def test_angles_and_perspective(self):
        path = "models/table.off"
        scene = roberts.read(path)
        self.same(scene.hide(roberts.view(azimuth=20, elevation=30)), path, "--azimuth", "20", "--elevation", "30")
        self.same(scene.hide(roberts.view(elevation=30)), path, "--elevation", "30")
        self.same(scene.hide(roberts.view(eye=(9, -20, 8))), path, "--eye", "9,-20,8")
        self.assertIn("eye", repr(roberts.view(eye=(9, -20, 8))))

    def test_project(self):
        scene = roberts.read("models/table.off")
        for where in (None, roberts.view(eye=(9, -20, 8))):
            places, segments = scene.project(scene.vertices, where), scene.hide(where).segments
            whole = segments[segments["t0"] == 0]
            self.assertGreater(len(whole), 50)
            np.testing.assert_allclose(places[whole["v0"], :2], whole["p0"], atol=1e-12)
            np.testing.assert_allclose(places[whole["v0"], 2], whole["z0"], atol=1e-12)
        self.assertTrue(np.isnan(scene.project([[9, -21, 8]], where)).all())
        self.assertRaises(ValueError, scene.project, [1, 2, 3])
        self.assertRaises(roberts.Error, scene.project, [[1, 2, 3]],
                          roberts.view(eye=(1, 2, 3), look_at=(1, 2, 3)))

    def test_pages(self):
        path = "models/table.off"
        self.same(roberts.read(path).hide(), path, "--crop", "--page", "60x70", "--margin", "2", page=(60, 70, 2),
                  crop=True)
        self.assertRaisesRegex(TypeError, "of mm", roberts.read(path).hide().svg, page="a4")

    def test_rounded(self):
        path = "models/star/great-icosahedron.off"
        self.same(roberts.read(path, rounded=True).hide(), path, "--rounded")

    def test_sheets(self):
        scene = roberts.read("models/table.off")
        self.same(scene.sheet(), "models/table.off", "--sheet", "first")
        sheet = scene.sheet("third", keep_hidden=True)
        self.same(sheet, "models/table.off", "--sheet", "third", "--hidden", "dashed", "--fill", "body", fill="body")
        self.assertEqual(list(sheet.views), ["front", "top", "side", "iso"])
        self.assertIn("<svg", sheet._repr_svg_())
        sheet.save(os.path.join(HERE, "sheet.csv"))
        with open(os.path.join(HERE, "sheet.csv"), "rb") as file:
            self.assertEqual(file.read(), program("models/table.off", "--sheet", "third", "--hidden", "dashed", "-f",
                                                  "csv"))
        self.assertRaises(ValueError, scene.sheet, "second")

    def test_columns(self):
        drawing = roberts.read("models/table.off").hide(keep_hidden=True, levels=True)
        path = os.path.join(HERE, "columns.csv")
        drawing.save(path, columns=("level", "ends", "depth", "name", "by"))
        with open(path, "rb") as file:
            self.assertEqual(file.read(), program("models/table.off", "--hidden", "dashed", "-f", "csv", "--columns",
                                                  "+level,+ends,+depth,+name,+by"))
        drawing.save(path, columns="depth")
        with open(path, "rb") as file:
            self.assertEqual(file.read(), program("models/table.off", "--hidden", "dashed", "-f", "csv", "--columns",
                                                  "+depth"))
        for one in roberts.read(CUBE).hide(keep_hidden=True), roberts.read(CUBE).sheet(keep_hidden=True):
            with self.assertRaisesRegex(ValueError, r"^columns: .* hide\(..., levels=True\) computes them$"):
                one.csv(columns="level")
            self.assertRaises(ValueError, one.save, path, columns=("ends", "level"))
        self.assertRaises(ValueError, drawing.save, path, columns=("odd",))
        self.assertRaises(ValueError, drawing.save, path, columns=("ends", "ends"))

    def test_save(self):
        drawing = roberts.read(CUBE).hide()
        for name in ("a.svg", "a.pdf", "a.png", "a.dxf", "a.csv"):
            drawing.save(os.path.join(HERE, name))
            self.assertGreater(os.path.getsize(os.path.join(HERE, name)), 100)
        drawing.save(os.path.join(HERE, "a.odd"), format="svg")
        with open(os.path.join(HERE, "a.odd"), "rb") as file:
            self.assertEqual(file.read().decode(), drawing.svg())
        with self.assertRaises(roberts.Error) as caught:
            drawing.save(os.path.join(HERE, "none", "a.svg"))
        self.assertEqual(caught.exception.status, "IO")

    def test_names_of_any_bytes(self):
        with open(CUBE, "rb") as file:
            scene = roberts.read(file.read(), name="cub\udcff.off")
        self.assertIn("<title>cub?.off</title>", scene.hide().svg())

    def test_notebook(self):
        drawing = roberts.read("models/table.off").hide()
        svg = drawing._repr_svg_()
        self.assertIn("<svg", svg)
        self.assertIn("</svg>", svg)
        self.assertIn("<svg", drawing._scene._repr_svg_())


class Examples(unittest.TestCase):
    def test_blocks_of_the_pages(self):
        """The blocks of README and recipes that use the package draw what they say."""
        os.symlink(os.path.abspath("models"), os.path.join(HERE, "models"))
        for page, output in (("README.md", "table.svg"), ("models/recipes.md", "octahedron.svg")):
            with open(page, encoding="utf-8") as file:
                blocks = re.findall(r"^```python[^\n]*\n(.*?)^```", file.read(), re.M | re.S)
            (block,) = (block for block in blocks if "import roberts" in block)
            paths = os.environ | {"PYTHONPATH": os.path.abspath("src/python")}
            subprocess.run([sys.executable, "-c", block], check=True, capture_output=True, cwd=HERE, env=paths)
            self.assertGreater(os.path.getsize(os.path.join(HERE, output)), 500)


class Seen(unittest.TestCase):
    def test_regions_of_a_cube(self):
        regions = roberts.read(CUBE).regions("top")
        self.assertEqual(len(regions), 1)
        self.assertAlmostEqual(float(regions.regions["area"][0]), 4.0, 12)
        (ring,) = regions.rings(0)
        x, y = ring.T
        self.assertAlmostEqual(0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))), 4.0, 12)
        np.testing.assert_allclose(regions.regions["normal"][0], (0, 0, 1), atol=1e-12)

    def test_sections(self):
        scene, front = roberts.read(CUBE), roberts.view("front", section=(0, -0.5, 0))
        regions = scene.regions(front).regions
        self.assertEqual((regions["section"].tolist(), regions["face"].tolist()), ([True], [roberts.NONE]))
        self.assertAlmostEqual(float(regions["area"][0]), 4.0, 12)
        self.assertTrue(np.isnan(scene.project([[0, -0.6, 0]], front)).all())
        self.assertFalse(scene.regions("front").regions["section"].any())

    def test_crossings(self):
        crossings = roberts.read("models/interpenetrating-cubes.off").hide().crossings
        self.assertGreater(len(crossings), 0)
        self.assertTrue(np.all(crossings["face"][:, 0] < crossings["face"][:, 1]))


if __name__ == "__main__":
    warnings.simplefilter("error", ResourceWarning)
    unittest.main(argv=sys.argv[:1])
