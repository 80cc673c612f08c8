/** The formats that are written. PS, EPS and PNG need the program. */
export type Format = "svg" | "pdf" | "tikz" | "dxf" | "hpgl" | "csv" | "json";

type Value = string | number | boolean;

/**
 * The options of the program by their long names: `{ hidden: "dashed", crease: 30, allEdges: true }` is
 * `--hidden=dashed --crease=30 --all-edges`. A list is one value with commas: `{ label: ["vertices", "faces"] }` is
 * `--label=vertices,faces`. A list of `style`, `field`, `pick` or `roomFor` gives the option several times. `true`
 * gives it without a value, but `hatch: true` is `--hatch=on`, and `hidden: true` is `--hidden=dashed`. `false` and
 * `undefined` do not give it. `roberts --help` lists the options.
 */
export interface Options {
  /** What the drawing and the messages call the model (default: "model"). */
  name?: string;
  /** Further files that the model or an option names, such as materials of OBJ. */
  files?: Record<string, Uint8Array>;
  view?:
    "iso" | "dimetric" | "trimetric" | "front" | "back" | "right" | "left" | "top" | "bottom" | "cavalier" | "cabinet";
  azimuth?: number;
  elevation?: number;
  /** Perspective from this point: `[x, y, z]` or "x,y,z". */
  eye?: string | [number, number, number];
  dir?: string | [number, number, number];
  hidden?: boolean | "none" | "dashed" | "solid";
  /** Degrees. */
  crease?: number;
  allEdges?: boolean;
  union?: boolean;
  hull?: boolean;
  rounded?: boolean;
  page?: string;
  landscape?: boolean;
  crop?: boolean;
  /** mm */
  margin?: number;
  scale?: string | number;
  fill?: string;
  style?: string | string[];
  [option: string]: Value | Value[] | Record<string, Uint8Array> | undefined;
}

/** What a drawing comes with. */
export interface Beside {
  /** The lines that the program prints besides: warnings, notes, and what `stats`, `verify` and `pick` tell. */
  warnings: string[];
  /** Files that an option has written, such as `regions: "regions.json"`. With `turntable: 4, output: "turn-%d.svg"`
   * all drawings are here, and none is beside them. */
  files: Record<string, Uint8Array>;
}

/** The drawing of a model (OFF, STL, OBJ or PLY; its content decides) as SVG, the same bytes as the program's. */
export function draw(bytes: Uint8Array, options?: Options): Promise<{ svg: string } & Beside>;

/** The same in any format. */
export function save(bytes: Uint8Array, format: Format, options?: Options): Promise<{ bytes: Uint8Array } & Beside>;

/** The arguments of the command line that options stand for, without files. */
export function toArguments(options?: Options): string[];

/** What was wrong, in the words of the program. */
export class RobertsError extends Error {
  /** The program's exit status: 1 for the model, 2 for the options. */
  status: number;
}
