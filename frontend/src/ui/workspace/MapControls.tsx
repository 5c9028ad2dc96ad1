import { SegmentedControl, Slider, Switch } from "@mantine/core";
import type { MapViewMode } from "../../map";
import { useScreen, useWorkspace } from "./context";
import classes from "./workspace.module.css";

const VIEWS: { value: MapViewMode; label: string }[] = [
  { value: "prior", label: "Prior" },
  { value: "current", label: "Current" },
  { value: "difference", label: "Difference" },
];

/** What the map shows: the state of the world, the lidar image under it, the direction arrows. */
export function MapControls() {
  const { workspace, screen } = useWorkspace();
  const view = useScreen((state) => state.view);
  const opacity = useScreen((state) => state.lidarOpacity);
  const arrows = useScreen((state) => state.arrows);
  return (
    <div className={classes.controls}>
      <SegmentedControl
        aria-label="State of the world"
        size="xs"
        data={VIEWS}
        value={view}
        onChange={(value) => screen.setState({ view: value })}
      />
      <div className={classes.floating}>
        <Switch
          size="xs"
          label="Arrows"
          checked={arrows}
          onChange={(event) => screen.setState({ arrows: event.currentTarget.checked })}
        />
        {workspace.lidar === null ? (
          <span className="third">no lidar image</span>
        ) : (
          <span className={classes.opacity}>
            Lidar
            <Slider
              thumbLabel="Opacity of the lidar image"
              size="xs"
              w={84}
              min={0}
              max={100}
              label={(value) => `${value} %`}
              value={Math.round(opacity * 100)}
              onChange={(value) => screen.setState({ lidarOpacity: value / 100 })}
            />
          </span>
        )}
      </div>
    </div>
  );
}
