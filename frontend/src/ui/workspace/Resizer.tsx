import { useLocalStorage } from "@mantine/hooks";
import { type KeyboardEvent, type PointerEvent, useLayoutEffect, useRef } from "react";
import classes from "./workspace.module.css";

interface ResizerProperties {
  /** Its panel's width is the CSS variable `--<name>-width` of the workspace. */
  name: string;
  label: string;
  initial: number;
  min: number;
  max: number;
  /** On which side of the handle the panel lies. */
  side: "left" | "right";
}

/** A handle between a panel and the map: dragged, or moved with the arrow keys; the width is remembered. */
export function Resizer({ name, label, initial, min, max, side }: ResizerProperties) {
  const [width, setWidth] = useLocalStorage({
    key: `lanewright-${name}-width`,
    defaultValue: initial,
    getInitialValueInEffect: false,
  });
  const handle = useRef<HTMLDivElement>(null);
  const towardsMap = side === "left" ? 1 : -1;
  const set = (wanted: number) => setWidth(Math.round(Math.min(max, Math.max(min, wanted))));

  useLayoutEffect(() => {
    handle.current
      ?.closest<HTMLElement>("[data-workspace]")
      ?.style.setProperty(`--${name}-width`, `${width}px`);
  }, [name, width]);

  const drag = (event: PointerEvent<HTMLDivElement>) => {
    if (event.currentTarget.hasPointerCapture(event.pointerId)) set(width + event.movementX * towardsMap);
  };
  const step = (event: KeyboardEvent) => {
    const by = event.key === "ArrowRight" ? 16 : event.key === "ArrowLeft" ? -16 : 0;
    if (by === 0) return;
    event.preventDefault();
    set(width + by * towardsMap);
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that is moved, not a rule between paragraphs
    <div
      ref={handle}
      className={classes.resizer}
      data-side={side}
      role="separator"
      aria-orientation="vertical"
      aria-label={label}
      aria-valuenow={width}
      aria-valuemin={min}
      aria-valuemax={max}
      tabIndex={0}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={drag}
      onKeyDown={step}
      onDoubleClick={() => set(initial)}
    />
  );
}
