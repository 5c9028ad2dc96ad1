import { expect, test } from "vitest";
import { projectionOf } from "./projection";

const WASHINGTON = { city: "WDC", epsg: 32618, origin_east: 323460.0, origin_north: 4306469.987 };

test("city metres come out where the published reference points are", () => {
  const [longitude, latitude] = projectionOf(WASHINGTON).toLngLat({ x: 1716.85, y: 4470.38 });
  expect(longitude).toBeCloseTo(-77.01686032, 7);
  expect(latitude).toBeCloseTo(38.92998015, 7);
});

test("the way there and back keeps a tenth of a micrometre", () => {
  const projection = projectionOf(WASHINGTON);
  const there = projection.toLngLat({ x: 2139.7, y: 4606.14 });
  const back = projection.toCity(...there);
  expect(Math.hypot(back.x - 2139.7, back.y - 4606.14)).toBeLessThan(1e-7);
});
