/** Images that the layers use, drawn here: stripes of several changes, arrows of lane types. */
import type { Map as MapLibreMap } from "maplibre-gl";
import { CHANGE_COLOURS, type ChangeColour } from "./palette";

const COMBINATIONS: readonly (readonly ChangeColour[])[] = [
  ["geometry", "marking"],
  ["geometry", "type"],
  ["marking", "type"],
  ["geometry", "marking", "type"],
];
const STRIPE_PIXELS = 12;

interface Picture {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray;
}

/** Diagonal stripes that tile seamlessly, one after the other in the order of the changes. */
export function stripes(names: readonly ChangeColour[]): Picture {
  const size = STRIPE_PIXELS * names.length;
  const data = new Uint8ClampedArray(size * size * 4);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const name = names[Math.floor(((x + y) % size) / STRIPE_PIXELS)] ?? "geometry";
      const colour = Number.parseInt(CHANGE_COLOURS[name].slice(1), 16);
      data.set([colour >> 16, (colour >> 8) & 255, colour & 255, 255], (y * size + x) * 4);
    }
  }
  return { width: size, height: size, data };
}

type Draw = (context: CanvasRenderingContext2D) => void;

const chevron: Draw = (context) => {
  context.moveTo(10, 21);
  context.lineTo(20, 11);
  context.lineTo(30, 21);
};

const ARROWS: Readonly<Record<string, Draw>> = {
  VEHICLE: chevron,
  BIKE: (context) => {
    chevron(context);
    for (const x of [13, 27]) {
      context.moveTo(x + 4.5, 32);
      context.arc(x, 32, 4.5, 0, 2 * Math.PI);
    }
    context.moveTo(13, 32);
    context.lineTo(18, 25);
    context.lineTo(24, 25);
    context.lineTo(27, 32);
  },
  BUS: (context) => {
    chevron(context);
    context.roundRect(14, 25, 12, 13, 2.5);
    context.moveTo(14, 31);
    context.lineTo(26, 31);
  },
};

function arrow(draw: Draw, colour: string): ImageData | null {
  const canvas = document.createElement("canvas");
  canvas.width = 40;
  canvas.height = 44;
  const context = canvas.getContext("2d");
  if (context === null) return null;
  context.strokeStyle = colour;
  context.lineWidth = 3;
  context.lineCap = "round";
  context.lineJoin = "round";
  context.beginPath();
  draw(context);
  context.stroke();
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** Adds all images, or redraws the arrows in another colour. */
export function addImages(map: MapLibreMap, arrowColour: string): void {
  for (const names of COMBINATIONS) {
    const id = `stripes-${names.join("+")}`;
    if (!map.hasImage(id)) map.addImage(id, stripes(names), { pixelRatio: 2 });
  }
  for (const [type, draw] of Object.entries(ARROWS)) {
    const image = arrow(draw, arrowColour);
    if (image === null) continue;
    const id = `arrow-${type}`;
    if (map.hasImage(id)) map.updateImage(id, image);
    else map.addImage(id, image, { pixelRatio: 2 });
  }
}
