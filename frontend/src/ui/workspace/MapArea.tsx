import { useComputedColorScheme } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useCallback, useMemo, useState } from "react";
import { getDrive } from "../../api/workspace";
import { type KeyText, keyText } from "../../editor";
import { type MapHandle, type MapMarker, MapView, type MapViewMode } from "../../map";
import { useScreen, useWorkspace } from "./context";
import { MapControls } from "./MapControls";
import { MapUnavailable } from "./MapUnavailable";
import { NewerDraft } from "./NewerDraft";
import type { Commands } from "./useCommands";
import { useFindings } from "./useFindings";
import classes from "./workspace.module.css";

/** The state that the flicker key shows instead of the one on the screen. */
const OTHER: Record<MapViewMode, MapViewMode> = { difference: "prior", current: "prior", prior: "current" };

export function MapArea({ commands }: { commands: Commands }) {
  const { workspace, editor, mapRef, screen } = useWorkspace();
  const { findings } = useFindings();
  const theme = useComputedColorScheme("dark");
  const view = useScreen((state) => (state.flicker ? OTHER[state.view] : state.view));
  const lidarOpacity = useScreen((state) => state.lidarOpacity);
  const arrows = useScreen((state) => state.arrows);
  const frame = useScreen((state) => state.frame);
  const [unavailable, setUnavailable] = useState<string | null>(null);
  /** A map that has just come up turns to what is selected, e.g. by the address. */
  const attach = useCallback(
    (handle: MapHandle | null) => {
      mapRef.current = handle;
      const { selection } = editor.getState();
      if (selection !== null) handle?.fitElement(selection);
    },
    [mapRef, editor],
  );
  const drive = useQuery({
    queryKey: ["drive", workspace.task.id],
    queryFn: () => getDrive(workspace.task.id),
    staleTime: Number.POSITIVE_INFINITY,
  });
  const frames = drive.data?.frames.length ?? 0;
  const categories = useMemo(
    () =>
      findings === null
        ? null
        : new Map<KeyText, readonly string[]>(
            findings.changes.map((change) => [keyText(change), change.categories]),
          ),
    [findings],
  );
  const violations = useMemo(
    () =>
      (findings?.violations ?? [])
        .filter(({ inherited }) => !inherited)
        .flatMap(({ kind, elements, severity }) =>
          severity === "none" ? [] : elements.map((id): MapMarker => ({ key: { kind, id }, severity })),
        ),
    [findings],
  );
  return (
    <main className={classes.map} aria-label="Map">
      {unavailable === null ? (
        <MapView
          ref={attach}
          editor={editor}
          frame={workspace.frame}
          bounds={workspace.bounds}
          drivableAreas={workspace.drivable_areas}
          direction={workspace.task.direction}
          view={view}
          lidar={workspace.lidar}
          lidarOpacity={lidarOpacity}
          drive={drive.data ?? null}
          activeFrame={frame === null ? null : Math.min(frame, Math.max(0, frames - 1))}
          onFrame={(index) => screen.setState({ frame: index })}
          categories={categories}
          violations={violations}
          arrows={arrows}
          theme={theme}
          onCommand={commands.run}
          onUnavailable={setUnavailable}
        />
      ) : (
        <MapUnavailable reason={unavailable} onRetry={() => setUnavailable(null)} />
      )}
      <MapControls />
      <NewerDraft />
    </main>
  );
}
