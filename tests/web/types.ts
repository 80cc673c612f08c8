/* types.ts - the types of the npm package, as a user's compiler sees them: tsc --noEmit. Nothing runs this. */
import { draw, save, toArguments, RobertsError, type Format, type Options } from "roberts";

const options: Options = {
  name: "a.obj",
  files: { "a.mtl": new Uint8Array(0) },
  view: "iso",
  eye: [9, 8, 7],
  hidden: "dashed",
  crease: 30,
  allEdges: true,
  style: ["hidden:off", "wire:off"],
  labelHeight: 2,
  quiet: undefined,
};

export async function all(bytes: Uint8Array): Promise<string> {
  const { svg, warnings } = await draw(bytes, options);
  const format: Format = "pdf";
  const saved: Uint8Array = (await save(bytes, format)).bytes;
  const regions: Uint8Array | undefined = (await draw(bytes, { regions: "a.json" })).files["a.json"];
  const list: string[] = [...warnings, ...toArguments(options)];
  try {
    await draw(bytes);
  } catch (error) {
    if (error instanceof RobertsError) list.push(`${error.status.toFixed()} ${error.message}`);
  }
  return svg + saved.length + (regions?.length ?? 0) + list.join();
}

// what is refused: the line below each of these is an error
// @ts-expect-error: no such format
void save(new Uint8Array(0), "png");
// @ts-expect-error: a text is not the bytes of a file
void draw("OFF");
// @ts-expect-error: no such way to draw hidden lines
void draw(new Uint8Array(0), { hidden: "dotted" });
// @ts-expect-error: a point has three numbers
void draw(new Uint8Array(0), { eye: [1, 2] });
// @ts-expect-error: svg is a text
draw(new Uint8Array(0)).then(({ svg }) => svg.length.length);
