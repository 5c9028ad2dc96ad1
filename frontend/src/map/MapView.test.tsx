import { render, screen } from "@testing-library/react";
import { expect, test, vi } from "vitest";
import { createEditor } from "../editor";
import { idBlocks, workspaceOf } from "../editor/testRoad";
import { niceLength } from "./Furniture";
import { opacitiesOf } from "./layers";
import { MapView } from "./MapView";

test("without WebGL 2 the reason and the way out are told", () => {
  const told = vi.fn();
  render(
    <MapView
      editor={createEditor(workspaceOf(), idBlocks())}
      frame={{ city: "PIT", epsg: 32617, origin_east: 583710.007, origin_north: 4477260 }}
      bounds={[0, 0, 100, 100]}
      drivableAreas={[]}
      direction="prior_to_current"
      view="difference"
      onUnavailable={told}
    />,
  );
  expect(screen.getByRole("alert").textContent).toContain("hardware acceleration");
  expect(told).toHaveBeenCalledOnce();
});

test("each view shows its own versions of changed elements", () => {
  const visible = (shown: "base" | "edited" | "difference") =>
    opacitiesOf({ shown, overImage: false, arrows: true })
      .filter(([layer, , opacity]) => layer.startsWith("surface-") && opacity > 0)
      .map(([layer]) => layer.slice("surface-".length));
  expect(visible("base")).toEqual(["both", "base", "gone"]);
  expect(visible("edited")).toEqual(["both", "edited"]);
  expect(visible("difference")).toEqual(["both", "edited", "gone"]);
});

test("change colours belong to the difference alone", () => {
  const tint = (shown: "edited" | "difference") =>
    opacitiesOf({ shown, overImage: false, arrows: true }).find(([layer]) => layer === "change")?.[2];
  expect(tint("edited")).toBe(0);
  expect(tint("difference")).toBeGreaterThan(0);
});

test("the scale bar has a round length", () => {
  expect([87, 49.9, 0.31, 2].map(niceLength)).toEqual([50, 20, 0.2, 2]);
});
