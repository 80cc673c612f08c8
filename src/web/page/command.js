/* command.js - from the controls to the arguments of the program, and to a command for a shell. */

/* Views with a name, and about where they are seen from: azimuth and elevation, from which the model is turned on. */
export const presets = {
  iso: [45, Math.atan(Math.SQRT1_2) * (180 / Math.PI)],
  dimetric: [20.7, 19.5],
  trimetric: [26.6, 30.8],
  front: [0, 0],
  right: [90, 0],
  back: [180, 0],
  left: [270, 0],
  top: [0, 90],
  bottom: [0, -90],
  cavalier: [0, 0],
  cabinet: [0, 0],
};

/* Views that have no perspective. */
export const oblique = ["cavalier", "cabinet"];

export const pens = { outline: 0.5, crease: 0.35, border: 0.5, intersection: 0.35, wire: 0.35, hidden: 0.25 };

const black = "#000000";
const endings = { svg: "svg", pdf: "pdf", dxf: "dxf", tikz: "tikz", hpgl: "hpgl" };

function radians(degrees) {
  return (degrees * Math.PI) / 180;
}

/* Few digits, so that the command can be read: `digits` behind the point, without zeros at the end. */
function rounded(value, digits) {
  return String(Number(value.toFixed(digits)) + 0);
}

/* The direction toward the viewer. */
function direction(azimuth, elevation) {
  const a = radians(azimuth),
    e = radians(elevation);
  return [Math.sin(a) * Math.cos(e), -Math.cos(a) * Math.cos(e), Math.sin(e)];
}

function viewArguments(state, scene) {
  const { view, azimuth, elevation } = state,
    distance = Number(state.perspective);
  if (distance > 0 && scene) {
    const digits = Math.max(0, 3 - Math.floor(Math.log10(scene.diameter)));
    const eye = direction(azimuth, elevation).map((part, i) =>
      rounded(scene.centre[i] + part * distance * scene.diameter, Math.min(digits, 15)),
    );
    return [`--eye=${eye.join(",")}`];
  }
  if (view) return view === "iso" ? [] : [`--view=${view}`];
  return [`--azimuth=${rounded(azimuth, 1)}`, `--elevation=${rounded(elevation, 1)}`];
}

/* What decides how the scene is built: when it changes, the file is read again. */
export function sceneArguments(state) {
  const args = [];
  if (state.hull) args.push("--hull");
  if (state.rounded) args.push("--rounded");
  if (state.up === "y") args.push("--y-up");
  return args;
}

/* What decides which lines there are, and where. */
export function lineArguments(state, scene, hidden = state.hidden) {
  const args = viewArguments(state, scene);
  if (hidden !== "none") args.push(`--hidden=${hidden}`);
  if (state.crease !== "" && !state.allEdges) args.push(`--crease=${state.crease}`);
  if (state.allEdges) args.push("--all-edges");
  if (state.union) args.push("--union");
  return args;
}

function pageArguments(state) {
  const args = [];
  if (state.fill !== "none") args.push(`--fill=${state.fill}`);
  if (state.hatch) args.push("--hatch=on");
  if (state.page !== "a4") args.push(`--page=${state.page}`);
  if (state.landscape) args.push("--landscape");
  if (state.scale !== "") args.push(`--scale=${state.scale}`);
  if (state.scale !== "" && state.unit !== "mm") args.push(`--unit=${state.unit}`);
  if (state.margin !== "") args.push(`--margin=${state.margin}`);
  if (state.frame) args.push("--frame");
  return args;
}

function penArguments(state) {
  return Object.entries(pens).flatMap(([name, width]) => {
    const pen = state.pens[name],
      parts = [];
    if (!pen.on) return name === "hidden" && state.hidden === "none" ? [] : [`--style=${name}:off`];
    if (Number(pen.width) !== width) parts.push(`width=${pen.width}`);
    if (pen.color !== black) parts.push(`color=${pen.color}`);
    return parts.length ? [`--style=${name}:${parts.join(",")}`] : [];
  });
}

/* A name that begins with a dash would be taken for an option. */
export function asFile(name) {
  return name.startsWith("-") ? `./${name}` : name;
}

export function outputName(name, format) {
  return asFile(`${name.replace(/\.[^.]*$/, "") || "drawing"}.${endings[format]}`);
}

/* All arguments of the program for a drawing in this format. */
export function programArguments(state, scene, format) {
  return [
    ...sceneArguments(state),
    ...lineArguments(state, scene),
    ...pageArguments(state),
    ...penArguments(state),
    asFile(state.name),
    "-o",
    outputName(state.name, format),
  ];
}

/* A word as a POSIX shell reads it. */
export function quoted(word) {
  return /^[A-Za-z0-9_.,:=/@%+-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;
}
