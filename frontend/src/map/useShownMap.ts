import { useEffect, useMemo } from "react";
import { useStore } from "zustand";
import { baseCutAlike } from "../editor";
import type { Shown } from "./layers";
import type { MapController } from "./mapController";
import type { MapViewProperties } from "./properties";

/** Hands the map what it has to show, each part when it changes. */
export function useShownMap(
  controller: MapController | null,
  properties: MapViewProperties,
  shown: Shown,
): void {
  const { editor, categories, lidar = null, lidarOpacity = 0.6, arrows = true } = properties;
  const { drivableAreas, drive = null, theme = "dark" } = properties;
  const imported = useStore(editor, (state) => state.base);
  const current = useStore(editor, (state) => state.current);
  const base = useMemo(() => baseCutAlike(imported, current), [imported, current]);
  const quick = useStore(editor, (state) => state.changedKeys);
  const colours = categories ?? quick;

  useEffect(() => controller?.setTheme(theme), [controller, theme]);
  useEffect(() => controller?.setElements(base, current, colours), [controller, base, current, colours]);
  useEffect(() => controller?.setDrivableAreas(drivableAreas), [controller, drivableAreas]);
  useEffect(() => controller?.setDrive(drive), [controller, drive]);
  useEffect(() => controller?.setLidar(lidar, lidarOpacity), [controller, lidar, lidarOpacity]);
  const overImage = lidar !== null && lidarOpacity > 0;
  useEffect(() => controller?.setLook({ shown, overImage, arrows }), [controller, shown, overImage, arrows]);
}
